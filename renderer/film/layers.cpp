#include "renderer/film/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <string>

namespace asos {
namespace {

constexpr std::array<LayerRow, layer_count> layer_rows{{
    {Layer::beauty, "beauty", "Radiance", "RGB", LayerFilter::mean, "linear radiance",
     "The picture; always written"},
    {Layer::alpha, "alpha", "Alpha", "A", LayerFilter::mean, "1",
     "Share of the pixel that surfaces hide"},
    {Layer::albedo, "albedo", "Albedo", "RGB", LayerFilter::mean, "1",
     "Base colour, of unlit surfaces too"},
    {Layer::direct, "direct", "Direct light", "RGB", LayerFilter::mean, "linear radiance",
     "Light of lamps and sky that surfaces scatter"},
    {Layer::emission, "emission", "Emission", "RGB", LayerFilter::mean, "linear radiance",
     "Light that surfaces send out, unlit ones too"},
    {Layer::reflection, "reflection", "Reflection", "RGB", LayerFilter::mean, "linear radiance",
     "Light along reflected rays"},
    {Layer::transmission, "transmission", "Transmission", "RGB", LayerFilter::mean,
     "linear radiance", "Light along refracted rays"},
    {Layer::background, "background", "Background", "RGB", LayerFilter::mean, "linear radiance",
     "Background behind all surfaces"},
    {Layer::position, "position", "Position", "XYZ", LayerFilter::nearest, "m",
     "Position in the scene's coordinates"},
    {Layer::depth, "depth", "Depth", "Z", LayerFilter::nearest, "m",
     "Distance along the camera's axis; infinite: background"},
    {Layer::distance, "distance", "Distance", "Z", LayerFilter::nearest, "m",
     "Distance from the camera; infinite: background"},
    {Layer::normal, "normal", "Shading normal", "XYZ", LayerFilter::mean, "1",
     "Shading normal, unit, in scene axes"},
    {Layer::geometric_normal, "geometric_normal", "Geometric normal", "XYZ", LayerFilter::mean, "1",
     "Normal of the triangle or shape, unit"},
    {Layer::uv, "uv", "Texture coordinates", "UV", LayerFilter::nearest, "1",
     "Texture coordinates of the base colour"},
    {Layer::object, "object", "Object", "", LayerFilter::coverage, "1",
     "Coverage of each object (Cryptomatte)"},
    {Layer::material, "material", "Material", "", LayerFilter::coverage, "1",
     "Coverage of each material (Cryptomatte)"},
    {Layer::level, "level", "Level", "V", LayerFilter::pixel, "levels",
     "Deepest level of the split"},
    {Layer::cause, "cause", "Cause", "V", LayerFilter::pixel, "number",
     "Cause of the split; 0: not split"},
    {Layer::rays, "rays", "Rays", "V", LayerFilter::pixel, "rays", "Rays cast for the pixel"},
    {Layer::time, "time", "Time", "V", LayerFilter::pixel, "s", "Processor time of the pixel"},
    {Layer::error, "error", "Error estimate", "V", LayerFilter::pixel, "display intensity",
     "Estimated error of the pixel; 1 is white, infinite: unknown"},
}};

static_assert([] {
  for (std::size_t i = 0; i < layer_rows.size(); ++i)
    if (layer_rows[i].value != static_cast<Layer>(i)) return false;
  return true;
}());

// Earlier pictures and commands spell names of two words with a hyphen.
bool is_name_of(const LayerRow& layer, std::string_view name) {
  std::string spelled(name);
  std::replace(spelled.begin(), spelled.end(), '-', '_');
  return spelled == layer.name;
}

template <typename T>
void copy_rows(const std::vector<T>& from, const PixelRect& from_rect, std::vector<T>& to,
               const PixelRect& to_rect, std::size_t channels) {
  if (from.empty() || to.empty()) return;
  const PixelRect shared = intersection(from_rect, to_rect);
  const auto index = [&](const PixelRect& rect, int y) {
    return static_cast<std::ptrdiff_t>(channels) *
           (static_cast<std::ptrdiff_t>(y - rect.y) * rect.width + (shared.x - rect.x));
  };
  for (int y = shared.y; y < shared.y + shared.height; ++y)
    std::copy_n(from.begin() + index(from_rect, y),
                channels * static_cast<std::size_t>(shared.width), to.begin() + index(to_rect, y));
}

}  // namespace

std::span<const LayerRow> layer_table() {
  return layer_rows;
}

const LayerRow& row_of(Layer layer) {
  return layer_rows[static_cast<std::size_t>(layer)];
}

const char* name_of(LayerFilter filter) {
  switch (filter) {
    case LayerFilter::mean:
      return "mean";
    case LayerFilter::nearest:
      return "nearest";
    case LayerFilter::coverage:
      return "coverage";
    case LayerFilter::pixel:
      break;
  }
  return "pixel";
}

LayerSet LayerSet::all() {
  LayerSet set;
  for (const LayerRow& row : layer_rows) set.insert(row.value);
  return set;
}

std::vector<Layer> LayerSet::layers() const {
  std::vector<Layer> found;
  for (const LayerRow& row : layer_rows)
    if (has(row.value)) found.push_back(row.value);
  return found;
}

bool LayerSet::of_surfaces() const {
  return std::any_of(layer_rows.begin(), layer_rows.end(),
                     [&](const LayerRow& row) { return row.of_surfaces() && has(row.value); });
}

Result<LayerSet> parse_layers(std::string_view text) {
  LayerSet set;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(',', from), text.size());
    const std::string_view name = text.substr(from, end - from);
    from = end + 1;
    if (name == "all") {
      for (const LayerRow& layer : layer_rows) set.insert(layer.value);
      continue;
    }
    const auto row = std::find_if(layer_rows.begin(), layer_rows.end(),
                                  [&](const LayerRow& layer) { return is_name_of(layer, name); });
    if (row == layer_rows.end()) {
      std::string names;
      for (const LayerRow& layer : layer_rows) names += fmt::format(", {}", layer.name);
      return unexpected(Error{fmt::format("\"{}\"", name), "is no layer; there are all" + names});
    }
    set.insert(row->value);
  }
  return set;
}

std::string text_of(LayerSet layers) {
  std::string text;
  for (const Layer layer : layers.layers())
    text += fmt::format("{}{}", text.empty() ? "" : ",", row_of(layer).name);
  return text;
}

LayerPlane::LayerPlane(Layer of, std::size_t pixels) : layer(of) {
  const LayerRow& row = row_of(of);
  if (row.holds_ids()) {
    ids.assign(pixels, {{no_id, 1.0f}});
    return;
  }
  const bool infinite = of == Layer::depth || of == Layer::distance || of == Layer::error;
  values.assign(pixels * row.channel_count(),
                infinite ? std::numeric_limits<float>::infinity() : 0.0f);
}

bool has_plane(Layer layer) {
  return row_of(layer).of_surfaces() || layer == Layer::error;
}

std::vector<LayerPlane> blank_planes(LayerSet layers, std::size_t pixels) {
  std::vector<LayerPlane> planes;
  for (const Layer layer : layers.layers())
    if (has_plane(layer)) planes.emplace_back(layer, pixels);
  return planes;
}

const LayerPlane* find_plane(std::span<const LayerPlane> planes, Layer layer) {
  const auto found = std::find_if(planes.begin(), planes.end(),
                                  [&](const LayerPlane& plane) { return plane.layer == layer; });
  return found == planes.end() ? nullptr : &*found;
}

void copy_planes(std::span<const LayerPlane> from, const PixelRect& from_rect,
                 std::span<LayerPlane> to, const PixelRect& to_rect) {
  for (LayerPlane& plane : to) {
    const LayerPlane* source = find_plane(from, plane.layer);
    if (!source) continue;
    copy_rows(source->values, from_rect, plane.values, to_rect,
              row_of(plane.layer).channel_count());
    copy_rows(source->ids, from_rect, plane.ids, to_rect, 1);
  }
}

}  // namespace asos
