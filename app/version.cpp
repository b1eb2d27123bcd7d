#include "app/version.h"

#include "app/report/machine.h"
#include "renderer/kernels/instruction_set.h"

#include <fmt/format.h>

namespace asos {

std::string version_text() {
  const Machine machine = this_machine();
  return fmt::format(
      "asos {}\n"
      "commit: {}\n"
      "compiler: {}\n"
      "instruction set: {}\n"
      "scenes: glTF 2.0 (.gltf, .glb), Draco, meshopt\n"
      "textures: PNG, JPEG, WebP\n"
      "skies: .hdr, .exr\n"
      "pictures: PNG, EXR",
      machine.version, machine.commit, machine.compiler, instruction_set());
}

}  // namespace asos
