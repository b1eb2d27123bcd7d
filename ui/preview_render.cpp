#include "ui/preview_render.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace asos::ui {

namespace {

// Time in seconds that changes wait for the first coarse picture of the running render. Its tiles
// wait for each other as long, so that the picture appears as a whole. A slower pass shows its
// tiles after this time. Measured at 952x704 on two busy cores: 3 to 35 ms for office, fence and
// Fox, 100 to 130 ms for HotelRoom, 350 to 500 ms for ToyCar.
constexpr double first_picture_seconds = 1.0;

// Whether the subjects differ in EPS and MAX only.
bool differs_in_splitting_only(const PreviewRender::Subject& a, const PreviewRender::Subject& b) {
  RenderSettings settings = a.settings;
  settings.asos.eps = b.settings.asos.eps;
  settings.asos.max_level = b.settings.asos.max_level;
  return a.scene == b.scene && a.camera_revision == b.camera_revision && settings == b.settings;
}

}  // namespace

PreviewRender::PreviewRender(std::function<void()> wake, Refinement& refinement)
    : refinement_(refinement), session_(std::move(wake)) {}

void PreviewRender::update(const Subject& subject, double now_seconds) {
  take_tiles(now_seconds);
  finished_updates_ = progress().finished ? finished_updates_ + 1 : 0;
  if (subject.scene && differs_in_splitting_only(rendered_, subject)) follow_splitting(subject);
  if (out_of_date(subject) && !should_wait(subject, now_seconds)) restart(subject, now_seconds);
  rest_or_go_on();
}

// Holds the tiles until the first pass covers the picture: a mix of two poses would look torn.
void PreviewRender::take_tiles(double now_seconds) {
  if (shown_) return;
  // Read before the tiles are taken, so that these include the whole pass.
  took_all_ = session_.progress().finished;
  const Reached reached = session_.reached();
  const bool whole = reached.pass != Reached::Pass::nothing;
  std::vector<FinishedTile> tiles = session_.take_finished();
  held_.insert(held_.end(), std::make_move_iterator(tiles.begin()),
               std::make_move_iterator(tiles.end()));
  if (!whole && now_seconds - restarted_seconds_ < first_picture_seconds) return;
  for (FinishedTile& tile : held_) film_.put(std::move(tile), reached.samples);
  held_.clear();
}

// Predicts the split map of another EPS or MAX at once, and keeps the finished picture of the
// previous setting.
void PreviewRender::follow_splitting(const Subject& subject) {
  if (rendered_.settings != subject.settings && seen_finished() &&
      (!before_ || before_->settings != rendered_.settings))
    before_ = {film_.film(), rendered_.settings};
  film_.predict(subject.settings);
}

Progress PreviewRender::progress() const {
  if (shown_) return shown_->progress;
  Progress now = session_.progress();
  if (now.finished && !took_all_) {
    now.finished = false;
    now.running = true;
  }
  return now;
}

bool PreviewRender::out_of_date(const Subject& subject) const {
  return subject.scene && (rendered_.scene != subject.scene ||
                           rendered_.camera_revision != subject.camera_revision ||
                           rendered_.settings != subject.settings);
}

bool PreviewRender::first_picture_pending() const {
  const Progress now = progress();
  return rendered_.scene && (now.running || now.paused) && !film_.covered();
}

bool PreviewRender::shown_for(double seconds, double now_seconds) const {
  return !first_picture_pending() &&
         (reached().pass >= Reached::Pass::samples || now_seconds - restarted_seconds_ >= seconds);
}

bool PreviewRender::should_wait(const Subject& subject, double now_seconds) const {
  const bool same_picture = rendered_.scene == subject.scene &&
                            film().width == subject.settings.width &&
                            film().height == subject.settings.height;
  return same_picture && first_picture_pending() &&
         now_seconds - restarted_seconds_ < first_picture_seconds;
}

void PreviewRender::restart(const Subject& subject, double now_seconds) {
  // The old scene must not be destroyed while a worker uses it; restart waits for the workers.
  held_.clear();
  std::erase_if(kept_, [](const Kept& kept) { return kept.scene.expired(); });
  keep_finished(subject);
  took_all_ = false;
  const bool same_view = differs_in_splitting_only(rendered_, subject);
  if (!same_view) before_.reset();
  if (rendered_.settings.width != subject.settings.width ||
      rendered_.settings.height != subject.settings.height)
    prefer({});
  ++restarts_;
  restarted_seconds_ = now_seconds;
  refinement_.begin();
  if (show_kept(subject)) return;
  session_.restart({subject.scene, subject.camera, subject.settings, true, true});
  rendered_ = subject;
  if (refinement_.rest() == PauseReason::none) session_.resume();
  film_.begin(subject.settings, same_view);
}

bool PreviewRender::all_final() const {
  const Film& film = film_.film();
  return rendered_.scene && progress().finished && film.width == rendered_.settings.width &&
         std::none_of(film.unfinished.begin(), film.unfinished.end(),
                      [](std::uint8_t pixel) { return pixel != 0; });
}

// Whether the finished picture was seen for more than a moment, as within a drag.
bool PreviewRender::seen_finished() const {
  constexpr int least_updates = 4;
  return finished_updates_ >= least_updates && all_final();
}

// Keeps the picture of a finished render, to show it at once when its settings return.
void PreviewRender::keep_finished(const Subject& next) {
  constexpr std::size_t most_bytes = std::size_t{256} << 20, bytes_a_pixel = 96;
  if (!seen_finished() || next.scene != rendered_.scene ||
      next.camera_revision != rendered_.camera_revision)
    return;
  std::erase_if(kept_, [&](const Kept& kept) { return is_picture_of(kept, rendered_); });
  kept_.push_back({rendered_.scene,
                   rendered_.camera,
                   rendered_.settings,
                   film_,
                   {progress(), reached(), statistics()}});
  std::size_t pixels = 0;
  for (const Kept& kept : kept_) pixels += kept.film.film().radiance.size();
  for (; !kept_.empty() && bytes_a_pixel * pixels > most_bytes; kept_.pop_front())
    pixels -= kept_.front().film.film().radiance.size();
}

bool PreviewRender::is_picture_of(const Kept& kept, const Subject& subject) {
  return kept.scene.lock() == subject.scene && kept.camera == subject.camera &&
         kept.settings == subject.settings;
}

bool PreviewRender::show_kept(const Subject& subject) {
  shown_.reset();
  const auto found = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const Kept& kept) { return is_picture_of(kept, subject); });
  if (found == kept_.end()) return false;
  session_.cancel();
  (void)session_.take_finished();
  film_.show(found->film);
  shown_ = found->outcome;
  rendered_ = subject;
  return true;
}

void PreviewRender::rest_or_go_on() {
  if (shown_) return;
  if (!refinement_.decide(session_.progress(), film_.estimated_rmse())) return;
  refinement_.rest() == PauseReason::none ? session_.resume() : session_.pause();
}

void PreviewRender::prefer(const PixelRect& part) {
  preferred_ = part;
  session_.prefer(part);
}

void PreviewRender::stop() {
  session_.cancel();
  if (rendered_.scene && !shown_ && !session_.progress().finished) refinement_.end();
}

void PreviewRender::start_again() {
  refinement_.set_paused(false);
  rendered_ = {};
  kept_.clear();
}

PictureDescription PreviewRender::description(const PictureDisplay& display) const {
  return describe(*rendered_.scene, rendered_.camera, rendered_.settings, display);
}

}  // namespace asos::ui
