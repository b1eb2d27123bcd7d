#include "ui/previewer.h"

#include "renderer/comparison/method.h"

#include <algorithm>
#include <utility>

namespace asos::ui {

namespace {

// Time in seconds that each view of an animation or a turntable may refine.
constexpr double view_seconds = 1.0 / 24.0;

}  // namespace

Previewer::Previewer(Hooks hooks, const RenderSettings& settings)
    : scene_(std::move(hooks.load), hooks.wake, hooks.forced),
      edits_(scene_, settings, hooks.wake),
      playback_(scene_, edits_, hooks.wake),
      viewpoint_(scene_, edits_.settings()),
      ground_(hooks.wake),
      lines_and_points_(hooks.wake),
      render_(hooks.wake, refinement_) {
  scene_.expect_ground([this] { return edits_.own_ground(); });
}

void Previewer::update(double now_seconds) {
  viewpoint_.settle_size(now_seconds);
  const std::shared_ptr<const RenderScene> before = scene_.shared();
  if (const std::optional<OpenScene::Opened> opened = scene_.take_opened())
    take_over(*opened, before.get());
  edits_.relight();
  if (!edits_.relighting()) {
    const std::shared_ptr<const RenderScene> plain = scene_.shared();
    if (const auto opened = scene_.put_images()) take_over(*opened, plain.get());
  }
  // The next pose is computed while the last one is displayed.
  const double posing_seconds = playback_.pose_seconds() + playback_.prepare_seconds();
  playback_.update(has_shown(view_seconds - posing_seconds, now_seconds), now_seconds,
                   wanted_lines(), wanted_exposure());
  viewpoint_.follow_chosen();
  if (scene_ && turntable_.begins()) viewpoint_.make_room_to_turn();
  if (scene_)
    turntable_.update(viewpoint_.camera(), has_shown(view_seconds, now_seconds), now_seconds);
  if (const auto drawn = playback_.take_drawn_lines())
    lines_and_points_.adopt(scene_, drawn->picture, drawn->camera_revision);
  ground_.update(scene_, edits_.settings().ground, edits_.relighting());
  lines_and_points_.update(scene_, subject(), edits_.relighting(), now_seconds);
  render_.update(subject(), now_seconds);
  await_first_picture();
  free_memory_.update();
  // The previous scene and the memory used for loading are free by then.
  if (holds_free_memory_ && !scene_.loading() && !render_.first_picture_pending() &&
      !render_.out_of_date(subject()) &&
      (scene_->geometry->boundaries.known() || !needs_boundaries(render_.settings().method))) {
    holds_free_memory_ = false;
    free_memory_.give_back_soon();
  }
}

// Textures would take the processors from the first picture.
void Previewer::await_first_picture() {
  const PreviewRender::Subject now = subject();
  if (!now.scene || (!render_.out_of_date(now) && !render_.first_picture_pending()))
    awaits_first_picture_ = false;
  if (!awaits_first_picture_) scene_.load_textures();
}

void Previewer::take_over(const OpenScene::Opened& opened, const RenderScene* before) {
  holds_free_memory_ = true;
  awaits_first_picture_ |= !opened.same_file;
  if (before && opened.same_file)
    carried_ = edits_.adopt_again(*before, opened.moved);
  else
    edits_.adopt_scene(opened.picture);
  playback_.adopt_scene(opened.reloaded);
  if (opened.picture) {
    viewpoint_.take_over(opened.picture->camera_from(scene_->world().origin));
  } else if (!opened.reloaded) {
    viewpoint_.choose_camera(scene_->world().cameras.empty() ? -1 : 0);
  } else if (opened.moved != glm::dvec3(0.0)) {
    viewpoint_.camera().look_at(viewpoint_.camera().pivot() + opened.moved);
  }
  if (const Result<void> able = check_method(*scene_, edits_.settings()); !able) {
    Error error = able.error();
    error.reason += "; using ASOS instead";
    scene_.report(std::move(error));
    edits_.settings().method = Method::asos;
  }
}

bool Previewer::has_shown(double seconds, double now_seconds) const {
  return !render_.out_of_date(subject()) && render_.shown_for(seconds, now_seconds);
}

PreviewRender::Subject Previewer::subject() const {
  if (!scene_ || !viewpoint_.sized()) return {};
  const OrbitCamera& camera = viewpoint_.camera();
  RenderSettings settings = judged_by(edits_.settings(), shown_tone_);
  settings.shutter.camera = settings.shutter.blurs() ? followed_camera() : -1;
  settings.layers = {};
  const bool renders =
      shown_layer_ && has_plane(*shown_layer_) && renders_layer(settings.method, *shown_layer_);
  if (renders) settings.layers.insert(*shown_layer_);
  return {scene_.shared(), camera.revision(), std::move(settings), camera.camera()};
}

// Returns the index of the scene's camera whose motion blurs the picture: the chosen one, or else
// that of an opened picture. Returns -1 once the user has moved the view.
int Previewer::followed_camera() const {
  if (viewpoint_.left_chosen()) return -1;
  const int chosen = viewpoint_.chosen_camera();
  return chosen >= 0 ? chosen : edits_.settings().shutter.camera;
}

std::optional<Playback::WantedExposure> Previewer::wanted_exposure() const {
  PreviewRender::Subject seen = subject();
  if (!seen.scene || !seen.settings.shutter.blurs()) return std::nullopt;
  if (!row_of(seen.settings.method).takes_motion) return std::nullopt;
  return Playback::WantedExposure{seen.camera, std::move(seen.settings)};
}

std::optional<Playback::LineRequest> Previewer::wanted_lines() const {
  const PreviewRender::Subject seen = subject();
  if (!seen.scene || seen.scene->world().lines_and_points.empty()) return std::nullopt;
  const int follows = viewpoint_.left_chosen() ? -1 : viewpoint_.chosen_camera();
  return Playback::LineRequest{line_picture(seen.camera, seen.settings), seen.camera_revision,
                               follows};
}

std::optional<double> Previewer::seconds_to_update(double now_seconds) const {
  // A change that waits for the first picture is retried with the next tiles, so check in every
  // frame.
  if (render_.out_of_date(subject()) || edits_.relighting()) return 0.0;
  if (playback_.playing() || turntable_.turning()) return Playback::frame_seconds;
  std::optional<double> due = viewpoint_.seconds_to_settle(now_seconds);
  if (const std::optional<double> drawing = lines_and_points_.seconds_to_update(now_seconds))
    due = std::min(due.value_or(*drawing), *drawing);
  if (const std::optional<double> limit = refinement_.seconds_to_limit(render_.progress()))
    due = std::min(due.value_or(*limit), *limit);
  return due;
}

}  // namespace asos::ui
