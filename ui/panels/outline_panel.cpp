#include "ui/panels/outline_panel.h"

#include "renderer/world/ground.h"
#include "ui/hidden_objects.h"
#include "ui/panels/inner_list.h"
#include "ui/panels/named_like.h"
#include "ui/panels/texture_list.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <numeric>
#include <utility>

namespace asos::ui {

namespace {

constexpr float list_rows = 12.5f;

std::string name_or(const std::string& name, const char* kind, std::size_t index) {
  return name.empty() ? fmt::format("{} {}", kind, index + 1) : printable(name);
}

// Builds the tree of the open scene; a reload keeps its unfolded nodes.
void follow_scene(const Previewer& previewer, OutlineChoice& choice) {
  const std::shared_ptr<const Geometry>& geometry = previewer.scene()->geometry;
  if (choice.tree_of.lock() == geometry) return;
  const std::string source = fmt::format("{} {}", geometry->contents.shown_scene, geometry->source);
  choice.tree_of = geometry;
  choice.tree = NodeTree(geometry->contents);
  if (std::exchange(choice.tree_source, source) == source) return;
  choice.open = choice.tree.open_at_first();
  choice.node = -1;
}

// The node of an index into World::parts; -1: none.
int node_of(const OpenScene& scene, int part) {
  const std::vector<int>& nodes = scene->geometry->contents.object_nodes;
  const auto place = static_cast<std::size_t>(place_among_all(part, scene.hidden()));
  return place < nodes.size() ? nodes[place] : -1;
}

bool lists_nodes(const OutlineChoice& choice) {
  return choice.by_node && choice.find.empty() && !choice.tree.empty();
}

std::size_t object_count(const OpenScene& scene) {
  return objects_without_ground(scene->world()) + scene.hidden().size();
}

std::vector<int> without(const std::vector<int>& all, const std::vector<int>& some) {
  std::vector<int> left;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(left));
  return left;
}

std::vector<int> joined(const std::vector<int>& some, const std::vector<int>& others) {
  std::vector<int> all;
  std::set_union(some.begin(), some.end(), others.begin(), others.end(), std::back_inserter(all));
  return all;
}

constexpr const char* hidden_words = "Saved pictures do not store hidden objects";
constexpr const char* no_object = "No object chosen: click one in the picture or list";

// Hides or shows all objects below a node. Returns a message.
std::string set_visible(OpenScene& scene, const NodeTree& tree, int node, bool visible) {
  const std::vector<int> objects = tree.objects(node);
  std::vector<int> hidden =
      visible ? without(scene.hidden(), objects) : joined(scene.hidden(), objects);
  if (hidden.size() >= object_count(scene)) return "No other object";
  scene.show_without(std::move(hidden));
  return visible ? "" : hidden_words;
}

// Ascending places of the selected objects among all objects.
std::vector<int> selected_places(const OpenScene& scene, const OutlineChoice& choice) {
  const bool tree_is_of_scene = choice.tree_of.lock() == scene->geometry;
  if (lists_nodes(choice) && choice.node >= 0 && tree_is_of_scene)
    return choice.tree.objects(choice.node);
  if (choice.selected < 0 ||
      choice.selected >= static_cast<int>(objects_without_ground(scene->world())))
    return {};
  return {place_among_all(choice.selected, scene.hidden())};
}

void select_none(OutlineChoice& choice) {
  choice.selected = choice.node = -1;
}

std::string buttons(Controls& controls, Previewer& previewer, OutlineChoice& choice) {
  switch (controls.buttons({{"Hide", "Hide the object with its light and shadow (H)."},
                            {"Isolate", "Show only the chosen object (Shift+H)."},
                            {"Show all", "Show all hidden objects (Alt+H)."}})) {
    case 0:
      return hide_selected(previewer.scene(), choice);
    case 1:
      return isolate_selected(previewer.scene(), choice);
    case 2:
      return show_hidden(previewer.scene());
    default:
      return {};
  }
}

// A row of the tree: arrow, visibility and name of a node. Returns a message.
std::string node_row(Controls& controls, OpenScene& scene, OutlineChoice& choice,
                     const NodeTree::Row& row) {
  const NodeTree& tree = choice.tree;
  const std::string number = std::to_string(row.node + 1);
  std::string said;
  ImGui::PushID(row.node);
  ImGui::Indent(1.0f + 0.8f * ImGui::GetFontSize() * static_cast<float>(row.depth));
  const bool open = choice.open.contains(row.node);
  if (tree.has_children(row.node)) {
    if (ImGui::ArrowButton("fold", open ? ImGuiDir_Down : ImGuiDir_Right)) {
      if (open)
        choice.open.erase(row.node);
      else
        choice.open.insert(row.node);
    }
    controls.placed("Node fold/" + number, "Show or hide the nodes below.", Controls::Use::edits);
  } else {
    ImGui::Dummy({ImGui::GetFrameHeight(), ImGui::GetFrameHeight()});
  }
  ImGui::SameLine();
  const std::size_t all = tree.object_count(row.node);
  const std::size_t hidden = tree.hidden_count(row.node, scene.hidden());
  bool visible = hidden < all;
  if (ImGui::Checkbox("##visible", &visible)) said = set_visible(scene, tree, row.node, visible);
  controls.placed("Node visible/" + number, "Show this node and all below it.",
                  Controls::Use::edits);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const std::string& name = tree.name(row.node);
  std::string text = name.empty() ? "Node " + number : printable(name);
  if (all > 1) text += fmt::format(" ({})", all);
  if (hidden > 0 && hidden < all) text += fmt::format(", {} hidden", hidden);
  if (ImGui::Selectable((text + "##name").c_str(), choice.node == row.node))
    choice.node = choice.node == row.node ? -1 : row.node;
  controls.placed("Node/" + number, "Node of the file. Click to choose it.", Controls::Use::edits);
  ImGui::Unindent(1.0f + 0.8f * ImGui::GetFontSize() * static_cast<float>(row.depth));
  ImGui::PopID();
  return said;
}

std::string node_list(Controls& controls, OpenScene& scene, OutlineChoice& choice) {
  const std::vector<NodeTree::Row> rows = choice.tree.rows(choice.open);
  std::string said;
  ImGui::BeginChild("nodes", {0.0f, list_rows * ImGui::GetTextLineHeightWithSpacing()});
  if (std::exchange(choice.scroll_to_selected, false)) {
    const auto at = std::find_if(rows.begin(), rows.end(),
                                 [&](const auto& row) { return row.node == choice.node; });
    if (at != rows.end())
      ImGui::SetScrollFromPosY(ImGui::GetCursorPosY() - ImGui::GetScrollY() +
                               static_cast<float>(at - rows.begin()) *
                                   ImGui::GetFrameHeightWithSpacing());
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()), ImGui::GetFrameHeightWithSpacing());
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      std::string told = node_row(controls, scene, choice, rows[static_cast<std::size_t>(i)]);
      if (!told.empty()) said = std::move(told);
    }
  }
  ImGui::EndChild();
  return said;
}

void material_row(Controls& controls, const Material& material, std::size_t index,
                  std::size_t objects) {
  ImGui::TextUnformatted(name_or(material.name, "Material", index).c_str());
  controls.placed("Listed material/" + std::to_string(index + 1), "Material of the scene.");
  ImGui::SameLine();
  ImGui::TextDisabled("%s", fmt::format("{}", objects).c_str());
  std::string asked;
  for (const std::string& name : extensions_of(material))
    asked += (asked.empty() ? "" : ", ") + name;
  if (asked.empty()) return;
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextDisabled("%s", asked.c_str());
  ImGui::PopTextWrapPos();
}

// Scrolls to the selected object if it is one of `objects`, which are about to be listed.
void scroll_to_selected(const std::vector<std::size_t>& objects, OutlineChoice& choice) {
  const auto at = std::lower_bound(objects.begin(), objects.end(), choice.selected,
                                   [](std::size_t i, int s) { return static_cast<int>(i) < s; });
  if (at == objects.end() || static_cast<int>(*at) != choice.selected) return;
  const auto row = static_cast<float>(at - objects.begin());
  ImGui::SetScrollFromPosY(ImGui::GetCursorPosY() - ImGui::GetScrollY() +
                           row * ImGui::GetTextLineHeightWithSpacing());
  choice.scroll_to_selected = false;
}

// Lists each material with its objects below it.
void tree(Controls& controls, const World& world, OutlineChoice& choice) {
  std::vector<std::vector<std::size_t>> objects(world.materials.size());
  const std::size_t ground = objects_without_ground(world);  // its index, if there is one
  for (std::size_t i = 0; i < world.parts.size(); ++i)
    if ((i != ground || ground == world.solid_parts()) &&
        named_like(name_or(world.parts[i].name, "Object", i), choice.find))
      objects[world.parts[i].material].push_back(i);
  const InnerList list("outline", {0.0f, list_rows * ImGui::GetTextLineHeightWithSpacing()});
  for (std::size_t m = 0; m < objects.size(); ++m) {
    if (objects[m].empty()) continue;
    material_row(controls, world.materials[m], m, objects[m].size());
    ImGui::Indent();
    if (choice.scroll_to_selected) scroll_to_selected(objects[m], choice);
    // Lays out only the visible rows: scenes have thousands of objects.
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(objects[m].size()));
    while (clipper.Step()) {
      for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
        const std::size_t i = objects[m][static_cast<std::size_t>(row)];
        const auto at = static_cast<int>(i);
        ImGui::PushID(at);
        if (ImGui::Selectable(name_or(world.parts[i].name, "Object", i).c_str(),
                              at == choice.selected))
          choice.selected = at == choice.selected ? -1 : at;
        controls.placed("Object/" + std::to_string(i + 1),
                        "Object with this material. Click to choose it.", Controls::Use::edits);
        ImGui::PopID();
      }
    }
    ImGui::Unindent();
  }
}

}  // namespace

std::vector<std::string> extensions_of(const Material& m) {
  const Material usual;
  struct Asked {
    bool used;
    const char* name;
  };
  const Asked all[] = {
      {m.anisotropy.used(), "anisotropy"},
      {m.coat.factor > 0.0f, "clearcoat"},
      {m.diffuse_transmission.used(), "diffuse_transmission"},
      {m.volume.dispersion > 0.0f, "dispersion"},
      {m.emissive_strength != usual.emissive_strength, "emissive_strength"},
      {m.ior != usual.ior, "ior"},
      {m.film.used(), "iridescence"},
      {m.sheen.used(), "sheen"},
      {m.specular != usual.specular || m.specular_color != usual.specular_color ||
           m.specular_texture.used() || m.specular_color_texture.used(),
       "specular"},
      {m.transmission > 0.0f, "transmission"},
      {m.unlit, "unlit"},
      {m.volume.thickness > 0.0f, "volume"},
  };
  std::vector<std::string> names;
  for (const Asked& asked : all)
    if (asked.used) names.push_back(std::string("KHR_materials_") + asked.name);
  return names;
}

int object_at(const Previewer& previewer, glm::ivec2 pixel) {
  const Hit hit = previewer.viewpoint().seen_at(pixel.x + 0.5, pixel.y + 0.5);
  if (!hit.valid()) return -1;
  const World& world = previewer.scene()->world();
  const auto part = static_cast<int>(world.triangle_part[hit.triangle]);
  return part < static_cast<int>(objects_without_ground(world)) ? part : -1;
}

void select_at(const Previewer& previewer, OutlineChoice& choice,
               std::optional<glm::ivec2> pointed) {
  if (!previewer.scene() || pointed == choice.followed) return;
  choice.followed = pointed;
  if (!pointed) return;
  follow_scene(previewer, choice);
  choice.selected = object_at(previewer, *pointed);
  choice.scroll_to_selected = choice.selected >= 0;
  choice.node = choice.selected >= 0 ? node_of(previewer.scene(), choice.selected) : -1;
  if (choice.node < 0 || choice.tree.empty()) return;
  for (const int above : choice.tree.above(choice.node)) choice.open.insert(above);
}

std::vector<int> selected_objects(const OpenScene& scene, const OutlineChoice& choice) {
  if (!scene) return {};
  std::vector<int> parts;
  const std::vector<int>& hidden = scene.hidden();
  for (const int place : selected_places(scene, choice)) {
    const auto at = std::lower_bound(hidden.begin(), hidden.end(), place);
    if (at == hidden.end() || *at != place)
      parts.push_back(place - static_cast<int>(at - hidden.begin()));
  }
  return parts;
}

std::string hide_selected(OpenScene& scene, OutlineChoice& choice) {
  const std::vector<int> places = scene ? selected_places(scene, choice) : std::vector<int>{};
  if (places.empty()) return no_object;
  std::vector<int> hidden = joined(scene.hidden(), places);
  if (hidden.size() >= object_count(scene)) return "No other object";
  scene.show_without(std::move(hidden));
  select_none(choice);
  return hidden_words;
}

std::string isolate_selected(OpenScene& scene, OutlineChoice& choice) {
  const std::vector<int> places = scene ? selected_places(scene, choice) : std::vector<int>{};
  if (places.empty()) return no_object;
  std::vector<int> all(object_count(scene));
  std::iota(all.begin(), all.end(), 0);
  std::vector<int> hidden = without(all, places);
  if (hidden.size() == scene.hidden().size()) return "No other object";
  scene.show_without(std::move(hidden));
  select_none(choice);
  return hidden_words;
}

std::string show_hidden(OpenScene& scene) {
  if (!scene.hides()) return "Nothing hidden";
  scene.show_all();
  return "All objects shown";
}

std::string outline_panel(Controls& controls, Previewer& previewer, OutlineChoice& choice) {
  if (!previewer.scene()) return {};
  follow_scene(previewer, choice);
  if (!controls.section("Objects", false)) return {};
  const std::size_t objects = parts_without_ground(previewer.scene()->world());
  if (!choice.tree.empty()) {
    constexpr std::array lists{
        Controls::Option{"Nodes", "The file's tree of nodes."},
        Controls::Option{"Materials", "Materials, and the objects that have them."},
    };
    int list = choice.by_node ? 0 : 1;
    if (controls.options("List by", lists, list, {true, 0})) choice.by_node = list == 0;
  }
  std::string said = buttons(controls, previewer, choice);
  const std::size_t hidden = previewer.scene().hidden().size();
  controls.row(
      "Objects",
      hidden > 0 ? fmt::format("{}, and {} hidden", objects, hidden) : fmt::format("{}", objects),
      "Visible objects, one material each.");
  controls.text_field("Find object", "List only objects whose names contain these letters.",
                      "Find an object", choice.find);
  if (!lists_nodes(choice)) {
    tree(controls, previewer.scene()->world(), choice);
  } else if (std::string told = node_list(controls, previewer.scene(), choice); !told.empty()) {
    said = std::move(told);
  }
  const World& world = previewer.scene()->world();
  if (const std::vector<int> chosen = selected_objects(previewer.scene(), choice);
      chosen.size() == 1)
    texture_list(controls, world,
                 world.materials[world.parts[static_cast<std::size_t>(chosen[0])].material]);
  return said;
}

}  // namespace asos::ui
