#include "renderer/gltf/variants.h"

#include "renderer/gltf/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace asos::gltf {

namespace {

constexpr const char* variants_extension = "KHR_materials_variants";

std::vector<std::string> names_of(const tinygltf::Model& model) {
  std::vector<std::string> names;
  const tinygltf::Value* e = extension(model.extensions, variants_extension);
  if (!e || !e->Has("variants") || !e->Get("variants").IsArray()) return names;
  const tinygltf::Value& list = e->Get("variants");
  for (int i = 0; i < static_cast<int>(list.ArrayLen()); ++i)
    names.push_back(list.Get(i).IsObject() ? text(list.Get(i), "name") : std::string());
  return names;
}

/// Returns whether a mapping's list of variants contains this one.
bool holds(const tinygltf::Value& mapping, int variant) {
  if (!mapping.Has("variants") || !mapping.Get("variants").IsArray()) return false;
  const tinygltf::Value& list = mapping.Get("variants");
  for (int i = 0; i < static_cast<int>(list.ArrayLen()); ++i)
    if (list.Get(i).IsNumber() && list.Get(i).GetNumberAsDouble() == variant) return true;
  return false;
}

/// Returns the material of the first mapping that contains the variant.
std::optional<int> mapped_material(const tinygltf::Primitive& primitive, int variant) {
  const tinygltf::Value* e = extension(primitive.extensions, variants_extension);
  if (!e || !e->Has("mappings") || !e->Get("mappings").IsArray()) return std::nullopt;
  const tinygltf::Value& list = e->Get("mappings");
  for (int i = 0; i < static_cast<int>(list.ArrayLen()); ++i)
    if (list.Get(i).IsObject() && holds(list.Get(i), variant))
      return whole(list.Get(i), "material").value_or(-1);
  return std::nullopt;
}

std::string unknown(const std::string& name, const std::vector<std::string>& names) {
  constexpr std::size_t most_listed = 32;
  if (names.empty()) return "has no variants of its materials";
  std::string text = fmt::format("has no variant '{}'; there are", name);
  for (std::size_t i = 0; i < std::min(names.size(), most_listed); ++i)
    text += fmt::format("{} '{}'", i ? "," : "", names[i]);
  if (names.size() > most_listed) text += fmt::format(" and {} more", names.size() - most_listed);
  return text;
}

}  // namespace

Checked<void> choose_variant(Document& document, const std::string& name) {
  const std::vector<std::string> names = names_of(document.model);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return fault(unknown(name, names));
  const auto variant = static_cast<int>(found - names.begin());
  for (std::size_t m = 0; m < document.model.meshes.size(); ++m) {
    std::vector<tinygltf::Primitive>& primitives = document.model.meshes[m].primitives;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const std::optional<int> material = mapped_material(primitives[p], variant);
      if (!material) continue;
      if (*material >= 0 && static_cast<std::size_t>(*material) < document.model.materials.size()) {
        primitives[p].material = *material;
      } else {
        document.warnings.add(fmt::format(
            "mesh {} primitive {}: variant '{}' has no material that exists; left as it is", m, p,
            name));
      }
    }
  }
  return {};
}

}  // namespace asos::gltf
