#include "renderer/scene/gltf/clips.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace asos::gltf {

namespace {

std::optional<Channel::Path> path_named(const std::string& name) {
  if (name == "translation") return Channel::Path::translation;
  if (name == "rotation") return Channel::Path::rotation;
  if (name == "scale") return Channel::Path::scale;
  if (name == "weights") return Channel::Path::weights;
  return std::nullopt;
}

std::size_t morph_target_count(const Document& doc, const tinygltf::Node& node) {
  if (node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= doc.model.meshes.size()) return 0;
  const tinygltf::Mesh& mesh = doc.model.meshes[static_cast<std::size_t>(node.mesh)];
  return mesh.primitives.empty() ? 0 : mesh.primitives.front().targets.size();
}

using Targets = std::set<std::pair<std::size_t, Channel::Path>>;

Checked<Channel> read_channel(const tinygltf::AnimationChannel& source,
                              const tinygltf::Animation& animation, const Document& doc,
                              Targets& targets, KeyReader& reader) {
  Channel channel;
  channel.node = static_cast<std::size_t>(source.target_node);
  if (channel.node >= doc.model.nodes.size()) return fault("its node does not exist");
  if (source.sampler < 0 || static_cast<std::size_t>(source.sampler) >= animation.samplers.size())
    return fault("its sampler does not exist");
  const std::optional<Channel::Path> path = path_named(source.target_path);
  if (!path) return fault(fmt::format("its path '{}' is not supported", source.target_path));
  channel.path = *path;
  if (!targets.emplace(channel.node, channel.path).second)
    return fault("another channel moves the same target");

  const tinygltf::Node& node = doc.model.nodes[channel.node];
  const bool weights = channel.path == Channel::Path::weights;
  const std::size_t morphs = weights ? morph_target_count(doc, node) : 1;
  if (morphs == 0) return fault("its node has nothing to morph");
  if (!weights && node.matrix.size() == 16)
    return fault("its node has a matrix, which cannot be animated");
  const int components = weights ? 1 : channel.path == Channel::Path::rotation ? 4 : 3;
  Checked<Keys> keys =
      reader.read(animation.samplers[static_cast<std::size_t>(source.sampler)], components, morphs);
  if (!keys) return fault(keys.error());
  channel.keys = std::move(*keys);
  return channel;
}

void note_clip(const Clip& clip, const std::string& place, Warnings& warnings) {
  if (clip.declared_channels == 0) warnings.add(place + " has no channels");
  for (const Channel& channel : clip.channels) {
    const std::vector<float>& times = *channel.keys.seconds;
    if (std::adjacent_find(times.begin(), times.end()) == times.end()) continue;
    warnings.add(place + " has several keys at one time; the last of them holds");
    return;
  }
}

}  // namespace

std::vector<Clip> read_clips(Document& doc, Accessors& accessors) {
  KeyReader reader(doc, accessors);
  std::vector<Clip> clips;
  for (std::size_t a = 0; a < doc.model.animations.size(); ++a) {
    const tinygltf::Animation& animation = doc.model.animations[a];
    Clip clip;
    clip.name = animation.name;
    clip.declared_channels = animation.channels.size();
    Targets targets;
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
      if (animation.channels[i].target_node < 0) continue;  // glTF: to be ignored
      Checked<Channel> channel =
          read_channel(animation.channels[i], animation, doc, targets, reader);
      if (channel) {
        clip.seconds = std::max(clip.seconds, static_cast<double>(channel->keys.seconds->back()));
        clip.channels.push_back(std::move(*channel));
      } else {
        doc.warnings.add(
            fmt::format("animation {}, channel {}: {}; ignored", a, i, channel.error()));
      }
    }
    note_clip(clip, fmt::format("animation {}", a), doc.warnings);
    clips.push_back(std::move(clip));
  }
  return clips;
}

void apply_clip(const Clip& clip, double seconds, std::vector<NodePose>& poses) {
  for (const Channel& channel : clip.channels) {
    NodePose& pose = poses[channel.node];
    std::vector<double> v = channel.keys.at(seconds);
    switch (channel.path) {
      case Channel::Path::translation:
        pose.translation = {v[0], v[1], v[2]};
        break;
      case Channel::Path::rotation:
        pose.rotation = glm::dquat(v[3], v[0], v[1], v[2]);
        break;
      case Channel::Path::scale:
        pose.scale = {v[0], v[1], v[2]};
        break;
      case Channel::Path::weights:
        pose.weights = std::move(v);
        break;
    }
  }
}

std::set<std::size_t> morphing_nodes(const std::vector<Clip>& clips) {
  std::set<std::size_t> nodes;
  for (const Clip& clip : clips) {
    for (const Channel& channel : clip.channels) {
      if (channel.path == Channel::Path::weights) nodes.insert(channel.node);
    }
  }
  return nodes;
}

}  // namespace asos::gltf
