#pragma once

#include "renderer/film/film.h"
#include "renderer/picture/picture_description.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/session/render_session.h"
#include "ui/refinement.h"
#include "ui/refining_film.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace asos::ui {

/// The window's render and its picture: restarted whenever its subject changes, paused when the
/// refinement says so. Not thread-safe; rendering happens on other threads.
class PreviewRender {
 public:
  /// The inputs of a picture. Without a scene nothing is rendered.
  struct Subject {
    std::shared_ptr<const RenderScene> scene;
    std::uint64_t camera_revision = 0;
    RenderSettings settings;
    Camera camera;
  };

  /// `wake` is called from the workers when `update` has tiles to take. `refinement` must outlive
  /// the object.
  PreviewRender(std::function<void()> wake, Refinement& refinement);

  /// A finished picture and its settings.
  struct FinishedPicture {
    Film film;
    RenderSettings settings;
  };
  /// The last finished picture of this view with another EPS or MAX; null: none.
  [[nodiscard]] const FinishedPicture* finished_before() const {
    return before_ ? &*before_ : nullptr;
  }

  /// Takes finished tiles, and restarts the render if its subject differs. A render that has not
  /// covered the picture once gets a moment to do so; otherwise fast changes, as from a mouse,
  /// would never update the picture's rim. Call at least once a frame.
  void update(const Subject& subject, double now_seconds);
  /// Whether there is a subject and the render is of another one.
  [[nodiscard]] bool out_of_date(const Subject& subject) const;
  /// Whether parts of the picture still come from the previous render. Then arriving tiles should
  /// be shown without delay.
  [[nodiscard]] bool first_picture_pending() const;

  /// Returns whether the next picture of a sequence may follow: this one has covered the window,
  /// and has a sample per pixel or has been rendered for `seconds`.
  [[nodiscard]] bool shown_for(double seconds, double now_seconds) const;

  /// Makes this part of the picture final before the rest, in this and in later renders of the same
  /// size; empty: no part.
  void prefer(const PixelRect& part);
  [[nodiscard]] const PixelRect& preferred() const { return preferred_; }

  /// Ends the render; `start_again` or a change starts a new one.
  void stop();
  /// Restarts the render and ends a pause.
  void start_again();

  [[nodiscard]] const Film& film() const { return film_.film(); }
  /// Returns the areas of the film that changed since the last call.
  [[nodiscard]] std::vector<PixelRect> take_changed() { return film_.take_changed(); }
  /// See RefiningFilm.
  [[nodiscard]] std::uint64_t map_revision() const { return film_.map_revision(); }
  [[nodiscard]] double split_share() const { return film_.split_share(); }
  [[nodiscard]] std::optional<double> estimated_rmse() const { return film_.estimated_rmse(); }
  /// Finished once the film holds every final tile.
  [[nodiscard]] Progress progress() const;
  [[nodiscard]] Reached reached() const { return shown_ ? shown_->reached : session_.reached(); }
  /// The fraction of final pixels, 0 to 1.
  [[nodiscard]] double final_share() const {
    return progress().finished ? 1.0 : reached().final_share;
  }
  [[nodiscard]] RenderStatistics statistics() const {
    return shown_ ? shown_->statistics : session_.statistics();
  }
  /// Number of renders started so far.
  [[nodiscard]] std::uint64_t restarts() const { return restarts_; }

  /// Settings of the running render, with its size.
  [[nodiscard]] const RenderSettings& settings() const { return rendered_.settings; }
  /// The inputs of the displayed picture. Requires one.
  [[nodiscard]] Snapshot snapshot() const {
    return {rendered_.scene, rendered_.camera, rendered_.settings, false, true};
  }
  /// Description of the displayed picture, finished or not. Requires one.
  [[nodiscard]] PictureDescription description(const PictureDisplay& display) const;

 private:
  [[nodiscard]] bool should_wait(const Subject& subject, double now_seconds) const;
  void restart(const Subject& subject, double now_seconds);
  void take_tiles(double now_seconds);
  void follow_splitting(const Subject& subject);
  void rest_or_go_on();
  [[nodiscard]] bool all_final() const;
  [[nodiscard]] bool seen_finished() const;
  void keep_finished(const Subject& next);
  [[nodiscard]] bool show_kept(const Subject& subject);

  /// The facts of a finished render.
  struct Outcome {
    Progress progress;
    Reached reached;
    RenderStatistics statistics;
  };
  /// A finished picture that may be shown again.
  struct Kept {
    std::weak_ptr<const RenderScene> scene;
    Camera camera;
    RenderSettings settings;
    RefiningFilm film;
    Outcome outcome;
  };
  [[nodiscard]] static bool is_picture_of(const Kept& kept, const Subject& subject);

  Refinement& refinement_;
  Subject rendered_;
  PixelRect preferred_;
  double restarted_seconds_ = 0.0;
  std::uint64_t restarts_ = 0;
  std::vector<FinishedTile> held_;  // tiles waiting until the first pass has covered the picture
  std::optional<FinishedPicture> before_;
  RefiningFilm film_;
  bool took_all_ = false;         // whether the film holds the finished session's tiles
  int finished_updates_ = 0;      // since the picture was finished
  std::deque<Kept> kept_;         // the newest is the last
  std::optional<Outcome> shown_;  // of the kept picture that is shown; none: the session's
  RenderSession session_;
};

}  // namespace asos::ui
