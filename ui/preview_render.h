#pragma once

#include "renderer/film/film.h"
#include "renderer/picture/picture_description.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/session/render_session.h"
#include "ui/refinement.h"
#include "ui/refining_film.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace asos::ui {

/// The render of what the window shows, and its picture: begun anew whenever what it is of changes,
/// resting when its refinement says so. One thread; rendering happens on others.
class PreviewRender {
 public:
  /// The inputs of a picture; nothing is rendered without a scene.
  struct Subject {
    std::shared_ptr<const RenderScene> scene;
    std::uint64_t camera_revision = 0;
    RenderSettings settings;
    Camera camera;
  };

  /// `wake` is called from the workers when `update` has something to do. `refinement` must outlive
  /// it.
  PreviewRender(std::function<void()> wake, Refinement& refinement);

  /// A finished picture, and how it was rendered.
  struct FinishedPicture {
    Film film;
    RenderSettings settings;
  };
  /// The last finished picture of the same view with another EPS or MAX; null: none.
  [[nodiscard]] const FinishedPicture* finished_before() const {
    return before_ ? &*before_ : nullptr;
  }

  /// Takes the tiles that are finished and restarts the render where it is not of `subject`. A
  /// render that has not covered the picture once is given a moment to do so: changes that come
  /// faster, as from a mouse, would else leave the picture's rim as it was. Call once or more a
  /// frame.
  void update(const Subject& subject, double now_seconds);
  /// Whether there is a subject, and the render is of another.
  [[nodiscard]] bool out_of_date(const Subject& subject) const;
  /// Whether parts of the running render's picture still show the one before: then what arrives
  /// should be shown without delay.
  [[nodiscard]] bool first_picture_pending() const;

  /// Of a picture that another one follows by itself: whether it has covered the window and is
  /// worth no more waiting, with a sample for each pixel or after so many seconds.
  [[nodiscard]] bool shown_for(double seconds, double now_seconds) const;

  /// Ends the render as it is; `start_again` or a change begins anew.
  void stop();
  /// Goes on even if it was paused: who asks for a picture wants to see it.
  void start_again();

  [[nodiscard]] const Film& film() const { return film_.film(); }
  /// The parts of the film that changed since the last call.
  [[nodiscard]] std::vector<PixelRect> take_changed() { return film_.take_changed(); }
  /// See RefiningFilm.
  [[nodiscard]] std::uint64_t map_revision() const { return film_.map_revision(); }
  [[nodiscard]] double split_share() const { return film_.split_share(); }
  [[nodiscard]] std::optional<double> estimated_rmse() const { return film_.estimated_rmse(); }
  [[nodiscard]] Progress progress() const { return session_.progress(); }
  [[nodiscard]] Reached reached() const { return session_.reached(); }
  [[nodiscard]] RenderStatistics statistics() const { return session_.statistics(); }
  /// How often a render was started.
  [[nodiscard]] std::uint64_t restarts() const { return restarts_; }

  /// The settings of the render that runs, its size included.
  [[nodiscard]] const RenderSettings& settings() const { return rendered_.settings; }
  /// The inputs of the picture that is shown. Only with one.
  [[nodiscard]] Snapshot snapshot() const {
    return {rendered_.scene, rendered_.camera, rendered_.settings, false, true};
  }
  /// The description of the picture that is shown, whether it is finished or not. Only with one.
  [[nodiscard]] PictureDescription description(const PictureDisplay& display) const;

 private:
  [[nodiscard]] bool should_wait(const Subject& subject, double now_seconds) const;
  void restart(const Subject& subject, double now_seconds);
  void take_tiles(double now_seconds);
  void follow_splitting(const Subject& subject);
  void rest_or_go_on();

  Refinement& refinement_;
  Subject rendered_;
  double restarted_seconds_ = 0.0;
  std::uint64_t restarts_ = 0;
  std::vector<FinishedTile> held_;  // until the first pass has covered the picture
  std::optional<FinishedPicture> before_;
  RefiningFilm film_;
  RenderSession session_;
};

}  // namespace asos::ui
