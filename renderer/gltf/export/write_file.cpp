#include "renderer/film/image_io.h"
#include "renderer/gltf/export/gltf_writer.h"

namespace asos::exporting {

Result<void> write_atomically(const std::string& path, const std::string& bytes) {
  return write_file_atomically(path, {bytes.begin(), bytes.end()});
}

}  // namespace asos::exporting
