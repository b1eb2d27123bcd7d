#include "renderer/scene/scene_warnings.h"

#include "renderer/files/printable.h"
#include "renderer/scene/extension_warnings.h"

namespace asos {

std::vector<std::string> scene_warnings(const SceneNotes& notes) {
  std::vector<std::string> lines;
  for (const std::string& warning : notes.warnings) lines.push_back(printable(warning));
  for (const std::string& extension : notes.unsupported_extensions)
    lines.push_back(unsupported_line(extension));
  for (const std::string& line : notes.not_shown) lines.push_back(printable(line));
  return lines;
}

std::uint64_t count_warnings(const SceneNotes& notes) {
  // The last warning contains the number of the dropped ones.
  const std::uint64_t more = notes.warnings_dropped > 0 ? notes.warnings_dropped - 1 : 0;
  return scene_warnings(notes).size() + more;
}

}  // namespace asos
