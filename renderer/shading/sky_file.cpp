#include "renderer/files/printable.h"
#include "renderer/film/hdr_io.h"
#include "renderer/film/reduced_exr.h"
#include "renderer/shading/sky.h"
#include "renderer/shading/sky_warning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace asos {
namespace {

constexpr std::int64_t most_texels = std::int64_t{1} << 26;
// Limits of an .exr, whose texels take 15 bytes. This number of texels is always allowed, and one
// more per 5 bytes of the file. Larger pictures are reduced.
constexpr std::int64_t free_exr_texels = std::int64_t{1} << 24;
constexpr std::int64_t most_exr_texels = std::int64_t{1} << 27;
// Limit of radiance; the sun has 2e9 nits. Squares of this value stay finite, even with the largest
// brightness.
constexpr float most_radiance = 1e15f;

struct SkyPicture {
  int width = 0;
  int height = 0;
  SkyTexels texels;
};

std::string size_fault(std::int64_t width, std::int64_t height, std::int64_t most) {
  if (width != 2 * height)
    return fmt::format("has {} x {} pixels; a sky is twice as wide as it is high (equirectangular)",
                       width, height);
  if (width > most / height)
    return fmt::format("has {} x {} pixels; a sky has at most {}", width, height, most);
  return "";
}

Result<SkyPicture> read_hdr_sky(const std::string& path) {
  const auto check = [](std::int64_t width, std::int64_t height) {
    return size_fault(width, height, most_texels);
  };
  return read_hdr(path, check).map([](HdrImage image) {
    return SkyPicture{image.width, image.height, SkyTexels(std::move(image.pixels), image.scale)};
  });
}

std::int64_t most_exr_texels_of(std::uint64_t file_bytes) {
  constexpr std::uint64_t bytes_a_texel = 5;
  return free_exr_texels + static_cast<std::int64_t>(file_bytes / bytes_a_texel);
}

Result<SkyPicture> read_exr_sky(const std::string& path) {
  const auto check = [](std::int64_t width, std::int64_t height) {
    return size_fault(width, height, most_exr_texels);
  };
  return read_reduced_exr(path, check, most_exr_texels_of).map([](ExrImage image) {
    return SkyPicture{image.film.width, image.film.height, std::move(image.film.radiance)};
  });
}

Result<void> check_texels(const std::string& path, const SkyPicture& picture) {
  std::size_t infinite = 0, negative = 0, blinding = 0;
  for (std::size_t i = 0; i < picture.texels.size(); ++i) {
    const glm::vec3 c = picture.texels[i];
    if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) {
      ++infinite;
    } else if (c.x < 0.0f || c.y < 0.0f || c.z < 0.0f) {
      ++negative;
    } else if (std::max({c.x, c.y, c.z}) > most_radiance) {
      ++blinding;
    }
  }
  if (blinding > 0)
    return unexpected(
        Error{path, fmt::format("{} of its {} pixels are brighter than {:g}: no sky is", blinding,
                                picture.texels.size(), most_radiance)});
  if (infinite + negative == 0) return {};
  return unexpected(
      Error{path, fmt::format("{} of its {} pixels are not finite and {} are negative: no sky is",
                              infinite, picture.texels.size(), negative)});
}

}  // namespace

Result<std::shared_ptr<const Sky>> read_sky(const std::string& path, double turn_deg) {
  const bool exr = path.ends_with(".exr");
  if (!exr && !path.ends_with(".hdr")) return unexpected(Error{path, "has to end in .hdr or .exr"});
  Result<SkyPicture> picture = exr ? read_exr_sky(path) : read_hdr_sky(path);
  if (!picture) return unexpected(picture.error());
  if (const auto sound = check_texels(path, *picture); !sound) return unexpected(sound.error());
  return std::make_shared<const Sky>(
      SkyMap(picture->width, picture->height, std::move(picture->texels)), turn_deg, path);
}

std::string sky_warning(const std::string& path) {
  if (!path.ends_with(".exr")) return "";
  const Result<ExrReduction> reduction = exr_reduction(path, most_exr_texels_of);
  if (!reduction || reduction->shrink == 1) return "";
  return fmt::format(
      "{}: its {} x {} pixels are more than a file of its size has use for; the sky is shown with "
      "{} x {}",
      printable(path), reduction->width, reduction->height, reduction->smaller(reduction->width),
      reduction->smaller(reduction->height));
}

}  // namespace asos
