#include "renderer/scene/gltf/tidy_values.h"

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

/// The objects of a list, each with its place; what is none is told elsewhere.
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

// The planes clip nothing here, so that a wrong one changes no picture.
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

// Those of targets that have a weight are told by what reads them, too.
void check_targets(json& primitive, const std::string& place, std::size_t accessors,
                   Warnings& warnings) {
  for_objects(primitive, "targets", place, [&](const json& target, const std::string& at) {
    for (const auto& [name, value] : target.items()) {
      if (!value.is_number_unsigned() || value.get<std::uint64_t>() < accessors) continue;
      warnings.add(fmt::format("{}/{} is accessor {}, which does not exist", at, name,
                               value.get<std::uint64_t>()));
    }
  });
}

}  // namespace

void tidy_values(json& root, Warnings& warnings) {
  if (!root.is_object()) return;
  for_objects(root, "cameras", "", [&](const json& camera, const std::string& place) {
    check_planes(camera, place, warnings);
  });
  for_objects(root, "samplers", "", [&](json& sampler, const std::string& place) {
    tidy_choice(sampler, "magFilter", mag_filters, place, warnings);
    tidy_choice(sampler, "minFilter", min_filters, place, warnings);
    tidy_choice(sampler, "wrapS", wraps, place, warnings);
    tidy_choice(sampler, "wrapT", wraps, place, warnings);
  });
  const auto list = root.find("accessors");
  const std::size_t accessors = list != root.end() && list->is_array() ? list->size() : 0;
  for_objects(root, "meshes", "", [&](json& mesh, const std::string& place) {
    for_objects(mesh, "primitives", place, [&](json& primitive, const std::string& at) {
      check_targets(primitive, at, accessors, warnings);
    });
  });
}

}  // namespace asos::gltf
