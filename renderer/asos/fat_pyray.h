#pragma once

#include "renderer/asos/eye_caster.h"
#include "renderer/asos/pixel_trace.h"
#include "renderer/comparison/method.h"
#include "renderer/pyray/detection.h"
#include "renderer/pyray/hit_list.h"
#include "renderer/pyray/subdivide.h"

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace asos {

/// Memory of fat pyrays that is worth keeping from one to the next. Holds no result.
struct FatPyrayWorkspace {
  HitLists lists;
  Subdivider subdivider;
  EyeWorkspace eye;
  std::array<HitLists::List, 5> descent;  // one for each size: 1, 2, 4, 8, 16 pixels
  std::vector<HitLists::List> pixel_list;
  HitLists::List scratch;
  std::vector<glm::vec2> centres;
  std::vector<Root> roots;
  std::vector<Root> split_roots;
};

/// A pyray around fat x fat pixels (CGF'98 section 6.4), which fetches its boundaries once and
/// hands them down to its pixels, which subdivide. Pixels that no boundary crosses take one sample.
/// A pixel's pyray goes through the square that its filter covers, which may be larger than the
/// pixel and overlap its neighbours' (CGF'98 section 3).
class FatPyray {
 public:
  /// `block` is aligned to settings.asos.fat, and clipped to the picture.
  FatPyray(const RenderScene& scene, const View& view, const RenderSettings& settings,
           PixelRect block, const std::stop_token& stop, FatPyrayWorkspace& work);

  /// Renders it, once.
  [[nodiscard]] BlockResult run();
  /// The same, telling how the pixel `into.x`, `into.y` of the picture was subdivided.
  [[nodiscard]] BlockResult run(PixelTrace& into);

 private:
  // Pixels by their place in the block, in rows of `fat`.
  [[nodiscard]] std::uint32_t index(int x, int y) const {
    return static_cast<std::uint32_t>(y * settings_.asos.fat + x);
  }
  /// What `size` x `size` pixels from (x, y) on are the means of.
  [[nodiscard]] Square square_of(int x, int y, int size) const;
  [[nodiscard]] Square pixel_square(int x, int y) const { return square_of(x, y, 1); }

  void look_through_centres();
  void descend(int x, int y, int size, const HitLists::List& parent);
  void find_missed_splits();
  void compare(int x0, int y0, int x1, int y1);
  [[nodiscard]] bool touches_boundary(int x, int y);
  void render_pixels();
  void subdivide_bounded();
  void publish();
  void publish_rays();
  void finish_trace();

  const RenderScene& scene_;
  const RenderSettings& settings_;
  PixelRect block_;
  PixelRect framed_;  // the block with what its pixels' detection may reach beyond it
  FatPyrayWorkspace& work_;
  Frame frame_;
  Detector detector_;
  BlockResult result_;
  Shader shader_;
  EyeCaster caster_;
  std::vector<SubdivisionOutcome> outcomes_;
  std::vector<std::uint8_t> bounded_;     // a boundary that may be visible crosses the pixel
  std::vector<std::uint8_t> by_samples_;  // splits by what its samples say
  std::vector<std::uint8_t> missed_;      // and should not have had to
  PixelTrace* trace_ = nullptr;
  SubdivisionTrace subdivision_;
  PyrayLog log_;
};

}  // namespace asos
