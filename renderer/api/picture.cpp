#include "asos/picture.h"

#include "renderer/api/convert.h"
#include "renderer/api/picture_impl.h"
#include "renderer/api/ready_picture.h"
#include "renderer/film/image_io.h"
#include "renderer/picture/exr_picture.h"
#include "renderer/picture/picture_text.h"
#include "renderer/study/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

namespace asos::api {
namespace {

/// The text that renders the picture again; empty: the scene is in no file.
ImageText text_of(const Picture::Impl& picture, const PictureDisplay& display) {
  if (!picture.from_file) return {};
  const Snapshot& of = picture.snapshot;
  return picture_text(describe(*of.scene, of.camera, of.settings, display));
}

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return extension;
}

}  // namespace

Picture::Picture(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
Picture::Picture(const Picture&) = default;
Picture::Picture(Picture&&) noexcept = default;
Picture& Picture::operator=(const Picture&) = default;
Picture& Picture::operator=(Picture&&) noexcept = default;
Picture::~Picture() = default;

int Picture::width() const {
  return impl_->result.film.width;
}
int Picture::height() const {
  return impl_->result.film.height;
}
bool Picture::finished() const {
  return impl_->finished;
}
double Picture::seconds() const {
  return impl_->result.seconds;
}
std::uint64_t Picture::rays() const {
  return impl_->result.statistics.rays();
}

Result<void> Picture::save(const std::string& path, const SaveOptions& options) const {
  return guarded("picture", [&]() -> Result<void> {
    const std::string extension = lower_extension(path);
    if (extension != ".png" && extension != ".exr")
      return failure(ErrorCode::invalid_argument, path, "does not end in .png or .exr");
    if (!std::isfinite(options.exposure_ev))
      return failure(ErrorCode::invalid_argument, "exposure_ev", "is not finite");
    const Result<ToneCurve> tone = options.tone ? curve_of(*options.tone) : impl_->tone;
    if (!tone) return tone.error();
    const PictureDisplay display{options.exposure_ev, false, {}, 0.0f, *tone};
    const ImageText text = text_of(*impl_, display);
    const Snapshot& of = impl_->snapshot;
    const Film& film = impl_->result.film;
    const asos::Result<void> written =
        extension == ".exr"
            ? write_exr(path, film, text, exr_options(*of.scene, of.camera, of.settings))
            : write_png(path, film, display.transform(), text);
    if (!written) return failure(ErrorCode::cannot_write, written.error());
    return {};
  });
}

Result<void> Picture::save_split_map(const std::string& path, SplitMapKind kind) const {
  return guarded("split map", [&]() -> Result<void> {
    if (lower_extension(path) != ".png")
      return failure(ErrorCode::invalid_argument, path, "does not end in .png");
    if (kind < SplitMapKind::level || kind > SplitMapKind::time)
      return failure(ErrorCode::invalid_argument, "kind", "there is no such map");
    constexpr std::array kinds{SplitMapColours::level, SplitMapColours::cause,
                               SplitMapColours::rays, SplitMapColours::time};
    const SplitMapColours colours = kinds[static_cast<std::size_t>(kind)];
    const PictureDisplay display{0.0f, true, colours, 1.0f, impl_->tone};
    const asos::Result<void> written =
        write_split_map_png(path, impl_->result.film, {colours}, text_of(*impl_, display));
    if (!written) return failure(ErrorCode::cannot_write, written.error());
    return {};
  });
}

Result<Difference> compare(const Picture& picture, const Picture& reference) {
  return guarded("pictures", [&]() -> Result<Difference> {
    const Film& film = picture.impl().result.film;
    const Film& truth = reference.impl().result.film;
    if (film.width != truth.width || film.height != truth.height)
      return failure(ErrorCode::invalid_argument, "pictures",
                     fmt::format("have other sizes: {}x{} and {}x{}", film.width, film.height,
                                 truth.width, truth.height));
    const Measures of = measure(film, truth);
    return Difference{
        of.rmse,      -20.0 * std::log10(of.rmse), of.mae, of.p99, of.max, of.rmse_display,
        of.perceptual};
  });
}

std::string cause_name(int cause) {
  return cause >= 0 && static_cast<std::size_t>(cause) < split_cause_count
             ? split_cause_names[static_cast<std::size_t>(cause)]
             : "";
}

}  // namespace asos::api
