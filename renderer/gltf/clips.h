#pragma once

#include "renderer/gltf/animated_values.h"
#include "renderer/gltf/keys.h"
#include "renderer/gltf/nodes.h"

#include <set>
#include <string>
#include <vector>

namespace asos::gltf {

/// One number or vector that an animation moves: a property of a node, or one that
/// animated_values.h supports.
struct Channel {
  enum class Path { translation, rotation, scale, weights, one_weight, visible, value };

  std::size_t node = 0;
  Path path = Path::translation;
  std::size_t weight = 0;               ///< one_weight: its index
  std::vector<double> weights_at_rest;  ///< one_weight: all weights
  std::string pointer;                  ///< value: pointer to its target
  Keys keys;
};

/// The readable part of an animation.
struct Clip {
  std::string name;
  double seconds = 0.0;  ///< time of its last key
  std::size_t declared_channels = 0;
  std::vector<Channel> channels;  ///< with distinct targets
};

/// Reads all animations of a file. Channels that are invalid, or have unsupported targets, are left
/// out with a warning.
[[nodiscard]] std::vector<Clip> read_clips(Document& document, Accessors& accessors);

/// Sets the poses of the nodes that `clip` moves to those at `seconds`.
void apply_clip(const Clip& clip, double seconds, std::vector<NodePose>& poses);

/// Returns the values besides poses that `clip` moves, at `seconds`.
[[nodiscard]] std::vector<AnimatedValue> animated_values(const Clip& clip, double seconds);

/// Returns the materials that any of the clips moves.
[[nodiscard]] std::set<std::size_t> moving_materials(const std::vector<Clip>& clips);

/// Returns the nodes whose morph weights any of the clips moves.
[[nodiscard]] std::set<std::size_t> morphing_nodes(const std::vector<Clip>& clips);

}  // namespace asos::gltf
