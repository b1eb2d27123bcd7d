#pragma once

#include "renderer/geometry/view.h"
#include "renderer/prepared/view_context.h"
#include "renderer/pyray/error_budget.h"
#include "renderer/samples/block_job.h"

#include <cstdint>
#include <vector>

namespace asos {

/// The blur of a block's pixels by the camera's lens, from the depth at each pixel's centre.
/// Distances across the picture are in pixels.
class Defocus {
 public:
  struct Pixel {
    double radius = 0.0;    ///< radius of the circle of confusion at the centre's depth
    double most = 0.0;      ///< largest radius within this distance of the pixel
    bool searched = false;  ///< boundaries are searched within `most`; else sampled
  };

  /// Casts a ray through the centre of each of side x side pixels, starting at the job's block.
  /// `viewer` is the camera. The job and the viewer have to outlive this object.
  Defocus(const BlockJob& job, const ViewContext& viewer, int side);

  /// Returns the widest search for boundaries around a pixel, in pixels.
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] const Pixel& pixel(std::uint32_t root) const { return pixels_[root]; }
  /// Returns whether a circle of confusion of this radius changes no pixel by more than EPS.
  [[nodiscard]] bool is_sharp(double radius) const { return radius <= sharpest_; }
  [[nodiscard]] bool is_sharp_at(double depth) const { return is_sharp(view_->confusion(depth)); }
  /// Returns whether no boundary in the pixel's cone is so near the lens that its circle of
  /// confusion exceeds the pixel's `most`. Conservative: false if unsure.
  [[nodiscard]] bool nothing_nearer(std::uint32_t root) const;
  /// Returns whether rays at the border of the search region meet no larger circle of confusion
  /// than `most`, as on a plane. Meshes may bend away from the plane of the centre's triangle.
  [[nodiscard]] bool stays_within_reach(std::uint32_t root, RenderStatistics& counts) const;
  /// Returns the side of a square with the second moments of the pixel convolved with its circle of
  /// confusion. The circle is limited to the search radius.
  [[nodiscard]] double leaf_side(std::uint32_t root) const;
  /// Returns the allowance of a sampled pixel, with refine_shading even if the settings lack it.
  [[nodiscard]] const ErrorBudget& error_budget() const { return error_budget_; }

 private:
  void measure(const RenderScene& scene, const Ray& ray, const Hit& hit, Pixel& pixel) const;
  [[nodiscard]] Box far_end(std::uint32_t root) const;
  [[nodiscard]] bool meets_boundary(const Box& far_end) const;

  const RenderScene* scene_;
  const View* view_;
  Culling faces_;
  PixelSpacing spacing_;
  glm::dvec3 eye_;
  PixelRect block_;
  int side_;
  double width_;
  ErrorBudget error_budget_;
  double sharpest_;
  bool even_background_;
  double reach_ = 0.0;
  bool may_meet_ = true;  // some pixel's cone meets a boundary
  std::vector<Pixel> pixels_;
};

}  // namespace asos
