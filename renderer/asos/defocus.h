#pragma once

#include "renderer/geometry/view.h"
#include "renderer/prepared/viewer.h"
#include "renderer/pyray/allowance.h"
#include "renderer/samples/block_job.h"

#include <cstdint>
#include <vector>

namespace asos {

/// How the camera's lens blurs the pixels of a block, by the depth of what their centres show.
/// Distances across the picture are in pixels.
class Defocus {
 public:
  struct Pixel {
    double radius = 0.0;    ///< of the circle of confusion at the centre's depth
    double most = 0.0;      ///< the largest over the square that `reach` searches
    bool searched = false;  ///< `most` is within reach
  };

  /// Casts a ray through the centre of each of side x side pixels from the job's block on.
  /// `viewer`: the camera. The job and the viewer have to outlive this.
  Defocus(const BlockJob& job, const Viewer& viewer, int side);

  /// The widest that boundaries are searched for around a pixel.
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] const Pixel& pixel(std::uint32_t root) const { return pixels_[root]; }
  /// Whether a circle of confusion changes no pixel by more than EPS.
  [[nodiscard]] bool is_sharp(double radius) const { return radius <= sharpest_; }
  [[nodiscard]] bool is_sharp_at(double depth) const { return is_sharp(view_->confusion(depth)); }
  /// Whether no boundary lies so near to the lens that its circle of confusion is larger than the
  /// pixel's. Conservative.
  [[nodiscard]] bool nothing_nearer(std::uint32_t root) const;
  /// The side of a square with the second moments of the pixel and its circle of confusion, or of
  /// the largest that is searched.
  [[nodiscard]] double leaf_side(std::uint32_t root) const;
  /// The allowance of a sampled pixel. It refines, even where the settings do not.
  [[nodiscard]] const Allowance& allowance() const { return allowance_; }

 private:
  void measure(const RenderScene& scene, const Ray& ray, const Hit& hit, Pixel& pixel) const;
  [[nodiscard]] Box far_end(std::uint32_t root) const;
  [[nodiscard]] bool meets_boundary(const Box& far_end) const;

  const RenderScene* scene_;
  const View* view_;
  PixelSpacing spacing_;
  glm::dvec3 eye_;
  PixelRect block_;
  int side_;
  double width_;
  Allowance allowance_;
  double sharpest_;
  bool even_background_;
  double reach_ = 0.0;
  bool may_meet_ = true;  // some pixel's cone meets a boundary
  std::vector<Pixel> pixels_;
};

}  // namespace asos
