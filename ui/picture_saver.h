#pragma once

#include "ui/picture_job.h"
#include "ui/save_choice.h"

#include <optional>
#include <string>

namespace asos::ui {

class GlDisplay;
class Playback;
class Previewer;
struct DisplaySettings;

/// The length of the animation that is chosen, or of the first one; 0: there is none.
[[nodiscard]] double clip_seconds(const Playback& playback);

/// Saves what the window shows: the film as it is, the picture rendered to the end at any size, or
/// the framebuffer. Each member that saves returns what to tell the person, or nothing yet. One
/// thread; a picture is rendered on others.
class PictureSaver {
 public:
  PictureSaver(const Previewer& previewer, const GlDisplay& display)
      : previewer_(previewer), display_(display) {}

  /// The film as it is shown, as a PNG under the next free name; below a split map its legend.
  [[nodiscard]] std::string save_shown(const DisplaySettings& shown);
  /// Begins what the dialog was asked for.
  [[nodiscard]] std::optional<std::string> begin(const SaveChoice& choice,
                                                 const DisplaySettings& shown, double now_seconds);
  /// The outcome of the picture that was rendered, once.
  [[nodiscard]] std::optional<std::string> take_outcome();
  /// Ends the picture that is being rendered; nothing of it is left.
  [[nodiscard]] std::string stop();
  /// What of the framebuffer is to be saved now, once the dialog has faded from it.
  [[nodiscard]] std::optional<SaveChoice> take_due(double now_seconds);
  /// Saves what was read from the framebuffer.
  [[nodiscard]] std::string save_read(const SaveChoice& choice, RgbImage image,
                                      const DisplaySettings& shown);

  /// When `take_due` has something, in seconds.
  [[nodiscard]] std::optional<double> seconds_to_due(double now_seconds) const;
  [[nodiscard]] const PictureJob& job() const { return job_; }
  /// How many pictures were saved that hold the edits of the scene.
  [[nodiscard]] int saved() const { return saved_; }

 private:
  [[nodiscard]] std::string words(const Result<std::string>& saved);
  void begin_movie(const SaveChoice& choice, Snapshot snapshot, const DisplayTransform& display);

  const Previewer& previewer_;
  const GlDisplay& display_;
  PictureJob job_;
  std::optional<SaveChoice> due_;
  double due_seconds_ = 0.0;
  int saved_ = 0;
  bool movie_ = false;  // the job writes a movie, which does not hold the edits
};

}  // namespace asos::ui
