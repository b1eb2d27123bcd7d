#include "renderer/gltf/contents.h"

#include <algorithm>
#include <set>

namespace asos::gltf {

namespace {

std::vector<SceneContents::Node> nodes_of(const Document& doc, const NodeGraph& graph,
                                          const std::vector<int>& shown) {
  // The position of each node of the file among the visible ones; -1: hidden.
  std::vector<int> place(graph.size(), -1);
  std::vector<SceneContents::Node> nodes;
  nodes.reserve(shown.size());
  for (const int index : shown) {
    const int parent = graph.parent(index);
    place[static_cast<std::size_t>(index)] = static_cast<int>(nodes.size());
    nodes.push_back({doc.model.nodes[static_cast<std::size_t>(index)].name,
                     parent < 0 ? -1 : place[static_cast<std::size_t>(parent)]});
  }
  return nodes;
}

}  // namespace

SceneContents contents_of(const Document& doc, const std::vector<Clip>& clips,
                          const NodeGraph& graph, int shown_scene, const Scene& scene) {
  const std::vector<int> shown = graph.shown(shown_scene);
  SceneContents contents;
  for (const Clip& clip : clips)
    contents.animations.push_back(
        {clip.name, clip.seconds, clip.declared_channels, clip.channels.size()});
  for (const tinygltf::Skin& skin : doc.model.skins)
    contents.skins.push_back({skin.name, skin.joints.size()});
  for (const tinygltf::Mesh& mesh : doc.model.meshes) {
    std::size_t targets = 0;
    for (const tinygltf::Primitive& p : mesh.primitives)
      targets = std::max(targets, p.targets.size());
    if (targets > 0) contents.morphs.push_back({mesh.name, targets});
  }
  for (const tinygltf::Scene& one : doc.model.scenes) contents.scenes.push_back(one.name);
  contents.shown_scene = shown_scene;
  contents.variants = doc.variants;
  std::set<int> placed;
  for (const int node : shown)
    placed.insert(doc.model.nodes[static_cast<std::size_t>(node)].camera);
  for (std::size_t i = 0; i < doc.model.cameras.size(); ++i)
    if (!placed.contains(static_cast<int>(i))) ++contents.cameras_not_placed;
  contents.nodes = nodes_of(doc, graph, shown);
  for (const Instance& instance : scene.instances)
    if (scene.shows_surface(instance)) contents.object_nodes.push_back(instance.node);
  return contents;
}

}  // namespace asos::gltf
