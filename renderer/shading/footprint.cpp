#include "renderer/shading/footprint.h"

namespace asos {

PixelSpacing PixelSpacing::of(const View& view) {
  const Frame whole = view.frame(0, 0, view.width(), view.height());
  return {!whole.parallel(), glm::vec3(whole.direction()),
          glm::vec3(whole.base_u() / static_cast<double>(view.width())),
          glm::vec3(whole.base_v() / static_cast<double>(view.height())),
          static_cast<float>(view.start())};
}

}  // namespace asos
