#include "ui/picture_saver.h"

#include "renderer/comparison/method.h"
#include "renderer/picture/picture_text.h"
#include "ui/gl_display.h"
#include "ui/legend_strip.h"
#include "ui/movie.h"
#include "ui/previewer.h"
#include "ui/screenshot.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace asos::ui {

namespace {

constexpr double dialog_fades_seconds = 0.3;
constexpr const char* no_picture = "No picture to save yet";

// Returns the layers to save that the method renders.
LayerSet saved_layers(const SaveChoice& choice, Method method, std::optional<Layer> shown) {
  LayerSet saved;
  if (!choice.as_exr() || choice.layers == SaveChoice::Layers::none) return saved;
  for (const LayerRow& row : layer_table())
    if (renders_layer(method, row.value) &&
        (choice.layers == SaveChoice::Layers::all || shown == row.value))
      saved.insert(row.value);
  return saved;
}

}  // namespace

std::string PictureSaver::words(const Result<std::string>& saved,
                                const std::optional<UnsavedWork::Edits>& edits) {
  if (!saved) return "Not saved: " + saved.error().message();
  if (edits) saved_edits_ = edits;
  return "Saved " + *saved;
}

double clip_seconds(const Playback& playback) {
  if (playback.animations().empty()) return 0.0;
  return playback.time() ? playback.duration_seconds() : playback.animations().front().seconds;
}

void PictureSaver::begin_movie(const SaveChoice& choice, Snapshot snapshot,
                               const DisplayTransform& display) {
  const Playback& playback = previewer_.playback();
  MovieOrder order;
  order.snapshot = std::move(snapshot);
  order.display = display;
  order.stem = choice.stem;
  order.mp4 = choice.mp4;
  order.frames = choice.frames;
  order.fps = choice.fps;
  order.middle = previewer_.viewpoint().camera().pivot();
  if (choice.what == SaveChoice::What::clip && playback.available()) {
    order.animation = playback.time() ? playback.time()->animation : 0;
    order.frames = frames_of(clip_seconds(playback), choice.fps);
    order.lights = playback.edited_lights();
    order.dfrs = playback.edited_dfrs();
  }
  job_.start(choice.path(),
             [order = std::move(order)](const std::stop_token& stop, const auto& on_progress) {
               return write_movie(order, stop, on_progress);
             });
}

std::string PictureSaver::save_shown(const DisplaySettings& shown, double fraction) {
  const RenderScene* scene = previewer_.scene().get();
  if (!scene || display_.width() <= 0) return no_picture;
  RgbImage image{display_.width(), display_.height(), display_.seen_rgb(shown),
                 screenshot_text(previewer_, shown)};
  if (shown.show_split_map && shown.show_legend)
    add_legend(image, shown.split_colours, count_causes(previewer_.render().film()));
  const auto saved =
      save_screenshot(image, screenshot_folder(), screenshot_stem(scene->geometry->source));
  std::string said = words(saved, UnsavedWork::in_picture(previewer_));
  if (!saved || previewer_.render().progress().finished) return said;
  return fmt::format("Saved unfinished ({:.0f} %): {}", std::floor(100.0 * fraction), *saved);
}

std::optional<std::string> PictureSaver::begin(const SaveChoice& choice,
                                               const DisplaySettings& shown, double now_seconds) {
  if (!previewer_.scene() || display_.width() <= 0) return no_picture;
  if (choice.what != SaveChoice::What::picture && !choice.is_movie()) {
    due_ = choice;
    due_seconds_ = now_seconds + dialog_fades_seconds;
    return std::nullopt;
  }
  Snapshot snapshot = previewer_.render().snapshot();
  if (choice.size.x > 0) {
    snapshot.settings.width = choice.size.x;
    snapshot.settings.height = choice.size.y;
  }
  begun_edits_ = choice.is_movie() ? std::nullopt : UnsavedWork::in_picture(previewer_);
  snapshot.settings.layers = saved_layers(choice, snapshot.settings.method, shown.layer);
  DisplaySettings plain;
  plain.exposure_ev = shown.exposure_ev;
  plain.tone = shown.tone;
  if (choice.is_movie()) {
    begin_movie(choice, std::move(snapshot), plain.transform());
    return std::nullopt;
  }
  const ImageText text =
      picture_text(describe(*snapshot.scene, snapshot.camera, snapshot.settings, described(plain)));
  const PictureOrder order{std::move(snapshot), choice.path(), plain.transform(), text};
  job_.start(order.path, [order](const std::stop_token& stop, const auto& on_progress) {
    return write_picture(order, stop, on_progress);
  });
  return std::nullopt;
}

std::optional<std::string> PictureSaver::take_outcome() {
  const auto outcome = job_.take_outcome();
  return outcome ? std::optional(words(*outcome, begun_edits_)) : std::nullopt;
}

std::string PictureSaver::stop() {
  const auto state = job_.state();
  job_.cancel();
  return state ? "Stopped: " + std::filesystem::path(state->path).filename().string() +
                     " was not saved"
               : "No save in progress";
}

std::optional<SaveChoice> PictureSaver::take_due(double now_seconds) {
  if (!due_ || now_seconds < due_seconds_) return std::nullopt;
  return std::exchange(due_, std::nullopt);
}

std::string PictureSaver::save_read(const SaveChoice& choice, RgbImage image,
                                    const DisplaySettings& shown) {
  image.text = screenshot_text(previewer_, shown);
  const Result<void> written = write_png(choice.path(), image);
  return words(written ? Result<std::string>(choice.path()) : unexpected(written.error()),
               UnsavedWork::in_picture(previewer_));
}

std::optional<double> PictureSaver::seconds_to_due(double now_seconds) const {
  return due_ ? std::optional(std::max(0.0, due_seconds_ - now_seconds)) : std::nullopt;
}

}  // namespace asos::ui
