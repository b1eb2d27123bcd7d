#include "renderer/gltf/clips.h"

#include "renderer/gltf/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
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

const tinygltf::Mesh* mesh_of(const Document& doc, const tinygltf::Node& node) {
  if (node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= doc.model.meshes.size())
    return nullptr;
  return &doc.model.meshes[static_cast<std::size_t>(node.mesh)];
}

std::size_t morph_target_count(const Document& doc, const tinygltf::Node& node) {
  const tinygltf::Mesh* mesh = mesh_of(doc, node);
  return mesh && !mesh->primitives.empty() ? mesh->primitives.front().targets.size() : 0;
}

/// The targets of an animation's channels as pointers. Channels conflict if their targets are equal
/// or one contains the other.
class Targets {
 public:
  [[nodiscard]] bool add(const std::string& target) {
    const auto within = known_.lower_bound(target + '/');
    const bool holds = within != known_.end() && within->starts_with(target + '/');
    const bool is_held = known_.contains(target.substr(0, target.rfind('/')));
    return !holds && !is_held && known_.insert(target).second;
  }

 private:
  std::set<std::string> known_;
};

constexpr const char* moved_twice = "another channel moves the same target";

/// Returns the pointer of a channel that is not one of glTF's own paths.
std::string pointer_of(const tinygltf::AnimationChannel& source) {
  const auto* e = extension(source.target_extensions, "KHR_animation_pointer");
  return e && source.target_path == "pointer" ? text(*e, "pointer") : std::string();
}

class ChannelReader {
 public:
  ChannelReader(const tinygltf::Animation& animation, const Document& doc, KeyReader& reader)
      : animation_(animation), doc_(doc), reader_(reader) {}

  Checked<Channel> read(const tinygltf::AnimationChannel& source) {
    if (source.sampler < 0 ||
        static_cast<std::size_t>(source.sampler) >= animation_.samplers.size())
      return fault("its sampler does not exist");
    sampler_ = &animation_.samplers[static_cast<std::size_t>(source.sampler)];
    return source.target_node < 0 ? read_value(pointer_of(source)) : read_node(source);
  }

 private:
  Checked<Channel> read_value(const std::string& pointer) {
    Channel channel;
    channel.path = Channel::Path::value;
    channel.pointer = pointer;
    if (!targets_.add(pointer)) return fault(moved_twice);
    return with_keys(std::move(channel), *movable_numbers(pointer), 1);
  }

  Checked<Channel> read_node(const tinygltf::AnimationChannel& source) {
    Channel channel;
    channel.node = static_cast<std::size_t>(source.target_node);
    if (channel.node >= doc_.model.nodes.size()) return fault("its node does not exist");
    const tinygltf::Node& node = doc_.model.nodes[channel.node];
    const std::size_t targets = morph_target_count(doc_, node);
    std::string target = source.target_path;
    if (const std::string pointer = pointer_of(source); pointer.ends_with("/visible")) {
      target = "visible";
      channel.path = Channel::Path::visible;
      if (sampler_->interpolation != "STEP") return fault("what is visible only changes by steps");
    } else if (!pointer.empty()) {
      target = pointer.substr(pointer.find("weights/"));
      channel.path = Channel::Path::one_weight;
      const std::string number = target.substr(target.find('/') + 1);
      const auto [end, error] =
          std::from_chars(number.data(), number.data() + number.size(), channel.weight);
      if (error != std::errc() || *end != '\0' || channel.weight >= targets)
        return fault(fmt::format("its node has no weight '{}'", number));
      const std::vector<double>& own =
          node.weights.empty() ? mesh_of(doc_, node)->weights : node.weights;
      channel.weights_at_rest = own;
      channel.weights_at_rest.resize(targets, 0.0);
    } else if (const std::optional<Channel::Path> path = path_named(target)) {
      channel.path = *path;
    } else {
      return fault(fmt::format("its path '{}' is not supported", target));
    }
    if (!targets_.add(fmt::format("/nodes/{}/{}", channel.node, target))) return fault(moved_twice);
    if (channel.path == Channel::Path::weights) {
      if (targets == 0) return fault("its node has nothing to morph");
      return with_keys(std::move(channel), 1, targets);
    }
    if (channel.path == Channel::Path::one_weight || channel.path == Channel::Path::visible)
      return with_keys(std::move(channel), 1, 1);
    if (node.matrix.size() == 16) return fault("its node has a matrix, which cannot be animated");
    return with_keys(std::move(channel), channel.path == Channel::Path::rotation ? 4 : 3, 1);
  }

  Checked<Channel> with_keys(Channel channel, int components, std::size_t groups) {
    const bool rotation = channel.path == Channel::Path::rotation;
    Checked<Keys> keys = reader_.read(*sampler_, components, groups, rotation);
    if (!keys) return fault(keys.error());
    channel.keys = std::move(*keys);
    return channel;
  }

  const tinygltf::Animation& animation_;
  const Document& doc_;
  KeyReader& reader_;
  Targets targets_;
  const tinygltf::AnimationSampler* sampler_ = nullptr;
};

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
    ChannelReader channels(animation, doc, reader);
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
      const tinygltf::AnimationChannel& source = animation.channels[i];
      if (source.target_node < 0 && pointer_of(source).empty()) continue;  // glTF requires this
      Checked<Channel> channel = channels.read(source);
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
    if (channel.path == Channel::Path::value) continue;
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
      case Channel::Path::one_weight:
        if (pose.weights.size() < channel.weights_at_rest.size())
          pose.weights = channel.weights_at_rest;
        pose.weights[channel.weight] = v[0];
        break;
      case Channel::Path::visible:
        pose.visible = v[0] != 0.0;
        break;
      case Channel::Path::value:
        break;
    }
  }
}

std::vector<AnimatedValue> animated_values(const Clip& clip, double seconds) {
  std::vector<AnimatedValue> values;
  for (const Channel& channel : clip.channels) {
    if (channel.path == Channel::Path::value)
      values.push_back({channel.pointer, channel.keys.at(seconds)});
  }
  return values;
}

std::set<std::size_t> moving_materials(const std::vector<Clip>& clips) {
  std::set<std::size_t> materials;
  for (const Clip& clip : clips) {
    for (const Channel& channel : clip.channels) {
      if (channel.path != Channel::Path::value) continue;
      if (const auto material = material_of(channel.pointer)) materials.insert(*material);
    }
  }
  return materials;
}

std::set<std::size_t> morphing_nodes(const std::vector<Clip>& clips) {
  std::set<std::size_t> nodes;
  for (const Clip& clip : clips) {
    for (const Channel& channel : clip.channels) {
      const bool all = channel.path == Channel::Path::weights;
      if (all || channel.path == Channel::Path::one_weight) nodes.insert(channel.node);
    }
  }
  return nodes;
}

}  // namespace asos::gltf
