#include "ui/line_drawer.h"

#include <algorithm>
#include <utility>

namespace asos::ui {
namespace {

// Lines and points are drawn again once the camera has been still for this time.
constexpr double rest_seconds = 0.15;

}  // namespace

LineDrawer::LineDrawer(std::function<void()> wake)
    : job_(
          [](const Request& request) {
            return Drawn{request, with_lines(request.scene, request.picture)};
          },
          std::move(wake), Overtaken::kept) {}

LineDrawer::Wanted LineDrawer::wanted_of(const Request& request) {
  return {request.camera_revision, request.picture.height, request.picture.width};
}

bool LineDrawer::is_drawn(const RenderScene& scene, const Wanted& wanted) const {
  return drawn_.lock() == scene.geometry && drawn_for_ == wanted;
}

void LineDrawer::take(OpenScene& scene, bool busy) {
  std::optional<Drawn> done = job_.take_outcome();
  // Another scene may have been opened meanwhile, or its lights changed.
  if (!done || busy || scene.shared() != done->request.scene) return;
  drawn_for_ = wanted_of(done->request);
  drawn_ = scene->geometry;
  if (!done->scene) return scene.report(done->scene.error());
  drawn_ = (*done->scene)->geometry;
  scene.relight(std::move(*done->scene));
}

void LineDrawer::update(OpenScene& scene, const PreviewRender::Subject& subject, bool busy,
                        double now_seconds) {
  take(scene, busy);
  due_.reset();
  if (!scene || !subject.scene || scene->world().lines_and_points.empty()) return;
  const Request request{scene.shared(), line_picture(subject.camera, subject.settings),
                        subject.camera_revision};
  const Wanted wanted = wanted_of(request);
  if (wanted != newest_) {
    newest_ = wanted;
    newest_since_ = now_seconds;
  }
  if (busy || job_.pending() || is_drawn(*scene, wanted)) return;
  // A scene that was just opened is drawn without delay.
  const bool first = drawn_.lock() != scene->geometry;
  due_ = first ? now_seconds : newest_since_ + rest_seconds;
  if (now_seconds < *due_) return;
  due_.reset();
  job_.ask(request);
}

void LineDrawer::adopt(const OpenScene& scene, const LinePicture& picture,
                       std::uint64_t camera_revision) {
  drawn_ = scene->geometry;
  drawn_for_ = {camera_revision, picture.height, picture.width};
}

std::optional<double> LineDrawer::seconds_to_update(double now_seconds) const {
  if (!due_) return std::nullopt;
  return std::max(0.0, *due_ - now_seconds);
}

}  // namespace asos::ui
