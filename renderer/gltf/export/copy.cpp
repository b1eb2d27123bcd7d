#include "renderer/gltf/copy.h"

#include "renderer/gltf/asset_root.h"
#include "renderer/gltf/export/embed_files.h"
#include "renderer/gltf/export/gltf_writer.h"
#include "renderer/gltf/nodes.h"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <new>
#include <utility>

namespace asos {

namespace exporting {
namespace {

using nlohmann::json;

// As the importer's limit: the JSON library works recursively.
constexpr std::size_t most_nesting = 200;

gltf::Checked<json> read_json(const gltf::Container& container) {
  if (gltf::nesting_depth(container.json) > most_nesting)
    return gltf::fault(fmt::format("the JSON is nested more than {} levels deep", most_nesting));
  json root = json::parse(container.json.begin(), container.json.end(), nullptr, false);
  if (!root.is_object()) return gltf::fault("the JSON is broken");
  return root;
}

// The entries of a list that are objects; none if there is no list.
template <typename Function>
void for_each_entry(json& object, const char* list, const Function& function) {
  const auto found = object.find(list);
  if (found == object.end() || !found->is_array()) return;
  for (std::size_t i = 0; i < found->size(); ++i)
    if ((*found)[i].is_object()) function(i, (*found)[i]);
}

json& object_in(json& object, const char* name) {
  json& member = object[name];
  if (!member.is_object()) member = json::object();
  return member;
}

void erase_in(json& object, const char* group, const char* name) {
  const auto found = object.find(group);
  if (found == object.end() || !found->is_object()) return;
  found->erase(name);
  if (found->empty()) object.erase(found);
}

// Nodes keep their places and children; only their lights go.
void remove_lights(json& root) {
  for_each_entry(root, "nodes", [](std::size_t, json& node) {
    for (const char* name : {"KHR_lights_punctual", "EXT_lights_area", "KHR_lights_area"})
      erase_in(node, "extensions", name);
    erase_in(node, "extras", "asos_light");
  });
}

void write_dfrs(const std::vector<std::optional<Dfr>>& dfrs, json& root) {
  for_each_entry(root, "materials", [&](std::size_t i, json& material) {
    if (i >= dfrs.size()) return;
    if (dfrs[i])
      object_in(material, "extras")["asos_dfr"] = dfr_json(*dfrs[i]);
    else
      erase_in(material, "extras", "asos_dfr");
  });
}

// Returns the index of a variant among the file's names; -1: none.
int index_of_variant(const json& root, const std::string& name) {
  const json* names = &root;
  for (const char* member : {"extensions", "KHR_materials_variants", "variants"}) {
    if (!names->is_object() || !names->contains(member)) return -1;
    names = &(*names)[member];
  }
  if (!names->is_array()) return -1;
  for (std::size_t i = 0; i < names->size(); ++i) {
    const json& variant = (*names)[i];
    if (variant.is_object() && variant.value("name", json()) == json(name))
      return static_cast<int>(i);
  }
  return -1;
}

// Primitives get the material of the first mapping that contains the variant.
void apply_variant(const std::string& name, json& root) {
  const int variant = index_of_variant(root, name);
  if (variant < 0) return;
  for_each_entry(root, "meshes", [&](std::size_t, json& mesh) {
    for_each_entry(mesh, "primitives", [&](std::size_t, json& primitive) {
      if (!primitive.contains("extensions") || !primitive["extensions"].is_object() ||
          !primitive["extensions"].contains("KHR_materials_variants"))
        return;
      json& extension = primitive["extensions"]["KHR_materials_variants"];
      if (!extension.is_object()) return;
      bool found = false;
      for_each_entry(extension, "mappings", [&](std::size_t, const json& mapping) {
        const json variants = mapping.value("variants", json());
        if (found || !variants.is_array() || !mapping.contains("material")) return;
        for (const json& one : variants) found |= one == json(variant);
        if (found) primitive["material"] = mapping["material"];
      });
    });
  });
}

// The file's nodes in the order of SceneContents::nodes.
gltf::Checked<std::vector<int>> listed_nodes(const std::string& source, const GltfEdits& edits) {
  gltf::Checked<gltf::Document> document = gltf::read_document(source, edits.asset_root);
  if (!document) return gltf::fault(document.error());
  const gltf::NodeGraph graph(*document, gltf::poses_at_rest(*document));
  std::vector<int> nodes;
  for (const gltf::NodeGraph::Listed& listed : graph.listed(edits.scene))
    nodes.push_back(listed.node);
  return nodes;
}

void mark_light_nodes(const GltfEdits& edits, const std::vector<int>& listed, json& root) {
  for_each_entry(root, "nodes", [&](std::size_t i, json& node) {
    for (const int lit : edits.light_nodes)
      if (listed.at(static_cast<std::size_t>(lit)) == static_cast<int>(i))
        object_in(node, "extras")["asos_light_fallback"] = true;
  });
}

NodeParts removed_parts(const GltfEdits& edits, const std::vector<int>& listed) {
  NodeParts parts;
  for (const NodePart& part : edits.removed)
    parts[static_cast<std::size_t>(listed.at(static_cast<std::size_t>(part.node)))].insert(
        part.primitive);
  return parts;
}

void apply_edits(const GltfEdits& edits, GltfDocument& document) {
  json& root = document.root;
  if (edits.scene >= 0) root["scene"] = edits.scene;
  if (!edits.variant.empty()) apply_variant(edits.variant, root);
  if (edits.dfrs) write_dfrs(*edits.dfrs, root);
  if (!edits.lights) return;
  remove_lights(root);
  Scene lights;
  lights.lights = *edits.lights;
  write_lights(lights, document);
  write_added_lighting(edits.added_lighting, document);
}

gltf::Checked<GltfDocument> copied(const std::string& source, const GltfEdits& edits) {
  const gltf::Checked<FileBytes> file = read_file(source, gltf::scene_file_rules());
  if (!file) return gltf::fault(file.error());
  gltf::Warnings ignored;
  const auto container = gltf::open_container(*file, ignored);
  if (!container) return gltf::fault(container.error());
  gltf::Checked<json> root = read_json(*container);
  if (!root) return gltf::fault(root.error());
  auto folders = gltf::asset_folders(std::filesystem::path(source).parent_path(), edits.asset_root);
  if (!folders) return gltf::fault(folders.error());
  gltf::ModelFiles files(std::move(*folders));
  if (!edits.light_nodes.empty() || !edits.removed.empty()) {
    const auto listed = listed_nodes(source, edits);
    if (!listed) return gltf::fault(listed.error());
    mark_light_nodes(edits, *listed, *root);
    remove_parts(removed_parts(edits, *listed), *root);
  }
  GltfDocument document(std::move(*root));
  embed_files(*container, files, document);
  apply_edits(edits, document);
  return document;
}

}  // namespace
}  // namespace exporting

Result<void> copy_gltf(const std::string& source, const std::string& path, const GltfEdits& edits) {
  // The JSON library throws where a member has another type than glTF says.
  try {
    gltf::Checked<exporting::GltfDocument> document = exporting::copied(source, edits);
    if (!document) return unexpected(Error{source, document.error()});
    return document->write(path);
  } catch (const std::bad_alloc&) {
    return unexpected(Error{source, "there is not enough memory for a copy"});
  } catch (const std::exception& e) {
    return unexpected(Error{source, fmt::format("cannot be copied ({})", e.what())});
  }
}

}  // namespace asos
