#pragma once

#include "renderer/film/film.h"
#include "renderer/film/tone.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// A snapshot: a picture that was stored for comparison.
struct StoredFrame {
  std::string name;     ///< the method and its quality, unique: see snapshot_name
  std::string summary;  ///< how it was made, in one line
  Film film;
  std::string file{};  ///< name of the scene's file without folder
};

/// The other picture of a comparison. `method`: a snapshot by another method.
enum class CompareWith { snapshot, method, reference };
/// How that is shown.
enum class Comparison { none, wipe, flip, difference, error };

/// The snapshots, `most` at most, and how one of them is compared.
struct Frames {
  static constexpr std::size_t most = 9;  ///< one for each number key

  std::vector<StoredFrame> stored;
  std::string shown_file;      ///< name of the open scene's file
  std::uint64_t revision = 0;  ///< grows when `stored` changes
  int chosen = 0;
  CompareWith with = CompareWith::snapshot;
  Comparison comparison = Comparison::none;
  float wipe = 0.5f;          ///< fraction of the picture's width that shows the current picture
  bool flipped = false;       ///< the other picture is shown
  float scale_stops = -4.0f;  ///< the difference that is drawn white: 2^scale_stops

  /// A reference of this view, that errors are measured against. `film` null: there is none, and
  /// they are differences from the chosen snapshot.
  struct Reference {
    std::shared_ptr<const Film> film;
    int samples = 0;             ///< per pixel
    std::uint64_t revision = 0;  ///< grows with each change
  };
  Reference reference;

  // The state that the RMSE values were measured for.
  struct Measured {
    std::uint64_t restarts = 0;  ///< of the picture
    std::uint64_t reference = 0;
    std::uint64_t revision = 0;
    int chosen = -1;
    bool finished = false;  ///< the picture was finished
    bool operator==(const Measured&) const = default;
  };
  Measured measured;
  double rmse = 0.0;                ///< of the picture; NaN: unknown
  std::vector<double> stored_rmse;  ///< of each snapshot

  static constexpr int the_reference = -1;  ///< in place of a snapshot's index
  /// Returns the film of snapshot `index`, or the reference, resampled to `size`. The result is
  /// valid until the next call.
  [[nodiscard]] const Film& at_size(int index, glm::ivec2 size);
  /// Stores a picture of the scene `shown_file` under this name, with a number added if the name is
  /// taken. Returns false if there are `most` snapshots already.
  bool store(const Film& film, std::string name, std::string summary);
  /// Returns a snapshot's name, after that of its file if it is not of `shown_file`.
  [[nodiscard]] std::string title(const StoredFrame& frame) const {
    return frame.file == shown_file ? frame.name : frame.file + ": " + frame.name;
  }
  /// Ends the comparison; the snapshots stay.
  void show_picture() {
    comparison = Comparison::none;
    flipped = false;
  }
  /// Shows a snapshot in place of the picture; shows the picture again if that snapshot is shown.
  void flip_to(int index);
  void remove(int index);
  /// Index of the snapshot that the comparison is with, or `the_reference`; none: no comparison, or
  /// there is none yet.
  [[nodiscard]] std::optional<int> compared() const;
  [[nodiscard]] const Film& film(int index) const;
  /// Names the picture that the comparison is with.
  [[nodiscard]] std::string compared_title() const;
  /// Whether the comparison covers the whole picture. An error dims it until the reference is
  /// known.
  [[nodiscard]] bool cover_picture() const {
    return comparison == Comparison::error ||
           (compared() && (comparison == Comparison::difference || flipped));
  }

 private:
  struct Sized {
    std::uint64_t revision;
    int index;
    glm::ivec2 size;
    Film film;
  };
  std::optional<Sized> sized_;
};

/// The largest difference of two displayed colours in any channel: 0 to 1.
[[nodiscard]] float difference_of(glm::vec3 a, glm::vec3 b, const DisplayTransform& display);
/// The same for one pixel of two pictures of equal size.
[[nodiscard]] float difference_of(const Film& a, const Film& b, std::size_t pixel,
                                  const DisplayTransform& display);

}  // namespace asos::ui
