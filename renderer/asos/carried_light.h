#pragma once

#include "renderer/kernels/weigh_lights.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/samples/recycled.h"
#include "renderer/shading/light_transport.h"

#include <cstddef>
#include <span>
#include <vector>

namespace asos {

/// What each of many lights carries at most by way of some places, if nothing shades it: what tells
/// how many rays they are worth. As exact as weigh_lights.
class CarriedLight {
 public:
  /// The lights have to outlive this.
  explicit CarriedLight(std::span<const PreparedLight> lights);

  /// Forgets the places so far.
  void start();
  /// Another one.
  void add(const LitPoint& point);
  /// In display units, by light. Those of one part hide each other: they count for as many as its
  /// two sides show at once.
  [[nodiscard]] std::vector<double> most() const;

 private:
  LightTable table_;
  std::vector<double> brightest_;           // the most that a surface makes of each; at most white
  std::vector<std::size_t> part_of_light_;  // its number, or none
  std::size_t parts_ = 0;
  Recycled<LitBatch> point_;
  std::vector<float> worth_;  // at one place
  std::vector<float> most_;   // at any
};

}  // namespace asos
