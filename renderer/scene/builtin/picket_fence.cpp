#include "renderer/scene/builtin/picket_fence.h"

#include "renderer/scene/builtin/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>

namespace asos::builtin {

void add_picket_fence(Mesh& mesh, const PicketFence& fence) {
  const float w = fence.width, h = fence.height, shoulder = h - 0.8f * w;
  const std::array<glm::vec2, 5> outline{
      {{0.0f, 0.0f}, {w, 0.0f}, {w, shoulder}, {0.5f * w, h}, {0.0f, shoulder}}};
  for (int i = 0; i < fence.pickets; ++i) {
    const glm::vec3 at(fence.spacing * static_cast<float>(i), 0.0f, 0.0f);
    add_prism(mesh, outline, 0.02f, glm::translate(glm::mat4(1.0f), at));
  }
  // Rails end slightly inside the outer pickets, so that no edge of a rail lies on a picket's edge.
  const float length = fence.spacing * static_cast<float>(fence.pickets - 1) + w;
  for (const float y : {0.22f * h, 0.68f * h}) {
    add_box(mesh, {0.1f * w, y, -0.03f}, {length - 0.1f * w, y + 0.07f * h, 0.0f});
  }
}

}  // namespace asos::builtin
