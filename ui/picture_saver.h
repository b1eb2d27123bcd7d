#pragma once

#include "ui/picture_job.h"
#include "ui/save_choice.h"
#include "ui/unsaved_work.h"

#include <optional>
#include <string>
#include <utility>

namespace asos::ui {

class GlDisplay;
class Playback;
class Previewer;
struct DisplaySettings;

/// Length in seconds of the chosen animation, or of the first one; 0: the scene has none.
[[nodiscard]] double clip_seconds(const Playback& playback);

/// Saves the content of the window: the film, the picture rendered at any size, or the framebuffer.
/// The members that save return a message for the user, or nothing yet. Not thread-safe; pictures
/// are rendered on other threads.
class PictureSaver {
 public:
  PictureSaver(const Previewer& previewer, const GlDisplay& display)
      : previewer_(previewer), display_(display) {}

  /// Saves the displayed film as a PNG under the next free name, with the legend below a split map.
  [[nodiscard]] std::string save_shown(const DisplaySettings& shown, double fraction);
  /// Starts the job that the save dialog has confirmed.
  [[nodiscard]] std::optional<std::string> begin(const SaveChoice& choice,
                                                 const DisplaySettings& shown, double now_seconds);
  /// Returns the message about the rendered picture, once.
  [[nodiscard]] std::optional<std::string> take_outcome();
  /// Cancels the picture being rendered; no file is left.
  [[nodiscard]] std::string stop();
  /// Returns the choice when it is time to read the framebuffer: once the dialog has faded out.
  [[nodiscard]] std::optional<SaveChoice> take_due(double now_seconds);
  /// Saves the image that was read from the framebuffer.
  [[nodiscard]] std::string save_read(const SaveChoice& choice, RgbImage image,
                                      const DisplaySettings& shown);

  /// Seconds until `take_due` returns a choice.
  [[nodiscard]] std::optional<double> seconds_to_due(double now_seconds) const;
  [[nodiscard]] const PictureJob& job() const { return job_; }
  /// Returns the edits in the metadata of the last saved picture, once.
  [[nodiscard]] std::optional<UnsavedWork::Edits> take_saved_edits() {
    return std::exchange(saved_edits_, std::nullopt);
  }

 private:
  [[nodiscard]] std::string words(const Result<std::string>& saved,
                                  const std::optional<UnsavedWork::Edits>& edits);
  void begin_movie(const SaveChoice& choice, Snapshot snapshot, const DisplayTransform& display);

  const Previewer& previewer_;
  const GlDisplay& display_;
  PictureJob job_;
  std::optional<SaveChoice> due_;
  double due_seconds_ = 0.0;
  std::optional<UnsavedWork::Edits> begun_edits_;  // of the job's picture; none: a movie
  std::optional<UnsavedWork::Edits> saved_edits_;
};

}  // namespace asos::ui
