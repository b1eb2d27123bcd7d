#pragma once

#include "renderer/scene/gltf/keys.h"
#include "renderer/scene/gltf/nodes.h"

#include <set>
#include <string>
#include <vector>

namespace asos::gltf {

/// One number or vector of a node that an animation moves.
struct Channel {
  enum class Path { translation, rotation, scale, weights };

  std::size_t node = 0;
  Path path = Path::translation;
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

/// The nodes whose morph weights any of the clips moves.
[[nodiscard]] std::set<std::size_t> morphing_nodes(const std::vector<Clip>& clips);

}  // namespace asos::gltf
