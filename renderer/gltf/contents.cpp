#include "renderer/gltf/contents.h"

#include <algorithm>
#include <set>

namespace asos::gltf {

SceneContents contents_of(const Document& doc, const std::vector<Clip>& clips,
                          const std::vector<int>& shown, int shown_scene) {
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
  for (const tinygltf::Scene& scene : doc.model.scenes) contents.scenes.push_back(scene.name);
  contents.shown_scene = shown_scene;
  contents.variants = doc.variants;
  std::set<int> placed;
  for (const int node : shown)
    placed.insert(doc.model.nodes[static_cast<std::size_t>(node)].camera);
  for (std::size_t i = 0; i < doc.model.cameras.size(); ++i)
    if (!placed.contains(static_cast<int>(i))) ++contents.cameras_not_placed;
  return contents;
}

}  // namespace asos::gltf
