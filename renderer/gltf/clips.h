#pragma once

#include "renderer/gltf/keys.h"
#include "renderer/gltf/moved_values.h"
#include "renderer/gltf/nodes.h"

#include <set>
#include <string>
#include <vector>

namespace asos::gltf {

/// One number or vector that an animation moves: of a node, or of what moved_values.h knows.
struct Channel {
  enum class Path { translation, rotation, scale, weights, one_weight, visible, value };

  std::size_t node = 0;
  Path path = Path::translation;
  std::size_t weight = 0;               ///< one_weight: which of
  std::vector<double> weights_at_rest;  ///< these
  std::string pointer;                  ///< value: what it aims at
  Keys keys;
};

/// An animation, as far as it can be read.
struct Clip {
  std::string name;
  double seconds = 0.0;  ///< its last key's time
  std::size_t declared_channels = 0;
  std::vector<Channel> channels;  ///< each of another target
};

/// All animations of a file. Channels that are not valid, or move what is not read, are left out
/// with a warning.
[[nodiscard]] std::vector<Clip> read_clips(Document& document, Accessors& accessors);

/// Moves the nodes that `clip` moves to where it has them at `seconds`.
void apply_clip(const Clip& clip, double seconds, std::vector<NodePose>& poses);

/// What else it moves, as it is at `seconds`.
[[nodiscard]] std::vector<MovedValue> moved_values(const Clip& clip, double seconds);

/// The materials that any of the clips moves.
[[nodiscard]] std::set<std::size_t> moving_materials(const std::vector<Clip>& clips);

/// The nodes whose morph weights any of the clips moves.
[[nodiscard]] std::set<std::size_t> morphing_nodes(const std::vector<Clip>& clips);

}  // namespace asos::gltf
