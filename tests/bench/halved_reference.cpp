#include "tests/bench/halved_reference.h"

#include "renderer/film/image_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace asos::bench {

namespace {

constexpr std::array<std::uint32_t, 2> seeds{12345, 54321};

std::string half_path(const std::string& path, std::size_t half) {
  return fmt::format("{}-{}.exr", path, half + 1);
}

}  // namespace

HalvedReference HalvedReference::rendered(Snapshot snapshot, int samples) {
  snapshot.settings.method = Method::sobol;
  snapshot.settings.sampling.spp = samples / 2;
  // With point lookups, only the pixel's samples filter the texture.
  snapshot.settings.texture.filter = TextureFilter::point;
  HalvedReference reference;
  for (std::size_t half = 0; half < reference.halves_.size(); ++half) {
    snapshot.settings.seed = seeds[half];
    reference.halves_[half] = render_to_end(snapshot).film;
  }
  return reference;
}

Result<HalvedReference> HalvedReference::kept(const std::string& path, const Snapshot& snapshot,
                                              int samples) {
  if (std::filesystem::exists(half_path(path, 0)))
    return read(path, {snapshot.settings.width, snapshot.settings.height});
  HalvedReference reference = rendered(snapshot, samples);
  if (const auto written = reference.write(path); !written) return unexpected(written.error());
  return reference;
}

Result<HalvedReference> HalvedReference::read(const std::string& path, PictureSize size) {
  HalvedReference reference;
  for (std::size_t half = 0; half < reference.halves_.size(); ++half) {
    const std::string name = half_path(path, half);
    auto image = read_exr(name);
    if (!image) return unexpected(image.error());
    if (image->film.width != size.width || image->film.height != size.height)
      return unexpected(Error{name, "is not of the size that its name says"});
    reference.halves_[half] = std::move(image->film);
  }
  return reference;
}

Result<void> HalvedReference::write(const std::string& path) const {
  for (std::size_t half = 0; half < halves_.size(); ++half)
    if (const auto written = write_exr(half_path(path, half), halves_[half], {}); !written)
      return written;
  return {};
}

std::vector<double> HalvedReference::squared_errors(const Film& film) const {
  std::vector<double> squares(film.radiance.size());
  for (std::size_t pixel = 0; pixel < squares.size(); ++pixel) {
    const glm::dvec3 first = clipped_difference(film.radiance[pixel], halves_[0].radiance[pixel]);
    const glm::dvec3 second = clipped_difference(film.radiance[pixel], halves_[1].radiance[pixel]);
    squares[pixel] = glm::dot(first, second) / 3.0;
  }
  return squares;
}

KnownError HalvedReference::error_of(const Film& film) const {
  double sum = 0.0;
  double variance = 0.0;
  for (std::size_t pixel = 0; pixel < film.radiance.size(); ++pixel) {
    const std::array halves{halves_[0].radiance[pixel], halves_[1].radiance[pixel]};
    const glm::dvec3 first = clipped_difference(film.radiance[pixel], halves[0]);
    const glm::dvec3 second = clipped_difference(film.radiance[pixel], halves[1]);
    const double square = glm::dot(first, second) / 3.0;
    const double noise = squared_error(halves[0], halves[1], true) / 2.0;  // the variance of a half
    sum += square;
    variance += noise * (2.0 * std::abs(square) + noise);
  }
  const auto pixels = static_cast<double>(film.radiance.size());
  const double least = 2.0 * std::sqrt(variance) / pixels;
  return {std::sqrt(std::max(sum / pixels, least)), sum / pixels > least};
}

double HalvedReference::display_p99(const Film& film) const {
  std::vector<double> errors;
  errors.reserve(film.radiance.size());
  for (std::size_t pixel = 0; pixel < film.radiance.size(); ++pixel) {
    const glm::vec3 mean = 0.5f * (halves_[0].radiance[pixel] + halves_[1].radiance[pixel]);
    const glm::vec3 off = display_rgb(film.radiance[pixel], 0.0f) - display_rgb(mean, 0.0f);
    errors.push_back(std::sqrt(static_cast<double>(glm::dot(off, off)) / 3.0));
  }
  if (errors.empty()) return 0.0;
  const std::size_t rank = (99 * errors.size() + 99) / 100;
  const auto at = errors.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(errors.begin(), at, errors.end());
  return *at;
}

Bias HalvedReference::bias_of(const Film& film) const {
  const auto mean_of = [](glm::dvec3 v) { return (v.x + v.y + v.z) / 3.0; };
  Bias bias;
  for (std::size_t pixel = 0; pixel < film.radiance.size(); ++pixel) {
    const double first =
        mean_of(clipped_difference(film.radiance[pixel], halves_[0].radiance[pixel]));
    const double second =
        mean_of(clipped_difference(film.radiance[pixel], halves_[1].radiance[pixel]));
    const double off = 0.5 * (first + second);
    bias.off += off;
    bias.stray += 0.25 * (first - second) * (first - second);
    if (std::abs(off) > std::abs(bias.worst)) {
      bias.worst = off;
      bias.worst_pixel = pixel;
    }
  }
  const auto pixels = static_cast<double>(film.radiance.size());
  bias.off /= pixels;
  bias.stray = std::sqrt(bias.stray) / pixels;
  return bias;
}

}  // namespace asos::bench
