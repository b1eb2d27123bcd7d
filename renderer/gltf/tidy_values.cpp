#include "renderer/gltf/tidy_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace asos::gltf {

using nlohmann::json;

namespace {

constexpr auto mag_filters = std::to_array<int>({9728, 9729});
constexpr auto min_filters = std::to_array<int>({9728, 9729, 9984, 9985, 9986, 9987});
constexpr auto wraps = std::to_array<int>({33071, 33648, 10497});

/// Visits the objects of a list, each with its place; other entries are reported elsewhere.
template <typename Act>
void for_objects(json& owner, const char* name, const std::string& place, Act act) {
  const auto list = owner.find(name);
  if (list == owner.end() || !list->is_array()) return;
  for (std::size_t i = 0; i < list->size(); ++i)
    if ((*list)[i].is_object()) act((*list)[i], fmt::format("{}/{}/{}", place, name, i));
}

std::optional<double> number(const json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

// Warns about invalid near and far planes, which are ignored: they do not clip.
void check_planes(const json& camera, const std::string& place, Warnings& warnings) {
  for (const char* type : {"perspective", "orthographic"}) {
    const auto found = camera.find(type);
    if (found == camera.end() || !found->is_object()) continue;
    const std::string at = fmt::format("{}/{}", place, type);
    const bool perspective = std::string_view(type) == "perspective";
    const std::optional<double> near = number(*found, "znear"), far = number(*found, "zfar");
    if (near && (perspective ? !(*near > 0.0) : !(*near >= 0.0)))
      warnings.add(fmt::format("{}/znear is {}, which is not {}; ignored", at, *near,
                               perspective ? "above 0" : "0 or more"));
    if (far && !(*far > near.value_or(0.0)))
      warnings.add(fmt::format("{}/zfar is {}, which is not beyond znear; ignored", at, *far));
  }
}

void tidy_choice(json& sampler, const char* name, std::span<const int> known,
                 const std::string& place, Warnings& warnings) {
  const std::optional<double> value = number(sampler, name);
  if (!value || std::find(known.begin(), known.end(), *value) != known.end()) return;
  warnings.add(fmt::format("{}/{} is {}, which is none of {}; ignored", place, name, *value,
                           fmt::join(known, ", ")));
  sampler.erase(name);
}

/// Returns the entry of a list that is an object; null if there is none.
const json* entry_of(const json& list, const json& index) {
  if (!list.is_array() || !index.is_number_unsigned()) return nullptr;
  const auto at = index.get<std::uint64_t>();
  return at < list.size() && list[at].is_object() ? &list[at] : nullptr;
}

bool is_morphed(std::string_view name) {
  return name == "POSITION" || name == "NORMAL" || name == "TANGENT";
}

// Checks morph targets. The readers also report those with a weight; the others would become broken
// only when an animation gives them a weight.
void check_targets(json& primitive, const std::string& place, const json& accessors,
                   Warnings& warnings) {
  const auto attributes = primitive.find("attributes");
  const bool listed = attributes != primitive.end() && attributes->is_object();
  const json* base = entry_of(accessors, listed ? attributes->value("POSITION", json()) : json());
  for_objects(primitive, "targets", place, [&](const json& target, const std::string& at) {
    for (const auto& [name, value] : target.items()) {
      if (!value.is_number_unsigned()) continue;
      const auto warn = [&, &what = name, &index = value](const std::string& why) {
        warnings.add(fmt::format("{}/{} is accessor {}, which {}", at, what,
                                 index.get<std::uint64_t>(), why));
      };
      if (!is_morphed(name)) {
        if (!name.starts_with('_'))
          warnings.add(
              fmt::format("{}/{} is not morphed: only POSITION, NORMAL and TANGENT are", at, name));
        continue;
      }
      const json* accessor = entry_of(accessors, value);
      if (!accessor) {
        warn("does not exist");
        continue;
      }
      if (accessor->value("type", json()) != "VEC3") warn("is not of the type VEC3");
      const json count = accessor->value("count", json());
      if (base && base->contains("count") && count != (*base)["count"])
        warn("has another count than the primitive's POSITION");
    }
  });
}

/// Warns about positions without data. They are all zeros, which is rarely intended.
void check_positions(const json& primitive, const json& accessors, Warnings& warnings) {
  const auto attributes = primitive.find("attributes");
  const auto extensions = primitive.find("extensions");
  const bool packed = extensions != primitive.end() && extensions->is_object() &&
                      extensions->contains("KHR_draco_mesh_compression");
  if (packed || attributes == primitive.end() || !attributes->is_object()) return;
  const json* accessor = entry_of(accessors, attributes->value("POSITION", json()));
  if (accessor && !accessor->contains("bufferView") && !accessor->contains("sparse"))
    warnings.add("a primitive's POSITION has no data: its vertices are all in one place");
}

void check_pose(const json& node, const std::string& place, Warnings& warnings) {
  if (!node.contains("matrix")) return;
  for (const char* name : {"translation", "rotation", "scale"})
    if (node.contains(name))
      warnings.add(fmt::format("{} has a matrix, which holds, and a {}", place, name));
}

}  // namespace

void tidy_values(json& root, Warnings& warnings) {
  if (!root.is_object()) return;
  for_objects(root, "nodes", "", [&](const json& node, const std::string& place) {
    check_pose(node, place, warnings);
  });
  for_objects(root, "cameras", "", [&](const json& camera, const std::string& place) {
    check_planes(camera, place, warnings);
  });
  for_objects(root, "samplers", "", [&](json& sampler, const std::string& place) {
    tidy_choice(sampler, "magFilter", mag_filters, place, warnings);
    tidy_choice(sampler, "minFilter", min_filters, place, warnings);
    tidy_choice(sampler, "wrapS", wraps, place, warnings);
    tidy_choice(sampler, "wrapT", wraps, place, warnings);
  });
  static const json none = json::array();
  const auto list = root.find("accessors");
  const json& accessors = list != root.end() ? *list : none;
  for_objects(root, "meshes", "", [&](json& mesh, const std::string& place) {
    for_objects(mesh, "primitives", place, [&](json& primitive, const std::string& at) {
      check_positions(primitive, accessors, warnings);
      check_targets(primitive, at, accessors, warnings);
    });
  });
}

}  // namespace asos::gltf
