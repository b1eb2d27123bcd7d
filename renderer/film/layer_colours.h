#pragma once

#include "renderer/film/film.h"
#include "renderer/film/tone.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>

namespace asos {

/// The values between which a layer's colours run.
struct LayerScale {
  glm::vec3 lo{0.0f};  ///< of each channel
  glm::vec3 hi{1.0f};

  /// Returns the position of a value of channel c on the scale, 0 to 1.
  [[nodiscard]] float at(float value, int c = 0) const;
  bool operator==(const LayerScale&) const = default;
};

/// Returns whether the layer has one value per pixel, displayed by a colour scale.
[[nodiscard]] bool is_scalar(Layer layer);
/// Returns the range of a layer's finite values in the film; 0 to 1 for colours, alpha and ids, -1
/// to 1 for normals. For lengths it leaves out the smallest and the largest 5 %.
[[nodiscard]] LayerScale layer_scale(const Film& film, Layer layer);
/// One pixel's values in a layer.
struct LayerValues {
  std::array<float, 3> values{};
  std::size_t count = 0;
};
/// Returns the film's values of a layer at a pixel; none for ids, and if the film has no such
/// layer.
[[nodiscard]] LayerValues layer_values(const Film& film, Layer layer, std::size_t pixel);

/// Returns the colour of a pixel of the layer, sRGB bytes: emission by `display`, other colours
/// without it, vectors by `scale`, single values by heat_colour, ids by their colours, mixed by
/// share. Black: no value.
[[nodiscard]] glm::u8vec3 layer_colour(const Film& film, Layer layer, std::size_t pixel,
                                       const LayerScale& scale, const DisplayTransform& display);
/// Returns the colour of an id.
[[nodiscard]] glm::u8vec3 id_colour(std::uint32_t id);

/// Returns the name of an id; "": it has none.
using NameOfId = std::function<std::string(std::uint32_t)>;
/// Returns the pixel's values with their unit: "3.25 m", "left 75 %, right 25 %". `name` returns
/// the names of ids, or is empty.
[[nodiscard]] std::string layer_words(const Film& film, Layer layer, std::size_t pixel,
                                      const NameOfId& name = {});
/// Returns a value and the layer's unit.
[[nodiscard]] std::string with_unit(float value, Layer layer);

}  // namespace asos
