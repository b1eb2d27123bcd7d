#include "ui/hidden_objects.h"

#include <algorithm>
#include <cstddef>

namespace asos {

void leave_out(Scene& scene, const std::vector<int>& hidden) {
  if (hidden.empty()) return;
  int place = -1;
  std::erase_if(scene.instances, [&](const Instance& instance) {
    const bool shows = instance.shape >= 0 ||
                       (instance.mesh >= 0 &&
                        !scene.meshes[static_cast<std::size_t>(instance.mesh)].triangles.empty());
    if (!shows) return false;
    ++place;
    return std::binary_search(hidden.begin(), hidden.end(), place);
  });
  scene.rig.reset();
}

int place_among_all(int shown, const std::vector<int>& hidden) {
  for (const int place : hidden) shown += place <= shown ? 1 : 0;
  return shown;
}

}  // namespace asos
