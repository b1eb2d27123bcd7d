#include "renderer/gltf/export/gltf_writer.h"
#include "renderer/scene/environment_cube.h"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>
#include <numbers>

// EXT_lights_image_based: the sides as they were read, and the diffuse irradiance that the
// extension requires, as spherical harmonics of three bands (Ramamoorthi and Hanrahan 2001).

namespace asos::exporting {

using nlohmann::json;

namespace {

constexpr const char* extension_name = "EXT_lights_image_based";
constexpr std::size_t coefficients = 9;

/// Returns the real spherical harmonics of a unit direction.
std::array<double, coefficients> harmonics(const glm::dvec3& d) {
  return {0.282095,
          0.488603 * d.y,
          0.488603 * d.z,
          0.488603 * d.x,
          1.092548 * d.x * d.y,
          1.092548 * d.y * d.z,
          0.315392 * (3.0 * d.z * d.z - 1.0),
          1.092548 * d.x * d.z,
          0.546274 * (d.x * d.x - d.y * d.y)};
}

/// Returns the coefficient of a clamped cosine, which converts radiance to irradiance.
double cosine_share(std::size_t coefficient) {
  constexpr double pi = std::numbers::pi;
  return coefficient == 0 ? pi : coefficient < 4 ? 2.0 * pi / 3.0 : pi / 4.0;
}

/// Returns a place on side `side`, whose centre is at distance 1; `right` and `up` are from -1 to
/// 1.
glm::dvec3 place_of(std::size_t side, double right, double up) {
  switch (side) {
    case 0:
      return {1.0, up, right};
    case 1:
      return {-1.0, up, -right};
    case 2:
      return {-right, 1.0, -up};
    case 3:
      return {-right, -1.0, up};
    case 4:
      return {-right, up, 1.0};
    default:
      return {right, up, -1.0};
  }
}

glm::dvec3 radiance(const EnvironmentCube::Side& side, std::size_t texel) {
  const std::uint8_t* p = side.image.rgba.data() + 4 * texel;
  glm::dvec3 linear;
  for (int c = 0; c < 3; ++c) {
    const double s = p[c] / 255.0;
    linear[c] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  }
  if (!side.divided) return linear;
  return p[3] > 0 ? linear * (255.0 / p[3]) : glm::dvec3(0.0);
}

/// Returns the coefficients of the cube in its own axes, without its intensity.
json irradiance_coefficients(const EnvironmentCube& surroundings) {
  std::array<glm::dvec3, coefficients> sums{};
  double sphere = 0.0;
  for (std::size_t s = 0; s < surroundings.sides.size(); ++s) {
    const EnvironmentCube::Side& side = surroundings.sides[s];
    const int size = side.image.width;
    for (int i = 0; i < size * size; ++i) {
      const int x = i % size, y = i / size;
      const glm::dvec3 place =
          place_of(s, (2.0 * x + 1.0) / size - 1.0, 1.0 - (2.0 * y + 1.0) / size);
      const double distance = glm::length(place);
      const double solid_angle = 1.0 / (distance * distance * distance);
      const auto values = harmonics(place / distance);
      const glm::dvec3 light = solid_angle * radiance(side, static_cast<std::size_t>(i));
      for (std::size_t k = 0; k < coefficients; ++k) sums[k] += values[k] * light;
      sphere += solid_angle;
    }
  }
  json out = json::array();
  for (std::size_t k = 0; k < coefficients; ++k) {
    const glm::dvec3 e = sums[k] * (4.0 * std::numbers::pi * cosine_share(k) / sphere);
    out.push_back({e.x, e.y, e.z});
  }
  return out;
}

}  // namespace

Result<void> write_surroundings(const Scene& scene, const std::string& path,
                                GltfDocument& document) {
  if (!scene.surroundings) return {};
  const EnvironmentCube& all = *scene.surroundings;
  json sides = json::array();
  for (const EnvironmentCube::Side& side : all.sides) {
    // The presence of an alpha channel decides whether colours are divided by it.
    const Result<int> image = write_image(side.image, side.divided, path, document);
    if (!image) return unexpected(image.error());
    sides.push_back(*image);
  }
  const glm::dquat turn = glm::quat_cast(all.world_from_cube);
  json light{{"intensity", all.intensity},
             {"rotation", {turn.x, turn.y, turn.z, turn.w}},
             {"irradianceCoefficients", irradiance_coefficients(all)},
             {"specularImageSize", all.sides[0].image.width},
             {"specularImages", json::array({std::move(sides)})}};
  if (!all.name.empty()) light["name"] = all.name;
  document.use_extension(extension_name);
  document.root["extensions"][extension_name]["lights"].push_back(std::move(light));
  document.root["scenes"][0]["extensions"][extension_name]["light"] = 0;
  return {};
}

}  // namespace asos::exporting
