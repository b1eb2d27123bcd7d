#pragma once

#include "renderer/geometry/pixel_rect.h"
#include "renderer/result.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asos {

/// A quantity of each pixel that a picture's file may hold in addition to its radiance.
enum class Layer : std::uint8_t {
  beauty,
  alpha,
  albedo,
  direct,
  emission,
  reflection,
  transmission,
  background,
  position,
  depth,
  distance,
  normal,
  geometric_normal,
  uv,
  object,
  material,
  level,
  cause,
  rays,
  time,
  error,
};
inline constexpr int layer_count = static_cast<int>(Layer::error) + 1;

/// How a layer's value of a pixel follows from the parts of the pixel.
enum class LayerFilter : std::uint8_t {
  mean,      ///< area-weighted mean; the background counts as 0
  nearest,   ///< value at the sample that is nearest to the eye
  coverage,  ///< fraction of the pixel's area, for each id
  pixel,     ///< one value for the pixel as a whole
};

/// A row of the table of all layers.
struct LayerRow {
  Layer value = Layer::beauty;
  const char* name = "";      ///< on the command line, and in EXR channels before the dot
  const char* title = "";     ///< in the window
  const char* channels = "";  ///< one letter each: "RGB"; of ids none
  LayerFilter filter = LayerFilter::pixel;
  const char* unit = "";  ///< "1": a ratio
  const char* about = "";

  [[nodiscard]] bool holds_ids() const { return filter == LayerFilter::coverage; }
  /// Returns whether the layer follows from surfaces, not from the method.
  [[nodiscard]] bool of_surfaces() const {
    return filter != LayerFilter::pixel && value != Layer::beauty;
  }
  [[nodiscard]] std::size_t channel_count() const { return std::string_view(channels).size(); }
};
[[nodiscard]] std::span<const LayerRow> layer_table();
[[nodiscard]] const LayerRow& row_of(Layer layer);
[[nodiscard]] const char* name_of(LayerFilter filter);

/// A set of layers.
class LayerSet {
 public:
  constexpr LayerSet() = default;
  constexpr LayerSet(std::initializer_list<Layer> layers) {
    for (const Layer layer : layers) insert(layer);
  }
  [[nodiscard]] static LayerSet all();
  constexpr void insert(Layer layer) { bits_ |= bit(layer); }
  constexpr void erase(Layer layer) { bits_ &= ~bit(layer); }
  [[nodiscard]] constexpr bool has(Layer layer) const { return (bits_ & bit(layer)) != 0; }
  [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
  /// Returns the set's layers in table order.
  [[nodiscard]] std::vector<Layer> layers() const;
  /// Returns whether a layer of the set follows from the surfaces that a pixel shows.
  [[nodiscard]] bool of_surfaces() const;
  /// Whether one of them is a part of the radiance (LightPart).
  [[nodiscard]] constexpr bool of_light() const {
    return has(Layer::direct) || has(Layer::emission) || has(Layer::reflection) ||
           has(Layer::transmission) || has(Layer::background);
  }
  [[nodiscard]] bool has_ids() const { return has(Layer::object) || has(Layer::material); }
  bool operator==(const LayerSet&) const = default;

 private:
  static constexpr std::uint32_t bit(Layer layer) {
    return std::uint32_t{1} << static_cast<unsigned>(layer);
  }
  std::uint32_t bits_ = 0;
};

/// Reads "depth,normal" or "all". Errors: an unknown name, an empty list.
[[nodiscard]] Result<LayerSet> parse_layers(std::string_view text);
/// Returns a set's text for parse_layers.
[[nodiscard]] std::string text_of(LayerSet layers);

/// The id of the background.
inline constexpr std::uint32_t no_id = 0xffffffffu;

/// The fraction of a pixel that one object or material covers.
struct IdShare {
  std::uint32_t id = no_id;  ///< index of the object or material
  float share = 0.0f;
  bool operator==(const IdShare&) const = default;
};
/// All ids of a pixel, including the background: largest share first, equal shares by id. Shares
/// add up to 1.
using IdShares = std::vector<IdShare>;

/// The values of one layer over a rectangle of pixels, row-major. Layers that a Film has by name
/// (beauty, level, cause, rays, time) have no plane.
struct LayerPlane {
  Layer layer = Layer::alpha;
  std::vector<float> values;  ///< channels of a pixel side by side
  std::vector<IdShares> ids;  ///< in place of values, for ids

  LayerPlane() = default;
  /// Makes a plane of so many pixels: zeros, the background, infinite depths and errors.
  LayerPlane(Layer of, std::size_t pixels);
  /// The pixel's values; empty for ids.
  [[nodiscard]] std::span<const float> at(std::size_t pixel) const {
    const std::size_t n = row_of(layer).channel_count();
    return std::span(values).subspan(pixel * n, n);
  }
};

/// Returns whether the layer has a plane of its own in tiles and films.
[[nodiscard]] bool has_plane(Layer layer);
[[nodiscard]] std::vector<LayerPlane> blank_planes(LayerSet layers, std::size_t pixels);
/// Returns the layer's plane; null: none.
[[nodiscard]] const LayerPlane* find_plane(std::span<const LayerPlane> planes, Layer layer);
/// Copies the pixels that two rectangles share, of each layer that both have.
void copy_planes(std::span<const LayerPlane> from, const PixelRect& from_rect,
                 std::span<LayerPlane> to, const PixelRect& to_rect);

}  // namespace asos
