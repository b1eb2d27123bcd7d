#include "renderer/gltf/light_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos::gltf {

std::optional<bool> on_or_off(const tinygltf::Value& object, const std::string& name) {
  if (const std::optional<bool> truth = flag(object, name)) return truth;
  const std::optional<double> value = number(object, name);
  if (value == 0.0) return false;
  if (value == 1.0) return true;
  return std::nullopt;
}

Checked<double> positive_or(const tinygltf::Value& object, const std::string& name,
                            double otherwise) {
  if (!object.Has(name)) return otherwise;
  const std::optional<double> value = number(object, name);
  if (!value) return fault(fmt::format("has a {} that is not a number", name));
  if (!(*value > 0.0)) return fault(fmt::format("has a {} of {}", name, *value));
  return *value;
}

std::optional<std::vector<double>> numbers(const tinygltf::Value& object, const std::string& name) {
  if (!object.Has(name) || !object.Get(name).IsArray()) return std::nullopt;
  std::vector<double> values;
  for (std::size_t i = 0; i < object.Get(name).ArrayLen(); ++i) {
    const std::optional<double> value = number_at(object, name, static_cast<int>(i));
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::string set_brightness(double intensity, const std::vector<double>& color, Light& light) {
  light.intensity = static_cast<float>(intensity);
  if (!std::isfinite(light.intensity) || light.intensity < 0.0f) {
    return fmt::format("has an intensity of {}", intensity);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const auto channel = static_cast<float>(color[c]);
    if (!std::isfinite(channel) || channel < 0.0f) return "has no valid colour";
    light.color[static_cast<int>(c)] = channel;
  }
  return {};
}

std::string read_brightness(const tinygltf::Value& object, std::optional<double> default_intensity,
                            Light& light) {
  std::optional<double> intensity = number(object, "intensity");
  if (!intensity && object.Has("intensity")) return "has an intensity that is not a number";
  if (!intensity) intensity = default_intensity;
  if (!intensity) return "has no intensity";
  std::vector<double> color(3, 1.0);
  if (object.Has("color")) {
    const auto given = numbers(object, "color");
    if (!given || given->size() != 3) return "has a colour that is not three numbers";
    color = *given;
  }
  return set_brightness(*intensity, color, light);
}

void read_off_intensity(const tinygltf::Value& extras, Light& light) {
  if (light.intensity != 0.0f || !extras.IsObject()) return;
  const double off = number(extras, "asos_off_intensity").value_or(0.0);
  if (off > 1.0 && off < static_cast<double>(std::numeric_limits<float>::max()))
    light.color *= static_cast<float>(off);
}

double largest_scale(const glm::dmat4& world_from_node) {
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    largest = std::max(largest, glm::length(glm::dvec3(world_from_node[axis])));
  }
  return largest;
}

std::optional<LightAxes> light_axes(const glm::dmat4& world_from_node) {
  glm::dvec3 axes[3];
  for (int axis = 0; axis < 3; ++axis) {
    axes[axis] = glm::dvec3(world_from_node[axis]);
    if (!positive(glm::length(axes[axis]))) return std::nullopt;
    axes[axis] = glm::normalize(axes[axis]);
  }
  const glm::dvec3 direction = -axes[2];
  const glm::dvec3 across = axes[0] - glm::dot(axes[0], direction) * direction;
  if (!(glm::length(across) > 1e-9)) return std::nullopt;
  const glm::dvec3 x = glm::normalize(across);
  const glm::dvec3 up = glm::cross(x, direction);
  const double side = glm::dot(up, axes[1]);
  if (!(std::abs(side) > 1e-9)) return std::nullopt;
  return LightAxes{x, side < 0.0 ? -up : up, direction};
}

}  // namespace asos::gltf
