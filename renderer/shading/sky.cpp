#include "renderer/shading/sky.h"

#include "renderer/lights/light_math.h"
#include "renderer/settings/value_text.h"
#include "renderer/shading/dfr.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/environment_picture.h"
#include "renderer/shading/environments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace asos {
namespace {

constexpr double sqrt2 = std::numbers::sqrt2;

/// A patch is integrated in parts of about this size, in radians, and about as wide as high. There
/// are at most `most_parts` per side, or `most_parts_of_long` if the patch is long.
constexpr double widest_part = 0.25;
constexpr int most_parts = 8;
constexpr int most_parts_of_long = 16;

std::string colours(glm::vec3 zenith, glm::vec3 horizon) {
  const auto text = [](glm::vec3 c) { return fmt::format("{},{},{}", c.x, c.y, c.z); };
  return zenith == horizon ? text(zenith) : text(zenith) + ":" + text(horizon);
}

/// Returns the part of a step perpendicular to a direction.
glm::dvec3 across(glm::dvec3 direction, glm::dvec3 step) {
  return step - glm::dot(step, direction) * direction;
}

struct Parts {
  int right;
  int down;
};

Parts parts_of(double right, double down) {
  if (!std::isfinite(right + down)) return {1, 1};
  const double least = std::max(
      {std::min(right, down), right / most_parts_of_long, down / most_parts_of_long, 1e-12});
  const auto parts = [&](double length) {
    const int by_shape = static_cast<int>(std::ceil(length / least - 1e-6));
    const int by_size =
        static_cast<int>(std::ceil(std::min(length / widest_part, 1.0 * most_parts)));
    return std::max({1, by_shape, by_size});
  };
  return {parts(right), parts(down)};
}

/// Returns the mean radiance around the ridge of a stretched lobe, sampled by facets. Each facet's
/// part is as wide as the lobe is across. Their slopes along the stretch divide the lobe's facets
/// into equal fractions (a GGX lobe's slopes along one coordinate have the density a^2 / (2 (a^2 +
/// x^2)^(3/2))).
glm::vec3 around_ridge(const Sky& sky, const Lobe& lobe, glm::vec3 normal, glm::vec3 to_viewer) {
  constexpr int facets = 9;
  const float alpha = lobe.alpha_along();
  const glm::vec3 along = glm::normalize(lobe.stretch.along);
  glm::vec3 sum(0.0f);
  int met = 0;
  for (int k = 0; k < facets; ++k) {
    const float c = (2.0f * static_cast<float>(k) + 1.0f) / facets - 1.0f;
    const glm::vec3 facet = glm::normalize(normal + (alpha * c / std::sqrt(1.0f - c * c)) * along);
    const glm::vec3 direction = glm::reflect(-to_viewer, facet);
    if (!(glm::dot(facet, to_viewer) > 0.0f) || !(glm::dot(direction, normal) > 0.0f)) continue;
    sum += sky.around(direction, lobe.roughness);
    ++met;
  }
  return met > 0 ? sum / static_cast<float>(met) : sky.around(normal, lobe.roughness);
}

}  // namespace

Sky::Sky(glm::vec3 zenith, glm::vec3 horizon) : gradient_({zenith, horizon, horizon, horizon}) {
  choice_.colours = {zenith, horizon};
}

Sky::Sky(Environment environment) : lobes_(environment_lobes(environment)) {
  choice_.environment = environment;
  follow_environment();
}

Sky::Sky(SkyMap map, double turn_deg, std::string file)
    : map_(std::make_shared<const SkyMap>(std::move(map))),
      lobes_(std::make_shared<const SkyLobes>(*map_)),
      choice_{{}, std::move(file)} {
  *this = turned(turn_deg);
}

Sky Sky::turned(double turn_deg) const {
  Sky sky = *this;
  if (!is_picture() && !choice_.environment) return sky;
  sky.choice_.turn_deg = turn_deg;
  sky.turn_cos_ = std::cos(turn_deg * std::numbers::pi / 180.0);
  sky.turn_sin_ = std::sin(turn_deg * std::numbers::pi / 180.0);
  sky.follow_environment();
  return sky;
}

Sky Sky::brightened(double times) const {
  Sky sky = *this;
  if (!is_picture() && !choice_.environment) return sky;
  sky.choice_.brightness = sky.brightness_ = times;
  sky.follow_environment();
  return sky;
}

/// Applies turn and brightness to the gradient of an environment without a picture.
void Sky::follow_environment() {
  if (is_picture() || !choice_.environment) return;
  const EnvironmentRow& row = row_of(*choice_.environment);
  Gradient::Colours scaled = row.colours;
  for (glm::vec3* colour : {&scaled.zenith, &scaled.above, &scaled.below, &scaled.nadir})
    *colour *= static_cast<float>(choice_.brightness);
  gradient_ = Gradient(scaled);
  AzimuthVariation::Amounts sides = row.sides;
  sides.one *= choice_.brightness;
  sides.two *= choice_.brightness;
  sides.one_deg += choice_.turn_deg;
  sides.two_deg += choice_.turn_deg;
  sides_ = AzimuthVariation(sides);
}

std::string Sky::name() const {
  if (choice_.colours) return colours(choice_.colours->zenith, choice_.colours->horizon);
  std::string name =
      choice_.environment ? std::string(row_of(*choice_.environment).name) : choice_.file;
  if (choice_.turn_deg != 0.0) name += fmt::format(", turned by {} degrees", choice_.turn_deg);
  if (choice_.brightness != 1.0) name += fmt::format(", {} times as bright", choice_.brightness);
  return name;
}

const SkyMap& Sky::map() const {
  return map_ ? *map_ : environment_picture(*choice_.environment);
}

glm::dvec3 Sky::in_map(glm::dvec3 d) const {
  return {turn_cos_ * d.x - turn_sin_ * d.z, d.y, turn_sin_ * d.x + turn_cos_ * d.z};
}

glm::vec3 Sky::radiance(glm::vec3 direction, glm::vec3 right, glm::vec3 down) const {
  if (constant()) return gradient_.zenith();
  const glm::dvec3 middle(direction), r(right), s(down);
  const double width = glm::length(across(middle, r)), height = glm::length(across(middle, s));
  // Fast path: a small patch on one side of a gradient's horizon, as in nearly all pixels.
  if (!is_picture() && std::max(width, height) <= widest_part &&
      gradient_.linear_near(middle.y, width + height)) {
    const glm::dvec3 mean = gradient_.mean(middle.y, 0.0);
    return sides_.none() ? mean : mean + sides_.mean(middle, r, s);
  }
  const Parts n = parts_of(width, height);
  return mean_of_parts({middle, r, s}, n.right, n.down);
}

glm::vec3 Sky::around(glm::vec3 direction, float roughness) const {
  if (constant()) return gradient_.zenith();
  const PictureLobes picture = picture_lobes();
  if (picture.lobes && roughness >= SkyLobes::least_roughness)
    return picture.brightness * picture.lobes->around(picture.turned(direction), roughness);
  const glm::dvec3 middle(direction);
  const double w = lobe_width(static_cast<double>(roughness));
  if (!is_picture()) {
    const glm::dvec3 mean = gradient_.around(middle.y, w);
    return sides_.none() ? mean : mean + sides_.around(middle, w);
  }
  // A lobe within a texel of the picture needs no parts.
  const int rows = map().rows_below(std::numeric_limits<int>::max()).rows();
  const int parts = w * rows > std::numbers::pi ? 3 : 1;
  const glm::dvec3 right = any_perpendicular(middle);
  return mean_of_parts({middle, w * right, w * glm::cross(middle, right)}, parts, parts);
}

glm::dvec3 Sky::mean_of_parts(const Directions& all, int across_right, int across_down) const {
  glm::dvec3 sum(0.0);
  const glm::dvec3 right = all.right / static_cast<double>(across_right);
  const glm::dvec3 down = all.down / static_cast<double>(across_down);
  for (int j = 0; j < across_down; ++j) {
    for (int i = 0; i < across_right; ++i) {
      const glm::dvec3 p = all.middle + (i + 0.5 - 0.5 * across_right) * right +
                           (j + 0.5 - 0.5 * across_down) * down;
      const double length = glm::length(p);
      if (length == 0.0) continue;
      sum += part_mean(p / length, right / length, down / length);
    }
  }
  return sum / (1.0 * across_right * across_down);
}

glm::dvec3 Sky::part_mean(glm::dvec3 direction, glm::dvec3 right, glm::dvec3 down) const {
  const glm::dvec3 r = across(direction, right), s = across(direction, down);
  // Use a square, or a range of heights, with the variance of the part.
  if (is_picture())
    return brightness_ * glm::dvec3(map().mean(in_map(direction),
                                               std::hypot(glm::length(r), glm::length(s)) / sqrt2));
  const glm::dvec3 mean = gradient_.mean(direction.y, 0.5 * std::sqrt(r.y * r.y + s.y * s.y));
  return sides_.none() ? mean : mean + sides_.mean(direction, r, s);
}

SkyDirection Sky::bright_direction(glm::dvec2 place) const {
  SkyDirection found = map().distribution().at(place);
  const glm::dvec3 d = found.direction;
  found.direction = {turn_cos_ * d.x + turn_sin_ * d.z, d.y, -turn_sin_ * d.x + turn_cos_ * d.z};
  return found;
}

double Sky::bright_density(glm::vec3 direction) const {
  return map().distribution().density(in_map(direction));
}

glm::vec3 Sky::ambient(glm::vec3 normal) const {
  if (const PictureLobes picture = picture_lobes(); picture.lobes)
    return sky_visibility * picture.brightness *
           picture.lobes->irradiance_over_pi(picture.turned(normal));
  if (constant()) return sky_visibility * gradient_.zenith();
  glm::dvec3 irradiance = gradient_.irradiance_over_pi(normal);
  if (!sides_.none()) irradiance += sides_.irradiance_over_pi(normal);
  return sky_visibility * glm::vec3(irradiance);
}

Result<SkyChoice> parse_sky(std::string_view text) {
  if (text == "neutral") return SkyChoice{};
  for (const EnvironmentRow& row : environments) {
    if (text != row.name) continue;
    SkyChoice sky;
    sky.environment = row.value;
    return sky;
  }
  if (text.ends_with(".hdr") || text.ends_with(".exr"))
    return SkyChoice{{}, std::string(text), 0.0};
  const auto colours = parse_colours(text,
                                     "not neutral, softboxes, windows, studio, daylight, dusk, "
                                     "white, grey, R,G,B such as 0.3,0.5,0.9, R,G,B:R,G,B (zenith "
                                     "and horizon) or a file that ends in .hdr or .exr");
  if (!colours) return unexpected(colours.error());
  return SkyChoice{SkyChoice::Colours{colours->first, colours->second}, "", 0.0};
}

Result<std::shared_ptr<const Sky>> make_sky(const SkyChoice& choice) {
  if (choice.environment)
    return std::make_shared<const Sky>(
        Sky(*choice.environment).turned(choice.turn_deg).brightened(choice.brightness));
  if (choice.colours)
    return std::make_shared<const Sky>(choice.colours->zenith, choice.colours->horizon);
  if (choice.file.empty()) return nullptr;
  return read_sky(choice.file, choice.turn_deg).map([&](const std::shared_ptr<const Sky>& sky) {
    return std::make_shared<const Sky>(sky->brightened(choice.brightness));
  });
}

SkyChoice choice_of(const Sky* sky) {
  return sky ? sky->choice() : SkyChoice{};
}

glm::vec3 background(const Sky* sky, glm::vec3 direction, const PixelSpacing* spacing, float side) {
  if (!sky) return background_radiance;
  // Parallel rays all reach the same point at infinity.
  if (!spacing || !spacing->perspective) return sky->radiance(direction);
  const float scale = side * glm::dot(direction, spacing->forward);
  return sky->radiance(direction, scale * spacing->right, scale * spacing->down);
}

glm::vec3 reflected_sky(const Sky* sky, const ViewedMaterial& seen, glm::vec3 normal,
                        glm::vec3 to_viewer) {
  const float share = mirrored_visibility(seen.lobe.roughness);
  if (!sky) return sky_radiance * (sky_visibility * seen.ambient + share * seen.specular);
  const glm::vec3 diffuse = sky->ambient(normal) * seen.ambient;
  if (seen.specular == glm::vec3(0.0f)) return diffuse;
  const glm::vec3 mirrored = glm::reflect(-to_viewer, normal);
  if (!seen.lobe.stretch.none())
    return diffuse + share * around_ridge(*sky, seen.lobe, normal, to_viewer) * seen.specular;
  return diffuse + share * sky->around(mirrored, seen.lobe.roughness) * seen.specular;
}

}  // namespace asos
