#include "renderer/film/image_io.h"
#include "renderer/film/picture_writer.h"
#include "renderer/film/png_rows.h"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace asos {
namespace {

class PngWriter : public PictureWriter {
 public:
  PngWriter(std::unique_ptr<PngRows> rows, const DisplayTransform& display)
      : rows_(std::move(rows)), display_(display) {}

  [[nodiscard]] Result<void> add_rows(std::span<const glm::vec3> radiance) override {
    rgb_.clear();
    for (const glm::vec3& r : radiance) {
      const glm::u8vec3 c = display_bytes(r, display_);
      rgb_.insert(rgb_.end(), {c.x, c.y, c.z});
    }
    return rows_->add_rows(rgb_);
  }
  [[nodiscard]] Result<void> finish() override { return rows_->finish(); }

 private:
  std::unique_ptr<PngRows> rows_;
  DisplayTransform display_;
  std::vector<std::uint8_t> rgb_;
};

}  // namespace

Result<std::unique_ptr<PictureWriter>> make_png_writer(const std::string& path, PictureSizePx size,
                                                       const DisplayTransform& display,
                                                       const ImageText& text) {
  return PngRows::create(path, size.width, size.height, text)
      .map([&](std::unique_ptr<PngRows> rows) -> std::unique_ptr<PictureWriter> {
        return std::make_unique<PngWriter>(std::move(rows), display);
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
  auto writer = make_png_writer(path, {film.width, film.height}, display, text);
  if (!writer) return unexpected(writer.error());
  return (*writer)->add_rows(film.radiance).and_then([&] { return (*writer)->finish(); });
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
