#include "asos/picture.h"

#include "renderer/api/convert.h"
#include "renderer/api/picture_impl.h"
#include "renderer/film/image_io.h"
#include "renderer/picture/picture_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

namespace asos::api {
namespace {

/// A layer of a film: how many values a pixel has, and where they are.
struct FilmLayer {
  LayerInfo info;
  bool (*present)(const Film& film);
  float (*value)(const Film& film, std::size_t pixel, int channel);
};

bool always(const Film& /*film*/) {
  return true;
}

const std::vector<FilmLayer>& film_layers() {
  static const std::vector<FilmLayer> layers{
      {{"beauty", 3, "radiance"},
       always,
       [](const Film& f, std::size_t i, int c) { return f.radiance[i][c]; }},
      {{"alpha", 1, "share of the pixel"},
       [](const Film& f) { return !f.coverage.empty(); },
       [](const Film& f, std::size_t i, int) { return f.coverage[i]; }},
      {{"level", 1, "level"},
       always,
       [](const Film& f, std::size_t i, int) { return static_cast<float>(f.split_level[i]); }},
      {{"cause", 1, "number"},
       always,
       [](const Film& f, std::size_t i, int) { return static_cast<float>(f.cause[i]); }},
      {{"rays", 1, "rays"}, always, [](const Film& f, std::size_t i, int) { return f.rays[i]; }},
      {{"time", 1, "s"}, always, [](const Film& f, std::size_t i, int) { return f.seconds[i]; }},
  };
  return layers;
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

std::vector<LayerInfo> Picture::layers() const {
  std::vector<LayerInfo> infos;
  for (const FilmLayer& layer : film_layers())
    if (layer.present(impl_->result.film)) infos.push_back(layer.info);
  return infos;
}

Result<Layer> Picture::layer(const std::string& name) const {
  return guarded("layer", [&]() -> Result<Layer> {
    const Film& film = impl_->result.film;
    const auto& all = film_layers();
    const auto found = std::find_if(all.begin(), all.end(), [&](const FilmLayer& layer) {
      return layer.info.name == name && layer.present(film);
    });
    if (found == all.end())
      return failure(ErrorCode::invalid_argument, "layer '" + name + "'",
                     "the picture has no layer of this name");
    Layer layer{found->info, film.width, film.height, {}};
    layer.values.reserve(film.radiance.size() * static_cast<std::size_t>(layer.info.channels));
    for (std::size_t i = 0; i < film.radiance.size(); ++i)
      for (int c = 0; c < layer.info.channels; ++c)
        layer.values.push_back(found->value(film, i, c));
    return layer;
  });
}

Result<void> Picture::save(const std::string& path, const SaveOptions& options) const {
  return guarded("picture", [&]() -> Result<void> {
    const std::string extension = lower_extension(path);
    if (extension != ".png" && extension != ".exr")
      return failure(ErrorCode::invalid_argument, path, "does not end in .png or .exr");
    if (!std::isfinite(options.exposure_ev))
      return failure(ErrorCode::invalid_argument, "exposure_ev", "is not finite");
    const Snapshot& of = impl_->snapshot;
    const ToneCurve tone = impl_->tone;
    ImageText text;
    if (impl_->from_file)
      text = picture_text(describe(*of.scene, of.camera, of.settings,
                                   {options.exposure_ev, false, {}, 0.0f, tone}));
    const Film& film = impl_->result.film;
    const PixelRect part = of.settings.visible();
    ExrOptions exr;
    exr.window = {of.settings.width, of.settings.height, part.x, part.y};
    const asos::Result<void> written =
        extension == ".exr" ? write_exr(path, film, text, exr)
                            : write_png(path, film, {options.exposure_ev, tone}, text);
    if (!written) return failure(ErrorCode::cannot_write, written.error());
    return {};
  });
}

std::string cause_name(int cause) {
  return cause >= 0 && static_cast<std::size_t>(cause) < split_cause_count
             ? split_cause_names[static_cast<std::size_t>(cause)]
             : "";
}

}  // namespace asos::api
