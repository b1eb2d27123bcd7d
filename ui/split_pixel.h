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

/// Returns the most deeply split of the final pixels, nearest to the centre, and preferably one
/// split by an object's edge. None: no pixel was split.
[[nodiscard]] std::optional<glm::ivec2> most_split_pixel(const Film& film);

/// Which pixels clear_edge_pixel considers: all, or only final ones that an object's edge split.
enum class ClearEdge { any, split };
/// Returns the pixel nearest to the centre that is on an edge between two clearly different
/// colours; each must fill the two pixels next to it. None: there is no such edge.
[[nodiscard]] std::optional<glm::ivec2> clear_edge_pixel(const Film& film,
                                                         const DisplayTransform& display,
                                                         ClearEdge which = ClearEdge::any);
/// Returns whether a pixel is on such an edge.
[[nodiscard]] bool on_clear_edge(const Film& film, glm::ivec2 pixel,
                                 const DisplayTransform& display);

/// Searches in the background for a pixel of the finished picture that shows well how splitting
/// works. Most candidates are not split, because an edge cuts them cleanly. Traces many candidates,
/// those of highest contrast first, and picks the one with the most splits and contrast, or else
/// one that edges cut. All members must be called from one thread.
class SplitPixelSearch {
 public:
  /// CPU time limit of a search; it ends with the best pixel so far.
  static constexpr std::chrono::seconds longest{3};

  SplitPixelSearch();
  ~SplitPixelSearch() { current_ = 0; }
  SplitPixelSearch(const SplitPixelSearch&) = delete;
  SplitPixelSearch& operator=(const SplitPixelSearch&) = delete;

  struct Answer {
    std::optional<glm::ivec2> pixel;
    bool none_split = false;  ///< no traced pixel was split: `pixel` is cut by an edge, or none
  };
  /// Call once a frame. Returns the result for the current picture. `wanted`: whether to search.
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

  std::atomic<std::uint64_t> current_ = 0;  // restarts of the current picture
  std::uint64_t asked_ = 0;                 // restarts of the requested picture
  Found found_;
  LatestJob<Request, Found> job_;
};

}  // namespace asos::ui
