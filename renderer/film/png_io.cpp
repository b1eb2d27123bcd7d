#include "renderer/film/image_io.h"
#include "renderer/film/picture_writer.h"
#include "renderer/film/png_rows.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace asos {
namespace {

// NaN coverage, of a sample that was not finite, counts as not covered.
std::uint8_t alpha_byte(float covered) {
  if (!(covered > 0.0f)) return 0;
  return static_cast<std::uint8_t>(std::min(covered, 1.0f) * 255.0f + 0.5f);
}

class PngWriter : public PictureWriter {
 public:
  PngWriter(std::unique_ptr<PngRows> rows, const DisplayTransform& display, Alpha alpha)
      : rows_(std::move(rows)), display_(display), alpha_(alpha) {}

  [[nodiscard]] Result<void> add_rows(std::span<const glm::vec3> radiance,
                                      std::span<const float> coverage,
                                      std::span<const glm::vec4> unlit) override {
    bytes_.clear();
    for (std::size_t i = 0; i < radiance.size(); ++i) {
      const float covered = alpha_ == Alpha::none || coverage.empty() ? 1.0f : coverage[i];
      const float part = covered > 0.0f && covered < 1.0f ? covered : 1.0f;
      const glm::u8vec3 c =
          unlit.empty()
              ? display_bytes(radiance[i] / part, display_)
              : display_bytes(tone_mapped(radiance[i] / part, unlit[i] / part, display_), 0.0f);
      bytes_.insert(bytes_.end(), {c.x, c.y, c.z});
      if (alpha_ == Alpha::coverage) bytes_.push_back(alpha_byte(covered));
    }
    return rows_->add_rows(bytes_);
  }
  [[nodiscard]] Result<void> finish() override { return rows_->finish(); }

 private:
  std::unique_ptr<PngRows> rows_;
  DisplayTransform display_;
  Alpha alpha_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

Result<std::unique_ptr<PictureWriter>> make_png_writer(const std::string& path, PictureSizePx size,
                                                       const DisplayTransform& display,
                                                       const ImageText& text, Alpha alpha) {
  return PngRows::create(path, size.width, size.height, text, alpha == Alpha::coverage ? 4 : 3)
      .map([&](std::unique_ptr<PngRows> rows) -> std::unique_ptr<PictureWriter> {
        return std::make_unique<PngWriter>(std::move(rows), display, alpha);
      });
}

Result<void> write_png(const std::string& path, const RgbImage& image) {
  const bool fits = image.width >= 0 && image.height >= 0 &&
                    image.rgb.size() == 3 * static_cast<std::size_t>(image.width) *
                                            static_cast<std::size_t>(image.height);
  if (!fits) return unexpected(Error{path, "the picture's data do not fit its size"});
  auto rows = PngRows::create(path, image.width, image.height, image.text);
  if (!rows) return unexpected(rows.error());
  return (*rows)->add_rows(image.rgb).and_then([&] { return (*rows)->finish(); });
}

Result<void> write_png(const std::string& path, const Film& film, const DisplayTransform& display,
                       const ImageText& text) {
  auto writer = make_png_writer(path, {film.width, film.height}, display, text, alpha_of(film));
  if (!writer) return unexpected(writer.error());
  return (*writer)->add_rows(film.radiance, film.coverage, film.unlit).and_then([&] {
    return (*writer)->finish();
  });
}

Result<void> write_split_map_png(const std::string& path, const Film& film, SplitMapKey key,
                                 const ImageText& text) {
  RgbImage image{film.width, film.height, {}, text};
  const std::size_t pixels = film.split_level.size();
  image.rgb.reserve(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const glm::u8vec3 c = key.colour(key.value(film, i));
    image.rgb.insert(image.rgb.end(), {c.x, c.y, c.z});
  }
  return write_png(path, image);
}

}  // namespace asos
