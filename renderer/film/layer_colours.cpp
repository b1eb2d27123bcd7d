#include "renderer/film/layer_colours.h"

#include "renderer/film/split_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace asos {
namespace {

bool is_radiance(Layer layer) {
  return layer == Layer::beauty || LayerSet{layer}.of_light();
}

bool shows_colour(Layer layer) {
  return layer == Layer::albedo || is_radiance(layer);
}

bool is_normal(Layer layer) {
  return layer == Layer::normal || layer == Layer::geometric_normal;
}

glm::u8vec3 bytes_of_shares(glm::vec3 share) {
  return glm::u8vec3(255.0f * glm::clamp(share, 0.0f, 1.0f) + 0.5f);
}

glm::u8vec3 mixed_ids(const IdShares& shares) {
  glm::vec3 sum(0.0f);
  for (const IdShare& share : shares) sum += share.share * glm::vec3(id_colour(share.id));
  return glm::u8vec3(glm::min(sum + 0.5f, 255.0f));
}

std::string id_words(const IdShares& shares, const char* kind, const NameOfId& name_of_id) {
  std::string words;
  for (const IdShare& share : shares) {
    std::string name = "background";
    if (share.id != no_id) {
      name = name_of_id ? printable(name_of_id(share.id)) : std::string();
      if (name.empty()) name = fmt::format("{} {}", kind, std::size_t{share.id} + 1);
    }
    words += fmt::format("{}{} {:.3g} %", words.empty() ? "" : ", ", name,
                         100.0 * static_cast<double>(share.share));
  }
  return words;
}

float nth_smallest(std::vector<float>& values, std::size_t n) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(n);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace

float LayerScale::at(float value, int c) const {
  if (!(hi[c] > lo[c])) return 0.0f;
  return std::clamp((value - lo[c]) / (hi[c] - lo[c]), 0.0f, 1.0f);
}

bool is_scalar(Layer layer) {
  return row_of(layer).channel_count() == 1;
}

LayerValues layer_values(const Film& film, Layer layer, std::size_t pixel) {
  const auto one = [](float value) { return LayerValues{{value}, 1}; };
  switch (layer) {
    case Layer::beauty: {
      const glm::vec3 c = film.radiance[pixel];
      return {{c.x, c.y, c.z}, 3};
    }
    case Layer::level:
      return one(static_cast<float>(film.split_level[pixel]));
    case Layer::cause:
      return one(static_cast<float>(film.cause[pixel]));
    case Layer::rays:
      return one(film.rays[pixel]);
    case Layer::time:
      return one(film.seconds[pixel]);
    default:
      break;
  }
  const LayerPlane* plane = find_plane(film.layers, layer);
  if (!plane || plane->values.empty()) return {};
  LayerValues found;
  for (const float value : plane->at(pixel)) found.values[found.count++] = value;
  return found;
}

LayerScale layer_scale(const Film& film, Layer layer) {
  LayerScale scale;
  if (shows_colour(layer) || row_of(layer).holds_ids() || layer == Layer::alpha) return scale;
  if (is_normal(layer)) {
    scale.lo = glm::vec3(-1.0f);
    return scale;
  }
  std::array<std::vector<float>, 3> finite;
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    const LayerValues found = layer_values(film, layer, i);
    for (std::size_t c = 0; c < found.count; ++c)
      if (std::isfinite(found.values[c])) finite[c].push_back(found.values[c]);
  }
  // A few pixels near the horizon are much farther than all others.
  const bool far_tail = row_of(layer).unit == std::string_view("m");
  for (int c = 0; c < 3; ++c) {
    std::vector<float>& values = finite[static_cast<std::size_t>(c)];
    if (values.empty()) continue;
    const std::size_t left_out = far_tail ? values.size() / 20 : 0;
    scale.lo[c] = nth_smallest(values, left_out);
    scale.hi[c] = nth_smallest(values, values.size() - 1 - left_out);
  }
  return scale;
}

glm::u8vec3 layer_colour(const Film& film, Layer layer, std::size_t pixel, const LayerScale& scale,
                         const DisplayTransform& display) {
  if (row_of(layer).holds_ids()) {
    const LayerPlane* plane = find_plane(film.layers, layer);
    return plane ? mixed_ids(plane->ids[pixel]) : glm::u8vec3(0);
  }
  const auto [values, count] = layer_values(film, layer, pixel);
  if (count == 0 || !std::isfinite(values[0])) return glm::u8vec3(0);
  if (count == 1) return heat_colour(scale.at(values[0]));
  const glm::vec3 value(values[0], values[1], values[2]);
  if (is_radiance(layer)) return display_bytes(value, display);
  if (shows_colour(layer)) return display_bytes(value, 0.0f);
  return bytes_of_shares({scale.at(value.x, 0), scale.at(value.y, 1), scale.at(value.z, 2)});
}

glm::u8vec3 id_colour(std::uint32_t id) {
  if (id == no_id) return glm::u8vec3(0);
  // Hues by the golden ratio, so that neighbours in number differ.
  const float hue = 6.2831853f * std::fmod(0.61803399f * static_cast<float>(id + 1), 1.0f);
  const auto channel = [&](float shift) { return 0.6f + 0.35f * std::cos(hue + shift); };
  return bytes_of_shares({channel(0.0f), channel(2.0943951f), channel(4.1887902f)});
}

std::string with_unit(float value, Layer layer) {
  const std::string unit = row_of(layer).unit;
  const std::string number = fmt::format("{:.4g}", value);
  return unit == "1" ? number : number + " " + unit;
}

std::string layer_words(const Film& film, Layer layer, std::size_t pixel, const NameOfId& name) {
  if (row_of(layer).holds_ids()) {
    const LayerPlane* plane = find_plane(film.layers, layer);
    return plane ? id_words(plane->ids[pixel], row_of(layer).name, name) : std::string();
  }
  if (layer == Layer::cause) return title_of(film.cause[pixel]);
  const auto [values, count] = layer_values(film, layer, pixel);
  if (count == 1) return with_unit(values[0], layer);
  std::string words;
  for (std::size_t c = 0; c < count; ++c)
    words += fmt::format("{}{:.4g}", words.empty() ? "" : ", ", values[c]);
  const std::string unit = row_of(layer).unit;
  return words.empty() || unit == "1" ? words : words + " " + unit;
}

}  // namespace asos
