#pragma once

#include "renderer/pyray/subdivision_trace.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace asos {

/// A pyray that a leaf sent on, to a light or by way of a mirror. Places are in its own square, u
/// to the right and v down, 0 to 1.
struct LoggedPyray {
  enum class Kind { shadow, mirror };

  Kind kind = Kind::shadow;
  std::uint32_t light = 0;       ///< shadow: index into World::lights
  int bounces = 0;               ///< mirrors on the way to its leaf
  int parent = -1;               ///< in the log, of the mirrored pyray whose leaf sent it; -1: none
  glm::vec2 from{0.0f};          ///< that leaf's sample, in the parent's square or the root frame
  double weight = 1.0;           ///< that leaf's share of its root
  glm::vec3 result{0.0f};        ///< mean radiance that comes back; shadow: the light's lit share
  SubdivisionTrace subdivision;  ///< none of a single ray
  std::vector<glm::vec3> leaves;  ///< the same of each leaf, in the order of the cells' leaves
};

/// What the leaves of one root sent on, in the order in which it happened; `most` at most. Who
/// shades leaves says which one is shaded; who traces pyrays writes them down.
class PyrayLog {
 public:
  static constexpr std::size_t most = 500;

  /// The leaf that pyrays come from now. Returns what was before, to be put back.
  struct Leaf {
    bool logged = false;
    int parent = -1;
    glm::vec2 from{0.0f};
    double weight = 1.0;
  };
  Leaf set_leaf(Leaf leaf) { return std::exchange(leaf_, leaf); }
  [[nodiscard]] const Leaf& leaf() const { return leaf_; }
  [[nodiscard]] bool wants_more() const { return leaf_.logged && pyrays_.size() < most; }

  /// A pyray of the present leaf; its index.
  int add(LoggedPyray::Kind kind) {
    LoggedPyray& pyray = pyrays_.emplace_back();
    pyray.kind = kind;
    pyray.parent = leaf_.parent;
    pyray.from = leaf_.from;
    pyray.weight = leaf_.weight;
    return static_cast<int>(pyrays_.size()) - 1;
  }
  [[nodiscard]] LoggedPyray& at(int index) { return pyrays_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const std::vector<LoggedPyray>& pyrays() const { return pyrays_; }

 private:
  Leaf leaf_;
  std::vector<LoggedPyray> pyrays_;
};

}  // namespace asos
