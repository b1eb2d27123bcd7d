#include "ui/picture_saver.h"

#include "renderer/picture/picture_text.h"
#include "ui/gl_display.h"
#include "ui/previewer.h"
#include "ui/screenshot.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace asos {

namespace {

constexpr double dialog_fades_seconds = 0.3;
constexpr const char* no_picture = "No picture to save yet";

}  // namespace

std::string PictureSaver::words(const Result<std::string>& saved) {
  if (!saved) return "Not saved: " + saved.error().message();
  ++saved_;
  return "Saved " + *saved;
}

std::string PictureSaver::save_shown(const DisplaySettings& shown) {
  const RenderScene* scene = previewer_.scene().get();
  if (!scene || display_.width() <= 0) return no_picture;
  const RgbImage image{display_.width(), display_.height(), display_.seen_rgb(shown),
                       screenshot_text(previewer_, shown)};
  return words(
      save_screenshot(image, screenshot_folder(), screenshot_stem(scene->geometry->source)));
}

std::optional<std::string> PictureSaver::begin(const SaveChoice& choice,
                                               const DisplaySettings& shown, double now_seconds) {
  if (!previewer_.scene() || display_.width() <= 0) return no_picture;
  if (choice.what != SaveChoice::What::picture) {
    due_ = choice;
    due_seconds_ = now_seconds + dialog_fades_seconds;
    return std::nullopt;
  }
  Snapshot snapshot = previewer_.render().snapshot();
  if (choice.size.x > 0) {
    snapshot.settings.width = choice.size.x;
    snapshot.settings.height = choice.size.y;
  }
  DisplaySettings plain;
  plain.exposure_ev = shown.exposure_ev;
  plain.tone = shown.tone;
  const ImageText text =
      picture_text(describe(*snapshot.scene, snapshot.camera, snapshot.settings, described(plain)));
  job_.start({std::move(snapshot), choice.path(), plain.transform(), text});
  return std::nullopt;
}

std::optional<std::string> PictureSaver::take_outcome() {
  const auto outcome = job_.take_outcome();
  return outcome ? std::optional(words(*outcome)) : std::nullopt;
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
  return words(written ? Result<std::string>(choice.path()) : unexpected(written.error()));
}

std::optional<double> PictureSaver::seconds_to_due(double now_seconds) const {
  return due_ ? std::optional(std::max(0.0, due_seconds_ - now_seconds)) : std::nullopt;
}

}  // namespace asos
