#include "renderer/gltf/area_lights.h"

#include "renderer/gltf/light_values.h"
#include "renderer/gltf/validate_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos::gltf {

namespace {

using std::numbers::pi;

/// The sizes of a shape in either of the two proposals, converted to one form: metres in the node's
/// space.
struct FlatShape {
  double width = 1.0, height = 1.0, radius = 1.0;
};

Checked<FlatShape> read_ext_sizes(const tinygltf::Value& source) {
  FlatShape shape;
  const Checked<double> size = positive_or(source, "size", 1.0);
  if (!size) return fault(size.error());
  Checked<double> aspect = 1.0;
  if (source.Has("rect") && source.Get("rect").IsObject()) {
    aspect = positive_or(source.Get("rect"), "aspect", 1.0);
  }
  if (!aspect) return fault(aspect.error());
  shape.width = *size * *aspect;
  shape.height = *size;
  shape.radius = 0.5 * *size;
  return shape;
}

Checked<FlatShape> read_khr_sizes(const tinygltf::Value& source) {
  FlatShape shape;
  const auto read = [&source](const char* name, double& value) -> std::string {
    const Checked<double> given = positive_or(source, name, 1.0);
    if (given) value = *given;
    return given ? "" : given.error();
  };
  for (std::string why :
       {read("width", shape.width), read("height", shape.height), read("radius", shape.radius)}) {
    if (!why.empty()) return fault(why);
  }
  return shape;
}

/// Returns why the light is invalid, or an empty string.
std::string shape_light(const std::string& kind, const FlatShape& shape, bool spheres,
                        const glm::dmat4& world_from_node, Light& light) {
  const double scale = largest_scale(world_from_node);
  if (!positive(scale)) return "is placed by a matrix that leaves it no size";
  if (kind == "sphere" && spheres) {
    light.type = Light::Type::point;
    light.radius = shape.radius * scale;
    // A ball's radiance is its intensity in candela over the area of its outline.
    light.intensity *= static_cast<float>(pi * light.radius * light.radius);
    return {};
  }
  if (kind != "rect" && kind != "disk") return fmt::format("has the unknown type '{}'", kind);
  const std::optional<LightAxes> axes = light_axes(world_from_node);
  if (!axes) return "is placed by a matrix that squeezes it flat";
  light.direction = axes->direction;
  if (kind == "disk") {
    light.type = Light::Type::disk;
    light.radius = shape.radius * scale;
  } else {
    light.type = Light::Type::rectangle;
    light.half_u = 0.5 * scale * shape.width * axes->x;
    light.half_v = 0.5 * scale * shape.height * axes->y;
  }
  return {};
}

/// Returns why the light is invalid, or an empty string.
std::string read_area_light(const tinygltf::Value& source, bool ext,
                            const glm::dmat4& world_from_node, Light& light) {
  // The proposal's text uses `type`, and its schema `shape`.
  const std::string kind = text(source, "type", text(source, "shape"));
  const Checked<FlatShape> shape = ext ? read_ext_sizes(source) : read_khr_sizes(source);
  if (!shape) return shape.error();
  if (std::string why = read_brightness(source, ext ? 1000.0 : 1.0, light); !why.empty()) {
    return why;
  }
  if (source.Has("extras") && source.Get("extras").IsObject()) {
    const tinygltf::Value& extras = source.Get("extras");
    light.casts_shadows = on_or_off(extras, "casts_shadows").value_or(true);
    light.two_sided = on_or_off(extras, "two_sided").value_or(false);
  }
  light.position = glm::dvec3(world_from_node[3]);
  if (std::string why = shape_light(kind, *shape, !ext, world_from_node, light); !why.empty()) {
    return why;
  }
  return validate_light(light);
}

bool nearly(double a, double b) {
  return std::abs(a - b) <= 1e-5 * std::max(std::abs(a), std::abs(b));
}

/// Returns whether two descriptions on one node mean the same light, ignoring properties that only
/// one of them can express.
bool agree(const Light& a, const Light& b) {
  const glm::dvec3 p = glm::dvec3(a.color) * static_cast<double>(a.intensity);
  const glm::dvec3 q = glm::dvec3(b.color) * static_cast<double>(b.intensity);
  return a.type == b.type && nearly(p.x, q.x) && nearly(p.y, q.y) && nearly(p.z, q.z) &&
         nearly(a.radius, b.radius) && nearly(glm::length(a.half_u), glm::length(b.half_u)) &&
         nearly(glm::length(a.half_v), glm::length(b.half_v));
}

}  // namespace

std::optional<Light> area_light(Document& document, const tinygltf::Node& node,
                                const glm::dmat4& world_from_node) {
  const char* name = "EXT_lights_area";
  const tinygltf::Value* reference = extension(node.extensions, name);
  const bool ext = reference != nullptr;
  if (!ext) reference = extension(node.extensions, name = "KHR_lights_area");
  if (!reference) return std::nullopt;
  const int index = whole(*reference, "light").value_or(-1);
  const tinygltf::Value* root = extension(document.model.extensions, name);
  const bool listed = root && root->Has("lights") && root->Get("lights").IsArray() && index >= 0 &&
                      static_cast<std::size_t>(index) < root->Get("lights").ArrayLen() &&
                      root->Get("lights").Get(index).IsObject();
  if (!listed) {
    document.warnings.add(
        fmt::format("node '{}' has light {} of {}, which the file does not "
                    "define; left out",
                    node.name, index, name));
    return std::nullopt;
  }
  const tinygltf::Value& source = root->Get("lights").Get(index);
  Light light;
  light.name = text(source, "name");
  if (light.name.empty()) light.name = node.name;
  if (const std::string why = read_area_light(source, ext, world_from_node, light); !why.empty()) {
    document.warnings.add(
        fmt::format("light {} '{}' of {} {}; left out", index, light.name, name, why));
    return std::nullopt;
  }
  return light;
}

void add_area_light(Document& document, const tinygltf::Node& node,
                    const glm::dmat4& world_from_node, Scene& scene) {
  std::optional<Light> light = area_light(document, node, world_from_node);
  std::optional<Light> exact = extras_light(document, node, world_from_node);
  if (light && exact && agree(*light, *exact)) {
    exact->name = light->name;
    light = std::move(exact);
  } else if (light && exact) {
    // A program that knows the extension may have edited it and left the extras unchanged.
    document.warnings.add(fmt::format(
        "light '{}' is another one in its node's extras than by its extension, which holds",
        light->name));
    light->two_sided = exact->two_sided;
    light->casts_shadows = exact->casts_shadows;
  } else if (exact) {
    light = std::move(exact);
  }
  if (light) scene.lights.push_back(std::move(*light));
}

}  // namespace asos::gltf
