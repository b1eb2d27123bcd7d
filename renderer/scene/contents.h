#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace asos {

/// A moment of an animation of a file. Before the animation's first key and after its last one
/// nothing moves.
struct ClipTime {
  int animation = 0;     ///< index into SceneContents::animations
  double seconds = 0.0;  ///< at least 0

  bool operator==(const ClipTime&) const = default;
};

/// A file's contents that a single picture does not show: animations, and the alternatives that the
/// user can choose. Names may be empty and are as in the file.
struct SceneContents {
  struct Animation {
    std::string name;
    double seconds = 0.0;      ///< from time 0 to its last key
    std::size_t channels = 0;  ///< that the file declares
    std::size_t moving = 0;    ///< of these, the ones that the importer supports
  };
  struct Skin {
    std::string name;
    std::size_t joints = 0;
  };
  /// A mesh with morph targets.
  struct Morph {
    std::string mesh;
    std::size_t targets = 0;
  };

  /// A node of the shown scene, visible or not: the same nodes in all poses.
  struct Node {
    std::string name;
    int parent = -1;  ///< index into `nodes`; -1: none
  };

  std::vector<Animation> animations;
  std::vector<Skin> skins;
  std::vector<Morph> morphs;
  std::vector<std::string> scenes;    ///< names of the file's scenes
  int shown_scene = -1;               ///< index into `scenes`; -1: all nodes
  int default_scene = -1;             ///< the one that is shown by default
  std::vector<std::string> variants;  ///< KHR_materials_variants
  std::string variant;                ///< the one that is shown; empty: none
  std::vector<Node> nodes;            ///< parents first; empty: the scene has no hierarchy
  /// Index into `nodes` for each instance that shows a surface, in the scene's order.
  std::vector<int> object_nodes;
  /// Like `object_nodes`: Instance::primitive.
  std::vector<int> object_primitives;
  std::size_t cameras_not_placed = 0;  ///< cameras of the file that no shown node refers to
};

}  // namespace asos
