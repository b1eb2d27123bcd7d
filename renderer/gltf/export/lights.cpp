#include "renderer/gltf/export/gltf_writer.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

// The encoding of each kind of light is in gltf/LIGHTS.md. Lights are placed by nodes without
// scale, so that sizes are written unchanged.

namespace asos::exporting {

using nlohmann::json;

namespace {

template <typename Vector>
json vector_json(const Vector& v) {
  return json::array({v.x, v.y, v.z});
}

json quaternion_json(const glm::dquat& q) {
  return json::array({q.x, q.y, q.z, q.w});
}

/// Returns the intensity of a light that is switched off, whose colour contains it; 0: it is on.
float off_intensity(const Light& light) {
  return light.intensity == 0.0f ? std::max({light.color.x, light.color.y, light.color.z}) : 0.0f;
}

/// Returns the rotation from -Z to the unit `direction`, as glTF's (x, y, z, w).
json rotation_json(const glm::dvec3& direction) {
  const glm::dvec3 away(0.0, 0.0, -1.0);
  // For the opposite direction, any half turn about an axis perpendicular to -Z works; otherwise
  // use the shortest rotation.
  const double w = 1.0 + glm::dot(away, direction);
  return quaternion_json(w < 1e-12 ? glm::dquat(0.0, 0.0, 1.0, 0.0)
                                   : glm::normalize(glm::dquat(w, glm::cross(away, direction))));
}

/// Returns the rotation from -Z to a rectangle's direction and from X to its half_u.
json rectangle_rotation_json(const Light& light) {
  const glm::dvec3 z = -glm::normalize(light.direction);
  const glm::dvec3 x = glm::normalize(light.half_u - glm::dot(light.half_u, z) * z);
  return quaternion_json(glm::normalize(glm::quat_cast(glm::dmat3(x, glm::cross(z, x), z))));
}

// --- KHR_lights_punctual ----------------------------------------------------------------------

bool is_punctual(const Light& light) {
  return light.type == Light::Type::point || light.type == Light::Type::spot ||
         light.type == Light::Type::directional;
}

json punctual_json(const Light& light) {
  json out{{"color", vector_json(light.color)}, {"intensity", light.intensity}};
  if (const float off = off_intensity(light); off > 1.0f) {
    out["color"] = vector_json(light.color / off);
    out["extras"]["asos_off_intensity"] = off;
  }
  if (!light.name.empty()) out["name"] = light.name;
  if (light.type == Light::Type::directional) {
    out["type"] = "directional";
  } else {
    out["type"] = light.type == Light::Type::spot ? "spot" : "point";
    if (std::isfinite(light.range)) out["range"] = light.range;
  }
  if (light.type == Light::Type::spot) {
    // glTF requires an inner cone smaller than the outer one.
    const double inner = std::min(light.inner_cone_rad, light.outer_cone_rad * (1.0 - 1e-12));
    out["spot"] = {{"innerConeAngle", inner}, {"outerConeAngle", light.outer_cone_rad}};
  }
  // glTF has no properties for shadows and sizes; other programs preserve extras.
  if (!light.casts_shadows) out["extras"]["casts_shadows"] = false;
  if (light.type == Light::Type::directional) {
    if (light.angular_diameter_rad > 0.0) {
      out["extras"]["angular_diameter"] = light.angular_diameter_rad;
    }
  } else if (light.radius > 0.0) {
    out["extras"]["radius"] = light.radius;
  }
  return out;
}

// --- EXT_lights_area and extras ---------------------------------------------------------------

/// Writes every property, since programs have different defaults.
json ext_area_json(const Light& light) {
  // The extension's colours are at most 1; the excess is moved into the intensity.
  const float brightest = std::max({light.color.x, light.color.y, light.color.z, 1.0f});
  json out{{"color", vector_json(light.color / brightest)},
           {"intensity", static_cast<double>(light.intensity) * static_cast<double>(brightest)}};
  if (!light.name.empty()) out["name"] = light.name;
  if (light.type == Light::Type::disk) {
    out["type"] = "disk";
    out["size"] = 2.0 * light.radius;
  } else {
    out["type"] = "rect";
    out["size"] = 2.0 * glm::length(light.half_v);
    out["rect"]["aspect"] = glm::length(light.half_u) / glm::length(light.half_v);
  }
  return out;
}

/// Writes flat lists of numbers, since some programs drop nested lists.
void add_corners(const Light& light, json& out) {
  out["corners"] = json::array();
  for (const std::vector<glm::dvec3>& outline : light.outlines) {
    for (const glm::dvec3& corner : outline) {
      const glm::dvec3 p = corner - light.position;
      for (int i = 0; i < 3; ++i) out["corners"].push_back(p[i]);
    }
    out["outline_sizes"].push_back(outline.size());
  }
}

json extras_json(const Light& light) {
  json out{{"color", vector_json(light.color)},
           {"intensity", light.intensity},
           {"casts_shadows", light.casts_shadows}};
  if (light.type == Light::Type::linear) {
    out["type"] = "linear";
    out["from"] = vector_json(-light.half_u);
    out["to"] = vector_json(light.half_u);
    if (light.radius > 0.0) out["radius"] = light.radius;
    return out;
  }
  out["two_sided"] = light.two_sided;
  if (light.type == Light::Type::disk) {
    out["type"] = "disk";
    out["radius"] = light.radius;
  } else if (light.type == Light::Type::rectangle) {
    out["type"] = "rect";
    out["width"] = 2.0 * glm::length(light.half_u);
    out["height"] = 2.0 * glm::length(light.half_v);
  } else {
    out["type"] = "polygon";
    add_corners(light, out);
  }
  return out;
}

/// Adds the light to an extension's list and makes the node refer to it.
void add_to_extension(const char* name, json light, json& node, GltfDocument& document) {
  document.use_extension(name);
  json& lights = document.root["extensions"][name]["lights"];
  lights.push_back(std::move(light));
  node["extensions"][name]["light"] = lights.size() - 1;
}

}  // namespace

void write_added_lighting(AddedLighting lighting, GltfDocument& document) {
  if (lighting == AddedLighting::automatic) return;
  json& extras = document.default_scene()["extras"];
  if (!extras.is_object()) extras = json::object();
  extras["asos_default_lighting"] = lighting == AddedLighting::none ? "none" : "environment";
}

void write_lights(const Scene& scene, GltfDocument& document) {
  for (const Light& light : scene.lights) {
    json node = named_node(light.name);
    node["translation"] = vector_json(light.position);
    if (is_punctual(light)) {
      add_to_extension("KHR_lights_punctual", punctual_json(light), node, document);
      if (light.type != Light::Type::point) node["rotation"] = rotation_json(light.direction);
    } else {
      node["extras"]["asos_light"] = extras_json(light);
    }
    if (light.type == Light::Type::rectangle || light.type == Light::Type::disk) {
      add_to_extension("EXT_lights_area", ext_area_json(light), node, document);
      node["rotation"] = light.type == Light::Type::disk ? rotation_json(light.direction)
                                                         : rectangle_rotation_json(light);
    }
    document.add_root_node(std::move(node));
  }
}

}  // namespace asos::exporting
