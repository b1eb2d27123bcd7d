#include "renderer/film/image_io.h"
#include "renderer/shading/sky.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <stb_image.h>
#include <utility>

namespace asos {
namespace {

constexpr std::int64_t most_texels = std::int64_t{1} << 26;

struct SkyPicture {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> texels;
};

struct FreePixels {
  void operator()(float* p) const { stbi_image_free(p); }
};

Result<void> check_size(const std::string& path, int width, int height) {
  if (width != 2 * std::int64_t{height}) {
    return unexpected(Error{path, fmt::format("has {} x {} pixels; a sky is twice as wide as it is "
                                              "high (equirectangular)",
                                              width, height)});
  }
  if (std::int64_t{width} * height > most_texels)
    return unexpected(Error{
        path, fmt::format("has {} x {} pixels; a sky has at most {}", width, height, most_texels)});
  return {};
}

Result<SkyPicture> read_hdr(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return unexpected(Error{path, "cannot be opened"});
  const std::vector<unsigned char> file((std::istreambuf_iterator<char>(stream)),
                                        std::istreambuf_iterator<char>());
  const int size = static_cast<int>(file.size());
  if (file.size() > std::size_t{std::numeric_limits<int>::max()})
    return unexpected(Error{path, "is too big"});
  if (file.empty() || !stbi_is_hdr_from_memory(file.data(), size))
    return unexpected(Error{path, "is not a Radiance picture"});
  SkyPicture picture;
  int channels = 0;
  if (!stbi_info_from_memory(file.data(), size, &picture.width, &picture.height, &channels))
    return unexpected(Error{path, "its header cannot be read"});
  if (const auto fits = check_size(path, picture.width, picture.height); !fits)
    return unexpected(fits.error());
  const std::unique_ptr<float, FreePixels> pixels(
      stbi_loadf_from_memory(file.data(), size, &picture.width, &picture.height, &channels, 3));
  if (!pixels) return unexpected(Error{path, "its picture cannot be read"});
  const auto count =
      static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  picture.texels.reserve(count);
  for (const float* p = pixels.get(); p != pixels.get() + 3 * count; p += 3)
    picture.texels.emplace_back(p[0], p[1], p[2]);
  return picture;
}

Result<SkyPicture> read_exr_sky(const std::string& path) {
  Result<ExrImage> image = read_exr(path);
  if (!image) return unexpected(image.error());
  if (const auto fits = check_size(path, image->film.width, image->film.height); !fits)
    return unexpected(fits.error());
  return SkyPicture{image->film.width, image->film.height, std::move(image->film.radiance)};
}

Result<void> check_texels(const std::string& path, const SkyPicture& picture) {
  std::size_t infinite = 0, negative = 0;
  for (const glm::vec3& c : picture.texels) {
    if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) {
      ++infinite;
    } else if (c.x < 0.0f || c.y < 0.0f || c.z < 0.0f) {
      ++negative;
    }
  }
  if (infinite + negative == 0) return {};
  return unexpected(
      Error{path, fmt::format("{} of its {} pixels are not finite and {} are negative: no sky is",
                              infinite, picture.texels.size(), negative)});
}

}  // namespace

Result<std::shared_ptr<const Sky>> read_sky(const std::string& path, double turn_deg) {
  const bool exr = path.ends_with(".exr");
  if (!exr && !path.ends_with(".hdr")) return unexpected(Error{path, "has to end in .hdr or .exr"});
  Result<SkyPicture> picture = exr ? read_exr_sky(path) : read_hdr(path);
  if (!picture) return unexpected(picture.error());
  if (const auto sound = check_texels(path, *picture); !sound) return unexpected(sound.error());
  return std::make_shared<const Sky>(
      SkyMap(picture->width, picture->height, std::move(picture->texels)), turn_deg, path);
}

}  // namespace asos
