#pragma once

#include "renderer/film/film.h"
#include "renderer/film/tone.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// A picture that was put by, to compare with.
struct StoredFrame {
  std::string name;     ///< of the method and its quality, unlike all others: see snapshot_name
  std::string summary;  ///< how it was made, in a line
  Film film;
};

/// How a stored frame is shown beside the current picture.
enum class Comparison { none, wipe, flip, difference };

/// Pictures put by, `most` at most, and how one of them is compared.
struct Frames {
  static constexpr std::size_t most = 9;  ///< one for each number key

  std::vector<StoredFrame> stored;
  std::uint64_t revision = 0;  ///< grows when `stored` changes
  int chosen = 0;
  Comparison comparison = Comparison::none;
  float wipe = 0.5f;          ///< share of the picture's width that shows the current picture
  bool flipped = false;       ///< the stored frame is shown
  float scale_stops = -4.0f;  ///< the largest difference that is told, 2^scale_stops

  // Which comparison the errors are of.
  struct Measured {
    std::uint64_t restarts = 0;  ///< of the picture
    std::uint64_t revision = 0;
    int chosen = -1;
    bool finished = false;  ///< the picture is
    bool operator==(const Measured&) const = default;
  };
  Measured measured;
  double rmse = 0.0;  ///< of the picture against the chosen one; not a number: unknown
  std::vector<double> stored_rmse;  ///< of each stored one

  /// A frame as large as the picture: its own film, or that resampled, which is kept until another
  /// one is asked for. `index` is one of a stored frame.
  [[nodiscard]] const Film& at_size(int index, glm::ivec2 size);
  /// Keeps a picture, under this name or, where it is taken, with a number behind it; false where
  /// there are `most` already.
  bool store(const Film& film, std::string name, std::string summary);
  /// Shows a snapshot in place of the picture, or the picture again where it is shown already.
  void flip_to(int index);
  void remove(int index);
  /// The one to compare with; null where nothing is compared.
  [[nodiscard]] const StoredFrame* compared() const;

 private:
  struct Sized {
    std::uint64_t revision;
    int index;
    glm::ivec2 size;
    Film film;
  };
  std::optional<Sized> sized_;
};

/// The largest difference of two colours in any channel, as they are shown: 0 to 1.
[[nodiscard]] float difference_of(glm::vec3 a, glm::vec3 b, const DisplayTransform& display);
/// The same of one pixel of two pictures of one size.
[[nodiscard]] float difference_of(const Film& a, const Film& b, std::size_t pixel,
                                  const DisplayTransform& display);

}  // namespace asos::ui
