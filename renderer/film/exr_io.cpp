#include "renderer/film/image_io.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <string_view>
#include <tinyexr.h>

namespace asos {
namespace {

constexpr std::size_t max_pixels = std::size_t{1} << 29;

/// tinyexr's error message, freed.
std::string take_message(const char* message, const char* fallback) {
  const std::string text = message ? message : fallback;
  if (message) FreeEXRErrorMessage(message);
  return text;
}

/// The attributes in tinyexr's form. Values stay the caller's strings: tinyexr only reads them.
Result<std::vector<EXRAttribute>> to_attributes(const std::string& path, const ImageText& text) {
  if (text.size() > TINYEXR_MAX_CUSTOM_ATTRIBUTES) {
    return unexpected(Error{path, "too many attributes for an EXR"});
  }
  std::vector<EXRAttribute> attributes;
  for (const auto& [key, value] : text) {
    EXRAttribute attribute{};
    const bool long_value = value.size() > std::size_t{std::numeric_limits<int>::max()};
    if (key.empty() || key.size() >= sizeof attribute.name || key.find('\0') != std::string::npos ||
        long_value) {
      return unexpected(Error{path, "attribute \"" + key + "\" is not valid"});
    }
    std::memcpy(attribute.name, key.data(), key.size());
    std::memcpy(attribute.type, "string", 6);
    attribute.value = reinterpret_cast<unsigned char*>(const_cast<char*>(value.data()));
    attribute.size = static_cast<int>(value.size());
    attributes.push_back(attribute);
  }
  return attributes;
}

struct FreeBytes {
  void operator()(unsigned char* p) const { std::free(p); }
};

/// Owns what tinyexr parsed.
struct Parsed {
  EXRHeader header;
  EXRImage image;

  Parsed() {
    InitEXRHeader(&header);
    InitEXRImage(&image);
  }
  Parsed(const Parsed&) = delete;
  Parsed& operator=(const Parsed&) = delete;
  ~Parsed() {
    FreeEXRImage(&image);
    FreeEXRHeader(&header);
  }

  /// The plane of a channel, or null.
  [[nodiscard]] const float* channel(std::string_view name) const {
    for (int i = 0; i < header.num_channels; ++i) {
      if (header.channels[i].name == name) {
        return reinterpret_cast<const float*>(image.images[i]);
      }
    }
    return nullptr;
  }
};

}  // namespace

Result<void> write_exr(const std::string& path, const Film& film, const ImageText& text) {
  const std::size_t pixels = film.radiance.size();
  if (pixels == 0) return unexpected(Error{path, "the picture is empty"});
  if (pixels > max_pixels) return unexpected(Error{path, "the picture is too big"});
  auto attributes = to_attributes(path, text);
  if (!attributes) return unexpected(attributes.error());

  // Channels lie in planes, in the order of their names.
  std::array<std::vector<float>, 3> planes;  // B, G, R
  std::array<unsigned char*, 3> plane_starts{};
  std::array<EXRChannelInfo, 3> channels{};
  std::array<int, 3> types{TINYEXR_PIXELTYPE_FLOAT, TINYEXR_PIXELTYPE_FLOAT,
                           TINYEXR_PIXELTYPE_FLOAT};
  for (std::size_t c = 0; c < 3; ++c) {
    planes[c].reserve(pixels);
    for (const glm::vec3& radiance : film.radiance) {
      planes[c].push_back(radiance[2 - static_cast<int>(c)]);
    }
    plane_starts[c] = reinterpret_cast<unsigned char*>(planes[c].data());
    channels[c].name[0] = "BGR"[c];
  }
  EXRImage image;
  InitEXRImage(&image);
  image.num_channels = 3;
  image.images = plane_starts.data();
  image.width = film.width;
  image.height = film.height;
  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = 3;
  header.channels = channels.data();
  header.pixel_types = types.data();
  header.requested_pixel_types = types.data();
  header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  header.num_custom_attributes = static_cast<int>(attributes->size());
  header.custom_attributes = attributes->data();

  unsigned char* memory = nullptr;
  const char* message = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&image, &header, &memory, &message);
  const std::unique_ptr<unsigned char, FreeBytes> owner(memory);
  if (size == 0 || !memory) {
    return unexpected(Error{path, take_message(message, "the picture could not be encoded")});
  }
  return write_file_atomically(path, {memory, memory + size});
}

Result<ExrImage> read_exr(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return unexpected(Error{path, "cannot be opened"});
  const std::vector<std::uint8_t> file((std::istreambuf_iterator<char>(stream)),
                                       std::istreambuf_iterator<char>());
  EXRVersion version;
  if (ParseEXRVersionFromMemory(&version, file.data(), file.size()) != TINYEXR_SUCCESS ||
      version.multipart || version.non_image || version.tiled) {
    return unexpected(Error{path, "is not a plain EXR"});
  }
  Parsed parsed;
  const char* message = nullptr;
  if (ParseEXRHeaderFromMemory(&parsed.header, &version, file.data(), file.size(), &message) !=
      TINYEXR_SUCCESS) {
    return unexpected(Error{path, take_message(message, "its header cannot be read")});
  }
  for (int i = 0; i < parsed.header.num_channels; ++i) {
    parsed.header.requested_pixel_types[i] = TINYEXR_PIXELTYPE_FLOAT;
  }
  if (LoadEXRImageFromMemory(&parsed.image, &parsed.header, file.data(), file.size(), &message) !=
      TINYEXR_SUCCESS) {
    return unexpected(Error{path, take_message(message, "its picture cannot be read")});
  }

  const float* r = parsed.channel("R");
  const float* g = parsed.channel("G");
  const float* b = parsed.channel("B");
  if (!r || !g || !b) return unexpected(Error{path, "has no R, G and B channels"});
  ExrImage read;
  read.film = Film(parsed.image.width, parsed.image.height);
  for (std::size_t i = 0; i < read.film.radiance.size(); ++i) {
    read.film.radiance[i] = {r[i], g[i], b[i]};
  }
  for (int i = 0; i < parsed.header.num_custom_attributes; ++i) {
    const EXRAttribute& a = parsed.header.custom_attributes[i];
    if (std::string_view(a.type) != "string") continue;
    read.attributes.emplace_back(a.name, std::string(reinterpret_cast<const char*>(a.value),
                                                     static_cast<std::size_t>(a.size)));
  }
  return read;
}

}  // namespace asos
