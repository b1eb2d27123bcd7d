#pragma once

#include "ui/split_check.h"
#include "ui/stoppable_job.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace asos::ui {

class Previewer;

/// Finds the outline of objects in the picture in the background. All members must be called from
/// one thread.
class SelectionOutline {
 public:
  /// Call once a frame. `parts`: ascending indices into World::parts; empty: none.
  void update(const Previewer& previewer, std::vector<int> parts);
  /// The pixels of the outline in the current view; empty: unknown yet, or nothing is seen.
  [[nodiscard]] const std::vector<PixelRun>& runs() const { return runs_; }
  [[nodiscard]] bool busy() const { return job_.pending(); }

 private:
  struct Subject {
    std::shared_ptr<const Geometry> geometry;
    std::uint64_t camera_revision = 0;
    glm::ivec2 size{0};
    std::vector<int> parts;
    bool operator==(const Subject&) const = default;
  };
  std::optional<Subject> subject_;  // of the job
  std::vector<PixelRun> runs_;
  StoppableJob<std::vector<PixelRun>> job_;
};

/// The pixels at the border of a mask of `width` pixels per row: inside, with a neighbour outside,
/// or the reverse.
[[nodiscard]] std::vector<PixelRun> border_of(const std::vector<std::uint8_t>& mask, int width);

}  // namespace asos::ui
