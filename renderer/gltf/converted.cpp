#include "renderer/gltf/converted.h"

#include "renderer/files/helper_program.h"
#include "renderer/files/printable.h"
#include "renderer/load_progress.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

namespace asos::gltf {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 9> endings{".3ds", ".3mf", ".dae", ".fbx", ".obj",
                                                  ".off", ".ply", ".stl", ".x3d"};

constexpr ProgramLimits limits{.processor_seconds = 120,
                               .memory_bytes = std::uint64_t{8} << 30,
                               .file_bytes = std::uint64_t{2} << 30};
constexpr std::chrono::seconds patience{
    240};  // a program that waits for ever uses no processor time

constexpr const char* losses =
    "was converted by assimp, which may lose units, cameras, animations and parts of materials";

/// A temporary folder, which is removed with all that is in it.
class Folder {
 public:
  Folder() {
    std::error_code ignored;
    path_ = (fs::temp_directory_path(ignored) / "asos-converted-XXXXXX").string();
    if (!mkdtemp(path_.data())) path_.clear();
  }
  ~Folder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

Result<void> convert(const std::string& from, const std::string& to) {
  const std::string assimp = find_program("assimp");
  if (assimp.empty())
    return unexpected(Error{from, "needs the program assimp: sudo apt-get install assimp-utils"});
  std::error_code error;
  const std::string whole = fs::absolute(from, error).string();
  const auto last = std::chrono::steady_clock::now() + patience;
  Result<void> ended = run_program(
      {assimp, "export", whole, to, "-fglb2", "-embtex", "-gsn"}, "",
      [&] {
        const LoadProgress* progress = LoadProgress::current();
        return std::chrono::steady_clock::now() > last || (progress && progress->stopped());
      },
      limits, QuotedOutput::all);
  stop_point();
  if (!ended) return unexpected(Error{from, ended.error().message()});
  if (!fs::exists(to, error)) return unexpected(Error{from, "assimp made no file of it"});
  return {};
}

/// Replaces bytes of a GLB's JSON that are not UTF-8 by underscores: assimp copies names in the
/// encoding of the model.
void mend_names(const std::string& path) {
  constexpr std::streamoff length_at = 12, json_at = 20;
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  std::array<unsigned char, 4> length{};
  file.seekg(length_at).read(reinterpret_cast<char*>(length.data()), length.size());
  std::uint32_t size = 0;
  for (int i = 3; i >= 0; --i) size = size << 8 | length[static_cast<std::size_t>(i)];
  std::error_code error;
  if (!file || json_at + std::uintmax_t{size} > fs::file_size(path, error) || error) return;
  std::string json(size, ' ');
  file.seekg(json_at).read(json.data(), static_cast<std::streamsize>(size));
  if (!file || is_utf8(json)) return;
  for (std::size_t i = 0; i < json.size();) {
    const std::size_t bytes = utf8_length(std::string_view(json).substr(i));
    if (bytes == 0) json[i] = '_';
    i += std::max<std::size_t>(bytes, 1);
  }
  file.seekp(json_at).write(json.data(), static_cast<std::streamsize>(size));
}

}  // namespace

bool is_convertible(std::string_view path) {
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

Result<Scene> import_converted(const std::string& path, LoadOptions options) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return unexpected(Error{path, "there is no such file"});
  const Folder folder;
  if (folder.path().empty()) return unexpected(Error{path, "no temporary folder can be made"});
  const std::string made = folder.path() + "/model.glb";
  if (auto done = convert(path, made); !done) return unexpected(done.error());
  mend_names(made);
  options.asset_root = folder.path();
  Result<Scene> scene = import_gltf(made, options);
  if (!scene) return unexpected(Error{path, scene.error().reason});
  if (scene->meshes.empty()) return unexpected(Error{path, "assimp found nothing to show in it"});
  scene->source = path;
  scene->notes.warnings.emplace_back(losses);
  return scene;
}

}  // namespace asos::gltf
