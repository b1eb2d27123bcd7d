#pragma once

#include "renderer/kernels/light_kernel.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/samples/recycled.h"
#include "renderer/shading/light_transport.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// What each of many lights carries at most by way of some places, if nothing shades it: what tells
/// how many rays they are worth.
class CarriedLight {
 public:
  /// So many places of each light tell: its middle may lie below a surface that the rest shines on.
  static constexpr std::size_t places_a_light = 4;

  /// The lights have to outlive this.
  explicit CarriedLight(std::span<const PreparedLight> lights);

  /// Forgets the places so far.
  void start() { points_->count = 0; }
  /// Another one, as long as there is room.
  void add(const LitPoint& point);
  /// In display units, by light. Those of one part hide each other: they count for as many as its
  /// two sides show at once.
  [[nodiscard]] const std::vector<double>& most();
  /// What all of them carry together at most by way of a white wall there, as far as they are small
  /// beside their distances.
  [[nodiscard]] double by_white_walls(glm::vec3 position) const;
  /// Whether a place is so close to one of the lights that this alone may carry so much, by way of
  /// a white wall that faces it.
  [[nodiscard]] bool near(glm::vec3 position, double carried) const;

 private:
  struct Light {
    LightConstants constants;
    double brightest;    ///< the most that a surface makes of it; at most white
    glm::vec3 position;  ///< its middle
    float reach2;        ///< what it carries, times the squared distance to its middle
  };
  struct Part {
    double all = 0.0, most = 0.0;
  };

  void hide_each_other();

  std::vector<Light> lights_;
  std::vector<std::size_t> part_of_light_;  // its number in `parts_`, or none
  std::vector<Part> parts_;
  Recycled<LitBatch> points_;
  Recycled<LightPlaceBatch> places_;
  Recycled<ShadowRayBatch> rays_;
  std::vector<double> most_;
};

}  // namespace asos
