#include "renderer/gltf/document.h"

#include "renderer/gltf/animated_values.h"
#include "renderer/gltf/container.h"
#include "renderer/gltf/tidy.h"
#include "renderer/gltf/tidy_animations.h"
#include "renderer/gltf/tidy_entries.h"
#include "renderer/load_progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

namespace asos::gltf {
using nlohmann::json;

namespace {

std::optional<std::size_t> whole_number(const std::string& text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end) return std::nullopt;
  return number;
}

std::string scene_list(const std::vector<tinygltf::Scene>& scenes) {
  constexpr std::size_t most_listed = 32;
  std::string text;
  for (std::size_t i = 0; i < std::min(scenes.size(), most_listed); ++i) {
    const std::string& name = scenes[i].name;
    text += fmt::format("{}{}{}", i ? ", " : "", i, name.empty() ? "" : " ('" + name + "')");
  }
  if (scenes.size() > most_listed) text += fmt::format(" and {} more", scenes.size() - most_listed);
  return text;
}

constexpr std::uint64_t largest_json = std::uint64_t{1} << 30;
// tinygltf and its JSON library walk a document recursively.
constexpr std::size_t deepest_nesting = 200;

/// Returns the reason in an exception's or tinygltf's text, on one line and of bounded length.
std::string one_line(std::string text) {
  if (text.starts_with("[json.exception.")) text.erase(0, text.find("] ") + 2);
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() > 300) text = text.substr(0, 297) + "...";
  return text;
}

/// Iterates over a text, with stop points.
class StoppableText {
 public:
  using value_type = std::uint8_t;
  using difference_type = std::ptrdiff_t;
  using reference = const std::uint8_t&;
  using pointer = const std::uint8_t*;
  using iterator_category = std::input_iterator_tag;

  explicit StoppableText(pointer at) : at_(at) {}
  [[nodiscard]] reference operator*() const { return *at_; }
  StoppableText& operator++() {
    if (++passed_ % between_stops == 0) stop_point();
    ++at_;
    return *this;
  }
  StoppableText operator++(int) {
    const StoppableText before = *this;
    ++*this;
    return before;
  }
  bool operator==(const StoppableText& other) const { return at_ == other.at_; }
  bool operator!=(const StoppableText& other) const { return at_ != other.at_; }

 private:
  static constexpr std::size_t between_stops = std::size_t{1} << 17;

  pointer at_;
  std::size_t passed_ = 0;
};

Checked<json> parse(Bytes text, Warnings& warnings) {
  if (text.size() > largest_json) return fault("the JSON is larger than 1 GiB");
  if (nesting_depth(text) > deepest_nesting) {
    return fault(fmt::format("the JSON is nested more than {} levels deep", deepest_nesting));
  }
  if (text.size() >= 3 && text[0] == 0xef && text[1] == 0xbb && text[2] == 0xbf) {
    warnings.add("the JSON begins with a byte order mark, which glTF does not allow");
  }
  try {
    json root = json::parse(StoppableText(text.data()), StoppableText(text.data() + text.size()));
    if (!root.is_object()) return fault("the JSON is not an object");
    return root;
  } catch (const json::exception& e) {
    return fault("the JSON is broken: " + one_line(e.what()));
  }
}

std::string text_of(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Returns the names of the file's variants by KHR_materials_variants.
std::vector<std::string> variants_of(const json& root) {
  std::vector<std::string> names;
  const auto list = root.find("extensions");
  if (list == root.end() || !list->is_object()) return names;
  const auto extension = list->find("KHR_materials_variants");
  if (extension == list->end() || !extension->is_object()) return names;
  const auto variants = extension->find("variants");
  if (variants == extension->end() || !variants->is_array()) return names;
  for (const json& variant : *variants)
    names.push_back(variant.is_object() ? text_of(variant, "name") : std::string());
  return names;
}

Buffer missing(std::string reason) {
  return Buffer{{}, {}, std::move(reason)};
}

Buffer holding(FileBytes bytes) {
  Buffer buffer{std::make_shared<const FileBytes>(std::move(bytes)), {}, {}};
  buffer.bytes = *buffer.held;
  return buffer;
}

/// Files by path; each is read once, even if it is named several times.
using FilesRead = std::map<std::filesystem::path, Buffer>;

/// Reads a named file; `place` is the buffer's name in warnings.
Buffer read_named(Document& doc, const std::string& place, const std::string& uri,
                  FilesRead& files) {
  const Checked<UriFile> file = doc.files.find(uri);
  const auto known = file ? files.find(file->path) : files.end();
  if (known != files.end()) return known->second;
  Checked<UriBytes> read = doc.files.read(uri);
  if (read && !read->remark.empty())
    doc.warnings.add(fmt::format("{} '{}': {}", place, shown_uri(uri), read->remark));
  Buffer buffer = read ? holding(std::move(read->bytes)) : missing(read.error());
  if (file) files.emplace(file->path, buffer);
  return buffer;
}

/// Reads one buffer; `bin` is the GLB's binary chunk for the buffer that has it, else null.
Buffer read_buffer(const json& declared, Document& doc, const std::string& place, const Bytes* bin,
                   FilesRead& files) {
  if (!declared.is_object()) return missing("is not an object");
  if (declared.contains("uri")) {
    if (!declared["uri"].is_string()) return missing("has a uri that is not a text");
    return read_named(doc, place, declared["uri"].get_ref<const std::string&>(), files);
  }
  return bin ? holding(FileBytes(bin->begin(), bin->end())) : missing("has no data");
}

/// Removes the buffers from the JSON and reads them.
Checked<void> take_buffers(json& root, const Container& container, Document& doc) {
  const auto found = root.find("buffers");
  if (found == root.end()) return {};
  if (!found->is_array()) return fault("/buffers is not a list");
  FilesRead files;
  std::set<const FileBytes*> counted;
  for (std::size_t i = 0; i < found->size(); ++i) {
    const json& declared = (*found)[i];
    const bool is_bin = i == 0 && container.has_bin;
    const std::string place = fmt::format("buffer {}", i);
    Buffer buffer = read_buffer(declared, doc, place, is_bin ? &container.bin : nullptr, files);
    if (!buffer.missing_because.empty()) {
      // A buffer without a uri may be a placeholder for decompressed data
      // (EXT_meshopt_compression).
      const std::string text = place + ": " + buffer.missing_because;
      const bool placeholder = declared.is_object() && !declared.contains("uri");
      placeholder ? doc.warnings.add(text) : doc.warnings.add_loss(text);
    } else if (!declared.contains("byteLength") || declared["byteLength"] == 0) {
      doc.warnings.add(fmt::format("buffer {} declares no length", i));
    } else if (const auto length = declared["byteLength"].get<std::uint64_t>();
               length > buffer.bytes.size()) {
      doc.warnings.add(fmt::format("buffer {} declares {} bytes, but has only {}", i, length,
                                   buffer.bytes.size()));
    } else {
      buffer.bytes = buffer.bytes.first(static_cast<std::size_t>(length));
    }
    // A file counts once, even if it is named several times.
    if (buffer.held && counted.insert(buffer.held.get()).second)
      doc.honest_bytes += buffer.held->size();
    doc.buffers.push_back(std::move(buffer));
  }
  root.erase(found);
  return {};
}

/// Removes the images from the JSON, so that tinygltf neither reads nor decodes them.
Checked<void> take_images(json& root, Document& doc) {
  const auto found = root.find("images");
  if (found == root.end()) return {};
  if (!found->is_array()) return fault("/images is not a list");
  for (std::size_t i = 0; i < found->size(); ++i) {
    const json& declared = (*found)[i];
    ImageSource image;
    if (declared.is_object()) {
      image.name = text_of(declared, "name");
      image.uri = text_of(declared, "uri");
      if (declared.contains("bufferView")) image.buffer_view = declared["bufferView"].get<int>();
      if (image.buffer_view >= 0 && !declared.contains("mimeType")) {
        doc.warnings.add(fmt::format("image {} has no mimeType", i));
      }
    }
    if (image.uri.empty() && image.buffer_view < 0) {
      doc.warnings.add(fmt::format("image {} has neither a uri nor a buffer view", i));
    }
    doc.images.push_back(std::move(image));
  }
  root.erase(found);
  return {};
}

/// Removes the strides of buffer views from the JSON.
void take_strides(json& root, Document& doc) {
  const auto found = root.find("bufferViews");
  if (found == root.end() || !found->is_array()) return;
  for (json& view : *found) {
    std::uint64_t& stride = doc.strides.emplace_back(0);
    const auto declared = view.find("byteStride");
    if (declared == view.end()) continue;
    stride = declared->get<std::uint64_t>();
    view.erase(declared);
    if (stride % 4 != 0 || stride < 4 || stride > 252)
      doc.warnings.add(fmt::format(
          "buffer view {} has a byteStride of {}, which glTF does not allow; it is read by it",
          doc.strides.size() - 1, stride));
  }
}

/// Adds tinygltf's warnings, one per line, without those about properties that glTF allows to omit.
void add_remarks(const std::string& text, Warnings& warnings) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool allowed = line.find("'inverseBindMatrices' property is missing") == 0 ||
                         line.find("'node' property is missing") == 0 ||
                         line.find("`node` field is missing") == 0;
    if (!line.empty() && !allowed) warnings.add(one_line(line));
  }
}

/// Reads the model and frees the JSON, since tinygltf makes a copy of the same size.
Checked<void> read_model(json root, Document& doc) {
  const std::string text = root.dump();
  root = nullptr;
  tinygltf::TinyGLTF reader;
  std::string error, warning;
  bool good = false;
  try {
    stop_point();
    good = reader.LoadASCIIFromString(&doc.model, &error, &warning, text.data(),
                                      static_cast<unsigned>(text.size()), "", tinygltf::NO_REQUIRE);
  } catch (const std::exception& e) {
    return fault(one_line(e.what()));
  }
  if (!good) return fault(one_line(error.empty() ? "the JSON is not valid glTF" : error));
  add_remarks(error + warning, doc.warnings);
  return {};
}

}  // namespace

Checked<Document> read_document(const std::filesystem::path& path,
                                const std::filesystem::path& asset_root) {
  Document doc;
  Checked<FileBytes> file = read_file(path, scene_file_rules());
  if (!file) return fault(file.error());
  doc.honest_bytes = file->size();
  Checked<AssetFolders> folders = asset_folders(path.parent_path(), asset_root);
  if (!folders) return fault(folders.error());
  doc.files = ModelFiles(std::move(*folders));
  const Checked<Container> container = open_container(*file, doc.warnings);
  if (!container) return fault(container.error());
  stop_point();
  Checked<json> root = parse(container->json, doc.warnings);
  if (!root) return fault(root.error());

  Checked<std::vector<std::string>> optional = check_header(*root, doc.warnings);
  if (!optional) return fault(optional.error());
  doc.unsupported_extensions = std::move(*optional);
  doc.variants = variants_of(*root);
  doc.broken_cameras = tidy_entries(*root, doc.warnings);
  if (auto done = tidy(*root, container->json.size(), doc.warnings); !done)
    return fault(done.error());
  if (moves_values(*root)) doc.movable = std::make_shared<const json>(movable_parts(*root));
  complete_planes(*root, doc.warnings);
  stop_point();
  take_strides(*root, doc);
  if (auto done = take_buffers(*root, *container, doc); !done) return fault(done.error());
  if (auto done = take_images(*root, doc); !done) return fault(done.error());
  if (auto done = read_model(std::move(*root), doc); !done) return fault(done.error());
  return doc;
}

int default_scene(Document& document) {
  const auto count = static_cast<int>(document.model.scenes.size());
  const int named = document.model.defaultScene;
  if (count == 0) {
    if (!document.model.nodes.empty())
      document.warnings.add("has no scene; all its nodes are shown");
    return -1;
  }
  if (named >= count)
    document.warnings.add(
        fmt::format("its default scene {} does not exist; scene 0 takes its place", named));
  return named >= 0 && named < count ? named : 0;
}

Checked<int> find_scene(const Document& document, const std::string& wanted) {
  const std::vector<tinygltf::Scene>& scenes = document.model.scenes;
  // Every scene can also be selected with its number, even if it has a name.
  if (const auto number = whole_number(wanted); number && *number < scenes.size())
    return static_cast<int>(*number);
  const auto found = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const tinygltf::Scene& s) { return s.name == wanted; });
  if (found != scenes.end() && !wanted.empty()) return static_cast<int>(found - scenes.begin());
  if (scenes.empty()) return fault("has no scenes to choose from");
  return fault(fmt::format("has no scene '{}'; there {} {}", wanted,
                           scenes.size() == 1 ? "is" : "are", scene_list(scenes)));
}

}  // namespace asos::gltf
