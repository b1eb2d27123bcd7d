#include "renderer/gltf/area_lights.h"
#include "renderer/gltf/light_values.h"
#include "renderer/gltf/outlines.h"
#include "renderer/gltf/validate_light.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace asos::gltf {

namespace {

glm::dvec3 vector_at(const std::vector<double>& values, std::size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

glm::dvec3 placed(const glm::dmat4& world_from_node, glm::dvec3 p) {
  return glm::dvec3(world_from_node * glm::dvec4(p, 1.0));
}

// Each of the readers returns why the light is invalid, or an empty string.

std::string read_linear(const tinygltf::Value& source, const glm::dmat4& world_from_node,
                        Light& light) {
  light.type = Light::Type::linear;
  const auto from = numbers(source, "from"), to = numbers(source, "to");
  if (!from || !to || from->size() != 3 || to->size() != 3) {
    return "has no ends `from` and `to` of three numbers each";
  }
  // Subtract first: far from the origin, this is more exact than a difference of sums.
  const glm::dvec3 a = vector_at(*from, 0), b = vector_at(*to, 0);
  light.half_u = glm::dmat3(world_from_node) * (0.5 * (b - a));
  light.position = placed(world_from_node, 0.5 * (a + b));
  if (!positive(glm::length(light.half_u))) return "has no length";
  if (number(source, "radius") == 0.0) return "";
  const Checked<double> radius = positive_or(source, "radius", 0.0);
  if (!radius) return radius.error();
  light.radius = *radius > 0.0 ? largest_scale(world_from_node) * *radius : 0.0;
  return "";
}

Checked<Outlines> read_outlines(const tinygltf::Value& source) {
  const auto corners = numbers(source, "corners");
  if (!corners) return fault("has no list `corners` of numbers");
  if (corners->size() % 3 != 0) return fault("has corners that are not three numbers each");
  const std::size_t count = corners->size() / 3;
  std::vector<double> sizes{static_cast<double>(count)};
  if (source.Has("outline_sizes")) {
    const auto given = numbers(source, "outline_sizes");
    if (!given) return fault("has outline sizes that are not numbers");
    sizes = *given;
  }
  Outlines outlines;
  std::size_t next = 0;
  for (const double size : sizes) {
    if (!(size >= 0.0 && size <= static_cast<double>(count - next)) || size != std::floor(size)) {
      return fault("has outline sizes that do not count its corners");
    }
    std::vector<glm::dvec3>& outline = outlines.emplace_back();
    for (const std::size_t end = next + static_cast<std::size_t>(size); next < end; ++next) {
      outline.push_back(vector_at(*corners, next));
    }
  }
  if (next != count) return fault("has outline sizes that do not count its corners");
  return outlines;
}

std::string read_polygon(const tinygltf::Value& source, const glm::dmat4& world_from_node,
                         Light& light) {
  light.type = Light::Type::polygon;
  Checked<Outlines> outlines = read_outlines(source);
  if (!outlines) return outlines.error();
  // Rotate and scale about the node first, so that the checks do not depend on the node's position.
  const glm::dmat3 linear(world_from_node);
  for (std::vector<glm::dvec3>& outline : *outlines) {
    for (glm::dvec3& p : outline) p = linear * p;
  }
  Checked<FlatOutlines> flat = flatten_outlines(std::move(*outlines));
  if (!flat) return flat.error();
  light.outlines = std::move(flat->outlines);
  light.direction = flat->normal;
  const glm::dvec3 origin(world_from_node[3]);
  light.position = origin + flat->middle;
  for (std::vector<glm::dvec3>& outline : light.outlines) {
    for (glm::dvec3& p : outline) p += origin;
  }
  // Mirroring reverses the winding; as with triangles, the front stays in front.
  if (glm::determinant(linear) < 0.0) {
    light.direction = -light.direction;
    for (auto& outline : light.outlines) std::reverse(outline.begin(), outline.end());
  }
  return {};
}

std::string read_flat(const tinygltf::Value& source, bool disk, const glm::dmat4& world_from_node,
                      Light& light) {
  const double scale = largest_scale(world_from_node);
  const std::optional<LightAxes> axes = light_axes(world_from_node);
  if (!positive(scale) || !axes) return "is placed by a matrix that squeezes it flat";
  light.type = disk ? Light::Type::disk : Light::Type::rectangle;
  light.position = glm::dvec3(world_from_node[3]);
  light.direction = axes->direction;
  for (const char* name : {"width", "height", "radius"}) {
    if ((std::string_view(name) == "radius") != disk) continue;
    if (!source.Has(name)) return fmt::format("has no {}", name);
  }
  if (disk) {
    const Checked<double> radius = positive_or(source, "radius", 1.0);
    if (!radius) return radius.error();
    light.radius = scale * *radius;
    return {};
  }
  const Checked<double> width = positive_or(source, "width", 1.0);
  const Checked<double> height = positive_or(source, "height", 1.0);
  if (!width || !height) return width ? height.error() : width.error();
  light.half_u = 0.5 * scale * *width * axes->x;
  light.half_v = 0.5 * scale * *height * axes->y;
  return {};
}

std::string read_shape(const tinygltf::Value& source, const glm::dmat4& world_from_node,
                       Light& light) {
  const std::string kind = text(source, "type");
  if (kind == "linear") return read_linear(source, world_from_node, light);
  light.two_sided = on_or_off(source, "two_sided").value_or(false);
  if (kind == "polygon") return read_polygon(source, world_from_node, light);
  if (kind == "rect" || kind == "disk") {
    return read_flat(source, kind == "disk", world_from_node, light);
  }
  return fmt::format("has the unknown type '{}'", kind);
}

std::string read_extras(const tinygltf::Value& source, const glm::dmat4& world_from_node,
                        Light& light) {
  if (!source.IsObject()) return "is not an object";
  if (std::string why = read_brightness(source, std::nullopt, light); !why.empty()) return why;
  light.casts_shadows = on_or_off(source, "casts_shadows").value_or(true);
  if (std::string why = read_shape(source, world_from_node, light); !why.empty()) return why;
  return validate_light(light);
}

}  // namespace

std::optional<Light> extras_light(Document& document, const tinygltf::Node& node,
                                  const glm::dmat4& world_from_node) {
  if (!node.extras.IsObject() || !node.extras.Has("asos_light")) return std::nullopt;
  Light light;
  light.name = node.name;
  const tinygltf::Value& source = node.extras.Get("asos_light");
  if (const std::string why = read_extras(source, world_from_node, light); !why.empty()) {
    const auto index = &node - document.model.nodes.data();
    document.warnings.add(
        fmt::format("node {} '{}': the light in its extras {}; left out", index, node.name, why));
    return std::nullopt;
  }
  return light;
}

}  // namespace asos::gltf
