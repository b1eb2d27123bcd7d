#include "renderer/scene/gltf/images.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#include <climits>
#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <stb_image.h>

namespace asos::gltf {

namespace {

constexpr int unknown = -2;
constexpr int none = -1;
constexpr int largest_side = 16384;
// Deflate expands at most 1032 times, and a byte may be a whole pixel of a palette.
constexpr std::uint64_t most_pixels_per_byte = 1100;
constexpr std::uint64_t free_pixels = 1 << 20;

Wrap wrap_of(int value, bool& known) {
  if (value == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp_to_edge;
  if (value == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirrored_repeat;
  if (value != TINYGLTF_TEXTURE_WRAP_REPEAT) known = false;
  return Wrap::repeat;
}

/// Names a picture by its first bytes, to say what is not supported.
const char* format_of(Bytes bytes) {
  const auto begins = [&](std::size_t at, const char* magic) {
    const std::size_t n = std::strlen(magic);
    return bytes.size() >= at + n && std::memcmp(bytes.data() + at, magic, n) == 0;
  };
  if (begins(0, "RIFF") && begins(8, "WEBP")) return "WebP";
  if (begins(0, "\xabKTX")) return "KTX";
  if (begins(0, "GIF8")) return "GIF";
  if (begins(0, "BM")) return "BMP";
  if (begins(0, "DDS ")) return "DDS";
  if (begins(4, "ftypavif")) return "AVIF";
  return nullptr;
}

}  // namespace

Checked<Image> decode_image(Bytes bytes) {
  if (bytes.empty()) return fault("it is empty");
  if (bytes.size() > INT_MAX) return fault("it is larger than 2 GiB");
  const auto size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(bytes.data(), size, &width, &height, &channels)) {
    const char* format = format_of(bytes);
    if (format) return fault(fmt::format("{} pictures are not supported", format));
    return fault(fmt::format("it is no usable PNG or JPEG ({})", stbi_failure_reason()));
  }
  if (width < 1 || height < 1 || width > largest_side || height > largest_side) {
    return fault(
        fmt::format("it is {} x {} pixels; the limit is {} a side", width, height, largest_side));
  }
  const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  if (pixels > bytes.size() * most_pixels_per_byte + free_pixels) {
    return fault(fmt::format("{} bytes cannot hold {} x {} pixels", size, width, height));
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
      stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
  if (!decoded) return fault(fmt::format("it cannot be decoded ({})", stbi_failure_reason()));
  Image image;
  image.width = width;
  image.height = height;
  image.rgba.own().assign(decoded.get(), decoded.get() + pixels * 4);
  return image;
}

Textures::Textures(Document& document, Accessors& accessors, Scene& scene)
    : doc_(document),
      accessors_(accessors),
      scene_(scene),
      texture_of_(document.model.textures.size(), unknown),
      image_of_(document.images.size(), unknown) {}

int Textures::use(int texture) {
  if (texture < 0) return none;
  if (static_cast<std::size_t>(texture) >= texture_of_.size()) {
    doc_.warnings.add(fmt::format("texture {} does not exist; left out", texture));
    return none;
  }
  int& known = texture_of_[static_cast<std::size_t>(texture)];
  if (known == unknown) known = load(texture);
  return known;
}

int Textures::load(int index) {
  const tinygltf::Texture& source = doc_.model.textures[static_cast<std::size_t>(index)];
  if (source.source < 0) {
    doc_.warnings.add(fmt::format("texture {} has no PNG or JPEG image; left out", index));
    return none;
  }
  Texture texture;
  texture.name = source.name;
  texture.image = use_image(source.source);
  if (texture.image < 0) return none;
  if (source.sampler >= 0 &&
      static_cast<std::size_t>(source.sampler) >= doc_.model.samplers.size()) {
    doc_.warnings.add(
        fmt::format("texture {} has sampler {}, which does not exist", index, source.sampler));
  } else if (source.sampler >= 0) {
    const auto& sampler = doc_.model.samplers[static_cast<std::size_t>(source.sampler)];
    bool known = true;
    texture.wrap_u = wrap_of(sampler.wrapS, known);
    texture.wrap_v = wrap_of(sampler.wrapT, known);
    if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) texture.filter = Filter::nearest;
    if (!known) doc_.warnings.add(fmt::format("sampler {} wraps unknown", source.sampler));
  }
  scene_.textures.push_back(std::move(texture));
  return static_cast<int>(scene_.textures.size()) - 1;
}

int Textures::use_image(int index) {
  if (static_cast<std::size_t>(index) >= image_of_.size()) {
    doc_.warnings.add(fmt::format("image {} does not exist; its textures are left out", index));
    return none;
  }
  int& known = image_of_[static_cast<std::size_t>(index)];
  if (known != unknown) return known;
  known = none;
  Checked<Image> image = load_image(index);
  const ImageSource& source = doc_.images[static_cast<std::size_t>(index)];
  if (!image) {
    const std::string name = source.name.empty() ? shown_uri(source.uri) : source.name;
    doc_.warnings.add(
        fmt::format("image {} '{}': {}; its textures are left out", index, name, image.error()));
    return none;
  }
  image->name = source.name;
  known = static_cast<int>(scene_.images.size());
  scene_.images.push_back(std::move(*image));
  return known;
}

Checked<Image> Textures::load_image(int index) {
  const ImageSource& source = doc_.images[static_cast<std::size_t>(index)];
  if (source.buffer_view >= 0) {
    const Checked<Bytes> bytes = accessors_.view(source.buffer_view);
    if (!bytes) return fault(bytes.error());
    return decode_image(*bytes);
  }
  const Checked<FileBytes> bytes = read_uri(doc_.folder, source.uri);
  if (!bytes) return fault(bytes.error());
  return decode_image(*bytes);
}

}  // namespace asos::gltf
