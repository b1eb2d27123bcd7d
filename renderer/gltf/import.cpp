#include "renderer/gltf/clips.h"
#include "renderer/gltf/declared_size.h"
#include "renderer/gltf/document.h"
#include "renderer/gltf/image_based_light.h"
#include "renderer/gltf/importer.h"
#include "renderer/gltf/lights_cameras.h"
#include "renderer/gltf/load.h"
#include "renderer/gltf/materials.h"
#include "renderer/gltf/variants.h"
#include "renderer/load_progress.h"
#include "renderer/scene/not_shown.h"
#include "renderer/scene/posable_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

namespace asos {

namespace gltf {
namespace {

std::vector<SceneContents::Node> nodes_of(const Document& doc, const NodeGraph& graph,
                                          const std::vector<NodeGraph::Listed>& listed) {
  // The position of each node of the file in the list; -1: it is not listed.
  std::vector<int> place(graph.size(), -1);
  std::vector<SceneContents::Node> nodes;
  nodes.reserve(listed.size());
  for (const NodeGraph::Listed& one : listed) {
    const int parent = graph.parent(one.node);
    place[static_cast<std::size_t>(one.node)] = static_cast<int>(nodes.size());
    nodes.push_back({doc.model.nodes[static_cast<std::size_t>(one.node)].name,
                     parent < 0 ? -1 : place[static_cast<std::size_t>(parent)]});
  }
  return nodes;
}

// Lists the animations, scenes, variants and nodes of the document from which `scene` was
// imported. `graph` and `shown_scene` are those of that import.
SceneContents contents_of(const Document& doc, const std::vector<Clip>& clips,
                          const NodeGraph& graph, int shown_scene, const Scene& scene) {
  const std::vector<NodeGraph::Listed> listed = graph.listed(shown_scene);
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
  for (const auto& [node, shown] : listed)
    if (shown) placed.insert(doc.model.nodes[static_cast<std::size_t>(node)].camera);
  for (std::size_t i = 0; i < doc.model.cameras.size(); ++i)
    if (!placed.contains(static_cast<int>(i))) ++contents.cameras_not_placed;
  contents.nodes = nodes_of(doc, graph, listed);
  for (const Instance& instance : scene.instances) {
    if (!scene.shows_surface(instance)) continue;
    contents.object_nodes.push_back(instance.node);
    contents.object_primitives.push_back(instance.primitive);
  }
  return contents;
}

/// A file, and the data of an import that do not depend on time.
class OpenFile final : public PosableScene, public std::enable_shared_from_this<OpenFile> {
 public:
  OpenFile(std::string path, Document document, const LoadOptions& options)
      : path_(std::move(path)), doc_(std::move(document)), options_(options), accessors_(doc_) {}

  /// Imports everything except meshes, cameras and lights.
  Checked<void> open() {
    rest_ = poses_at_rest(doc_);
    clips_ = read_clips(doc_, accessors_);
    still_.morphing_nodes = morphing_nodes(clips_);
    still_.wanted = keeps_posable();
    shown_scene_ = default_scene_ = default_scene(doc_);
    if (!options_.scene.empty()) {
      const Checked<int> chosen = find_scene(doc_, options_.scene);
      if (!chosen) return fault(chosen.error());
      shown_scene_ = *chosen;
    }
    if (shown_scene_ >= 0)
      base_.name = doc_.model.scenes[static_cast<std::size_t>(shown_scene_)].name;
    base_.source = path_;
    publish_size();
    begin_stage(LoadStage::textures);
    textures_.emplace(doc_, accessors_, base_);
    still_.moving_materials = moving_materials(clips_);
    base_.materials = import_materials(doc_, *textures_, still_.moving_materials);
    base_.surroundings = image_based_light(doc_, accessors_, shown_scene_);
    base_.added_lighting = added_lighting(doc_, shown_scene_);
    return {};
  }

  [[nodiscard]] bool keeps_posable() const { return options_.keep_posable && !clips_.empty(); }

  Checked<Scene> import(const std::optional<ClipTime>& time) {
    std::vector<NodePose> poses = rest_;
    if (time) apply_clip(clips_[static_cast<std::size_t>(time->animation)], time->seconds, poses);
    if (auto moved = move_values(time); !moved) return fault(moved.error());
    const NodeGraph graph(doc_, std::move(poses));
    accessors_.forget_zeros();
    begin_stage(LoadStage::meshes);
    // If the file is not kept, its pictures are not kept, either.
    Importer importer(doc_, accessors_, graph, still_, options_);
    Checked<Scene> scene =
        importer.run(shown_scene_, keeps_posable() ? base_ : std::exchange(base_, Scene{}));
    if (!scene) return scene;
    scene->time = time;
    scene->contents = contents_of(doc_, clips_, graph, shown_scene_, *scene);
    scene->contents.default_scene = default_scene_;
    Warnings said = doc_.warnings;
    scene->notes.warnings_dropped = said.dropped();
    scene->notes.warnings = said.take();
    if (std::optional<std::string> remark = cameras_remark(scene->contents))
      scene->notes.warnings.push_back(std::move(*remark));
    scene->notes.unsupported_extensions = doc_.unsupported_extensions;
    scene->contents.variant = options_.variant;
    scene->notes.not_shown = not_shown(scene->contents, time);
    return scene;
  }

  /// Returns the scene without anything that is placed.
  Scene images() {
    Scene scene = std::move(base_);
    scene.notes.warnings = doc_.warnings.take();
    return scene;
  }

  /// Ends loading: later warnings concern single poses.
  void end_of_loading() { said_at_load_ = doc_.warnings; }

  Result<Scene> pose(const std::optional<ClipTime>& time) override {
    const std::scoped_lock lock(mutex_);
    if (time && (time->animation < 0 || static_cast<std::size_t>(time->animation) >= clips_.size()))
      return unexpected(Error{path_, fmt::format("has {} animations, so there is no animation {}",
                                                 clips_.size(), time->animation)});
    if (time && !(time->seconds >= 0.0 && std::isfinite(time->seconds)))
      return unexpected(
          Error{path_, fmt::format("cannot be shown at a time of {} s", time->seconds)});
    try {
      doc_.warnings = said_at_load_;
      Checked<Scene> scene = import(time);
      if (!scene) return unexpected(Error{path_, scene.error()});
      scene->rig = shared_from_this();
      return std::move(*scene);
    } catch (const std::bad_alloc&) {
      return unexpected(Error{path_, "there is not enough memory for it"});
    } catch (const std::exception& e) {
      return unexpected(Error{path_, fmt::format("cannot be posed ({})", e.what())});
    }
  }

 private:
  /// Publishes the scene's size to the progress of the load, if there is one.
  void publish_size() {
    LoadProgress* const progress = LoadProgress::current();
    if (!progress) return;
    if (const auto preview = declared_size(doc_, accessors_, rest_, shown_scene_))
      progress->publish(std::make_shared<const ScenePreview>(*preview));
  }

  /// Sets the document's materials, cameras and lights to their animated values at `time`.
  Checked<void> move_values(const std::optional<ClipTime>& time) {
    if (!doc_.movable) return {};
    std::vector<AnimatedValue> values;
    if (time)
      values = animated_values(clips_[static_cast<std::size_t>(time->animation)], time->seconds);
    if (values.empty() && !values_moved_) return {};
    values_moved_ = true;
    if (auto set = set_values(*doc_.movable, values, doc_.model); !set) return set;
    base_.materials = import_materials(doc_, *textures_, still_.moving_materials);
    return {};
  }

  std::mutex mutex_;  // serializes calls of `pose`
  std::string path_;
  Document doc_;
  LoadOptions options_;
  Accessors accessors_;
  std::vector<NodePose> rest_;
  std::vector<Clip> clips_;
  StaticMeshes still_;
  int default_scene_ = -1, shown_scene_ = -1;
  Scene base_;                        // the part that is not posed: materials and their pictures
  std::optional<Textures> textures_;  // the textures of `base_`
  bool values_moved_ = false;         // since the document was read
  Warnings said_at_load_;
};

Checked<Scene> import_at_rest(const std::string& path, const LoadOptions& options) {
  begin_stage(LoadStage::reading);
  Checked<Document> document = read_document(path, options.asset_root);
  if (!document) return fault(document.error());
  if (!options.variant.empty()) {
    if (auto chosen = choose_variant(*document, options.variant); !chosen)
      return fault(chosen.error());
  }
  const auto file = std::make_shared<OpenFile>(path, std::move(*document), options);
  if (auto opened = file->open(); !opened) return fault(opened.error());
  if (options.images_only) return file->images();
  Checked<Scene> scene = file->import(std::nullopt);
  if (!scene || !file->keeps_posable()) return scene;
  file->end_of_loading();
  scene->rig = file;
  return scene;
}

}  // namespace
}  // namespace gltf

Result<Scene> import_gltf(const std::string& path, const LoadOptions& options) {
  // The underlying libraries report lack of memory and some broken data by exceptions.
  try {
    gltf::Checked<Scene> scene = gltf::import_at_rest(path, options);
    if (!scene) return unexpected(Error{path, scene.error()});
    return std::move(*scene);
  } catch (const std::bad_alloc&) {
    return unexpected(Error{path, "there is not enough memory for it"});
  } catch (const std::exception& e) {
    return unexpected(Error{path, fmt::format("cannot be read ({})", e.what())});
  }
}

}  // namespace asos
