#include "renderer/scene/gltf/images.h"

#include "renderer/scene/gltf/image_limits.h"
#include "renderer/scene/gltf/values.h"
#include "renderer/scene/gltf/webp.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#include <climits>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <stb_image.h>

namespace asos::gltf {

namespace {

constexpr int unknown = -2;
constexpr int none = -1;
constexpr const char* basisu_advice =
    ". KHR_texture_basisu's KTX2 textures are not supported: convert them to PNG or WebP";
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
  if (begins(0, "\xabKTX")) return "KTX";
  if (begins(0, "GIF8")) return "GIF";
  if (begins(0, "BM")) return "BMP";
  if (begins(0, "DDS ")) return "DDS";
  if (begins(4, "ftypavif")) return "AVIF";
  return nullptr;
}

}  // namespace

Checked<Image> decode_image(Bytes bytes, std::uint64_t most_pixels) {
  if (bytes.empty()) return fault("it is empty");
  if (bytes.size() > INT_MAX) return fault("it is larger than 2 GiB");
  if (is_webp(bytes)) return decode_webp(bytes, most_pixels);
  const auto size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(bytes.data(), size, &width, &height, &channels)) {
    const char* format = format_of(bytes);
    if (format) return fault(fmt::format("{} pictures are not supported", format));
    return fault(fmt::format("it is no usable PNG, JPEG or WebP ({})", stbi_failure_reason()));
  }
  if (auto sound = check_size(width, height, bytes.size(), most_pixels); !sound)
    return fault(sound.error());
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
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
  Texture texture;
  texture.name = source.name;
  texture.image = image_of(source, index);
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

int Textures::image_of(const tinygltf::Texture& source, int index) {
  // EXT_texture_webp's image comes first; `source` is for programs that do not know it.
  if (const auto* e = extension(source.extensions, "EXT_texture_webp")) {
    if (const auto webp = whole(*e, "source"); webp && *webp >= 0) {
      const int image = use_image(*webp);
      if (image >= 0 || source.source < 0) return image;
      doc_.warnings.add(fmt::format("texture {} falls back to its PNG or JPEG image", index));
    }
  }
  if (source.source >= 0) return use_image(source.source);
  const bool basisu =
      std::find(doc_.unsupported_extensions.begin(), doc_.unsupported_extensions.end(),
                "KHR_texture_basisu") != doc_.unsupported_extensions.end();
  doc_.warnings.add(fmt::format("texture {} has no PNG, JPEG or WebP image; left out{}", index,
                                basisu ? basisu_advice : ""));
  return none;
}

int Textures::use_image(int index) {
  if (static_cast<std::size_t>(index) >= image_of_.size()) {
    doc_.warnings.add(fmt::format("image {} does not exist; its textures are left out", index));
    return none;
  }
  int& known = image_of_[static_cast<std::size_t>(index)];
  if (known != unknown) return known;
  known = none;
  const Checked<int> image = add_image(index);
  if (image) return known = *image;
  const ImageSource& source = doc_.images[static_cast<std::size_t>(index)];
  const std::string name = source.name.empty() ? shown_uri(source.uri) : source.name;
  doc_.warnings.add(
      fmt::format("image {} '{}': {}; its textures are left out", index, name, image.error()));
  return none;
}

std::uint64_t Textures::pixels_left() const {
  // Two gigabytes, and what pictures that are packed well take.
  constexpr std::uint64_t free_pixels = std::uint64_t{1} << 29, pixels_per_byte = 64;
  const std::uint64_t most = free_pixels + pixels_per_byte * (doc_.honest_bytes + outside_bytes_);
  return most - std::min(most, pixels_);
}

/// Empty where the bytes are nobody else's.
Textures::ImagePlace Textures::place_of(const ImageSource& source) {
  if (source.buffer_view >= 0) {
    const Checked<Bytes> bytes = accessors_.view(source.buffer_view);
    return bytes ? ImagePlace{bytes->data(), bytes->size(), {}} : ImagePlace{};
  }
  const auto file = file_of_uri(doc_.folder, source.uri);
  return file ? ImagePlace{nullptr, 0, file->string()} : ImagePlace{};
}

Checked<int> Textures::add_image(int index) {
  const ImageSource& source = doc_.images[static_cast<std::size_t>(index)];
  ImagePlace place = place_of(source);
  const bool shareable = place != ImagePlace{};
  if (const auto known = image_at_.find(place); shareable && known != image_at_.end())
    return known->second;
  Checked<Image> image = with_image_bytes(doc_, accessors_, index, [&](Bytes bytes) {
    if (source.buffer_view < 0) outside_bytes_ += bytes.size();
    return decode_image(bytes, pixels_left());
  });
  if (!image) return fault(image.error());
  pixels_ += image->rgba.size() / 4;
  image->name = source.name;
  const auto made = static_cast<int>(scene_.images.size());
  scene_.images.push_back(std::move(*image));
  if (shareable) image_at_.emplace(std::move(place), made);
  return made;
}

int Textures::roughness_of(int texture, float factor) {
  constexpr std::size_t most_factors = 4;
  Texture rough = scene_.textures[static_cast<std::size_t>(texture)];
  auto& made = roughness_of_[rough.image];
  auto found = std::find_if(made.begin(), made.end(),
                            [factor](const auto& known) { return known.first == factor; });
  if (found == made.end()) {
    if (made.size() == most_factors) {
      doc_.warnings.add(
          fmt::format("texture '{}' is used with more than {} factors of glossiness; the rest go "
                      "by the factor alone",
                      rough.name, most_factors));
      return none;
    }
    if (scene_.images[static_cast<std::size_t>(rough.image)].rgba.size() / 4 > pixels_left()) {
      doc_.warnings.add(fmt::format(
          "the roughness of texture '{}' would be more than a file of this size has use "
          "for; its factor alone is used",
          rough.name));
      return none;
    }
    Image image = scene_.images[static_cast<std::size_t>(rough.image)];
    pixels_ += image.rgba.size() / 4;
    SharedBytes::Bytes& rgba = image.rgba.own();
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
      const float glossiness = factor * static_cast<float>(rgba[i + 3]);
      rgba[i + 1] = static_cast<std::uint8_t>(std::lround(255.0f - glossiness));
      rgba[i] = rgba[i + 2] = rgba[i + 3] = 255;
    }
    found = made.insert(made.end(), {factor, static_cast<int>(scene_.images.size())});
    scene_.images.push_back(std::move(image));
  }
  rough.image = found->second;
  scene_.textures.push_back(std::move(rough));
  return static_cast<int>(scene_.textures.size()) - 1;
}

}  // namespace asos::gltf
