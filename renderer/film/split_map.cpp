#include "renderer/film/split_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asos {

namespace {

std::uint8_t cost_value(const CostScale& scale, float cost) {
  if (!(cost > 0.0f)) return 0;
  return static_cast<std::uint8_t>(1.0 +
                                   std::round(254.0 * scale.share(static_cast<double>(cost))));
}

// Films that were read from files have none.
std::uint32_t samples_at(const Film& film, std::size_t pixel) {
  return pixel < film.samples.size() ? film.samples[pixel] : 0;
}

// Whether an undivided pixel is the mean of samples, or left with edges in it, and not cut along
// them.
bool sampled(SplitCause cause, std::uint32_t samples) {
  switch (cause) {
    case SplitCause::shading:
    case SplitCause::cut_out:
    case SplitCause::saturation:
    case SplitCause::depth_limit:
    case SplitCause::lens:
    case SplitCause::motion:
      return true;
    default:
      return samples > 0;
  }
}

}  // namespace

double CostScale::share(double value) const {
  if (!(value > first)) return 0.0;
  return std::min(1.0, std::log(value / first) / std::log(last / first));
}

const CostScale& cost_scale(SplitMapColours colours) {
  return colours == SplitMapColours::time ? seconds_scale : rays_scale;
}

glm::u8vec3 heat_colour(float share) {
  constexpr std::array<std::array<float, 3>, 5> stops{
      {{0, 0, 0}, {87, 16, 110}, {188, 55, 84}, {249, 142, 9}, {255, 255, 255}}};
  const float at = std::clamp(std::isfinite(share) ? share : 1.0f, 0.0f, 1.0f) * 4.0f;
  const auto index = static_cast<std::size_t>(std::min(3.0f, std::floor(at)));
  const float part = at - static_cast<float>(index);
  glm::u8vec3 colour;
  for (std::size_t k = 0; k < 3; ++k) {
    const float value = stops[index][k] + part * (stops[index + 1][k] - stops[index][k]);
    colour[static_cast<int>(k)] = static_cast<std::uint8_t>(value + 0.5f);
  }
  return colour;
}

std::uint8_t SplitMapKey::value(const Film& film, std::size_t pixel) const {
  switch (colours) {
    case SplitMapColours::cause:
      return static_cast<std::uint8_t>(film.cause[pixel]);
    case SplitMapColours::rays:
      return cost_value(rays_scale, film.rays[pixel]);
    case SplitMapColours::time:
      return cost_value(seconds_scale, film.seconds[pixel]);
    case SplitMapColours::level:
      break;
  }
  const std::uint8_t level = film.split_level[pixel];
  if (level > 0) return static_cast<std::uint8_t>(std::min<int>(level, split_colour_levels) + 2);
  if (film.cause[pixel] == SplitCause::none) return 0;
  return sampled(film.cause[pixel], samples_at(film, pixel)) ? 2 : 1;
}

std::uint8_t SplitMapKey::last() const {
  if (colours == SplitMapColours::level) return split_colour_levels + 2;
  return colours == SplitMapColours::cause ? split_cause_count - 1 : 255;
}

std::string split_words(const Film& film, std::size_t pixel) {
  return split_words(film.split_level[pixel], film.cause[pixel], samples_at(film, pixel));
}

std::string split_words(int level, SplitCause cause, std::uint32_t samples) {
  if (level <= 0 && cause == SplitCause::none) return title_of(cause);
  std::string words;
  const auto add = [&](const std::string& word) { words += (words.empty() ? "" : ", ") + word; };
  if (level > 0) add("level " + std::to_string(level));
  if (samples > 0)
    add(std::to_string(samples) + (samples == 1 ? " sample" : " samples"));
  else if (level <= 0)
    add(sampled(cause, samples) ? "sampled" : "exact");
  if (cause != SplitCause::none) add(title_of(cause));
  return words;
}

glm::u8vec3 SplitMapKey::colour(std::uint8_t value) const {
  if (colours == SplitMapColours::cause) return split_cause_colour(static_cast<SplitCause>(value));
  if (colours == SplitMapColours::level)
    return value == 1   ? exact_colour
           : value == 2 ? sampled_colour
                        : split_colour(value == 0 ? 0 : value - 2);
  // The lowest cost is dark, but not black, which means unknown.
  constexpr float darkest = 0.12f;
  if (value == 0) return {0, 0, 0};
  return heat_colour(darkest + (1.0f - darkest) * static_cast<float>(value - 1) / 254.0f);
}

}  // namespace asos
