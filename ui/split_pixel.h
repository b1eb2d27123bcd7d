#pragma once

#include "renderer/film/film.h"
#include "renderer/film/tone.h"
#include "renderer/session/render_session.h"
#include "ui/latest_job.h"

#include <glm/glm.hpp>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace asos::ui {

class Previewer;

/// Of the final pixels that were split deepest the one nearest to the middle, and rather such as
/// the bounds of objects split; none: nothing was split.
[[nodiscard]] std::optional<glm::ivec2> most_split_pixel(const Film& film);

/// Returns a pixel on an edge between two clearly different colours, each of which fills the two
/// pixels next to it; of those the one nearest to the middle. None: there is no such edge.
[[nodiscard]] std::optional<glm::ivec2> clear_edge_pixel(const Film& film,
                                                         const DisplayTransform& display);

/// Looks in the background for a pixel of the finished picture on which one sees what splitting is.
/// Edges that cut a pixel cleanly split none, and few pixels are left: of many from all over the
/// picture that are traced, those first that stand out from their neighbours, the one whose cells
/// are split most often and differ most; where none is split, one that edges cut. All members are
/// for one thread.
class SplitPixelSearch {
 public:
  /// A search ends then, with the best that it has seen.
  static constexpr std::chrono::seconds longest{3};

  SplitPixelSearch();
  ~SplitPixelSearch() { current_ = 0; }
  SplitPixelSearch(const SplitPixelSearch&) = delete;
  SplitPixelSearch& operator=(const SplitPixelSearch&) = delete;

  struct Answer {
    std::optional<glm::ivec2> pixel;
    bool none_split = false;  ///< of all that were looked at: this one is cut, or there is none
  };
  /// Call once a frame: what is known of the picture as it is. `wanted`: whether to look.
  Answer update(const Previewer& previewer, bool wanted);
  [[nodiscard]] bool busy() const { return job_.pending(); }

 private:
  struct Request {
    Snapshot picture;
    std::vector<glm::ivec2> candidates;
    std::uint64_t restarts = 0;
  };
  struct Found {
    std::optional<glm::ivec2> pixel;
    bool split = false;
    std::uint64_t restarts = 0;
  };
  [[nodiscard]] Found work(const Request& request) const;

  std::atomic<std::uint64_t> current_ = 0;  // restarts of the picture: others are given up
  std::uint64_t asked_ = 0;                 // about the picture of so many restarts
  Found found_;
  LatestJob<Request, Found> job_;
};

}  // namespace asos::ui
