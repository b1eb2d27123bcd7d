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

  /// Where a value of channel c lies on it, 0 to 1.
  [[nodiscard]] float at(float value, int c = 0) const;
  bool operator==(const LayerScale&) const = default;
};

/// Whether the layer has one value a pixel, which a scale of colours explains.
[[nodiscard]] bool is_scalar(Layer layer);
/// The range of the finite values of a layer of the film; 0 to 1 of colours, alpha and ids.
[[nodiscard]] LayerScale layer_scale(const Film& film, Layer layer);
/// The channels of one pixel.
struct LayerValues {
  std::array<float, 3> values{};
  std::size_t count = 0;
};
/// The film's values of a layer at a pixel; none of ids, and where the film has no such layer.
[[nodiscard]] LayerValues layer_values(const Film& film, Layer layer, std::size_t pixel);

/// A pixel of the layer, sRGB bytes: colours as `display` shows them, one value by heat_colour, ids
/// in a colour of each, mixed by their shares. Black where there is nothing.
[[nodiscard]] glm::u8vec3 layer_colour(const Film& film, Layer layer, std::size_t pixel,
                                       const LayerScale& scale, const DisplayTransform& display);
/// The colour that stands for an id.
[[nodiscard]] glm::u8vec3 id_colour(std::uint32_t id);

/// Returns the name of an id; "": it has none.
using NameOfId = std::function<std::string(std::uint32_t)>;
/// The pixel's values with their unit: "3.25 m", "left 75 %, right 25 %". `name`: of ids, or empty.
[[nodiscard]] std::string layer_words(const Film& film, Layer layer, std::size_t pixel,
                                      const NameOfId& name = {});
/// A value with the layer's unit.
[[nodiscard]] std::string with_unit(float value, Layer layer);

}  // namespace asos
