#include "ui/previewer.h"

#include "renderer/comparison/method.h"
#include "renderer/scene/load.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asos {

namespace {

// A window that is being dragged larger asks for many sizes; rendering waits until it rests.
constexpr double size_rest_seconds = 0.15;
// How long changes wait for the first coarse picture of the render before them.
constexpr double first_picture_seconds = 0.1;

double radius_of(const Box& bounds) {
  return bounds.empty() ? 1.0 : 0.5 * static_cast<double>(glm::length(bounds.hi - bounds.lo));
}

/// The old picture in the new size, so that the window shows something until tiles arrive.
Film stretched(const Film& old, int width, int height) {
  Film film(width, height);
  if (old.width <= 0 || old.height <= 0) return film;
  for (int y = 0; y < height; ++y) {
    const int from_y = static_cast<int>(static_cast<std::int64_t>(y) * old.height / height);
    for (int x = 0; x < width; ++x) {
      const int from_x = static_cast<int>(static_cast<std::int64_t>(x) * old.width / width);
      film.radiance[film.index(x, y)] = old.radiance[old.index(from_x, from_y)];
      film.split_level[film.index(x, y)] = old.split_level[old.index(from_x, from_y)];
      film.cause[film.index(x, y)] = old.cause[old.index(from_x, from_y)];
    }
  }
  return film;
}

/// How far ahead a camera's subject lies: the middle one of the depths that it sees around its
/// centre. A single ray could slip through a gap and find the horizon. 0 where nothing is seen.
double subject_distance(const RenderScene& scene, const Camera& camera) {
  constexpr int grid = 9, margin = 2;
  const View view(camera, grid, grid, radius_around_origin(scene.world.bounds));
  const glm::dvec3 eye(camera.world_from_camera[3]);
  const glm::dvec3 forward = -glm::dvec3(camera.world_from_camera[2]);
  std::vector<double> depths;
  for (int y = margin; y < grid - margin; ++y) {
    for (int x = margin; x < grid - margin; ++x) {
      const Ray ray = view.ray(x + 0.5, y + 0.5);
      const Hit hit = scene.rays.closest(ray);
      if (hit.valid()) depths.push_back(glm::dot(glm::dvec3(ray.at(hit.t)) - eye, forward));
    }
  }
  if (depths.empty()) return 0.0;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

/// Of linear values clipped to 0 to 1, summed over pixels and colours.
double squared_difference(const Film& film, const FinishedTile& tile) {
  double sum = 0.0;
  for (int y = 0; y < tile.rect.height; ++y) {
    for (int x = 0; x < tile.rect.width; ++x) {
      const auto from = static_cast<std::size_t>(y) * static_cast<std::size_t>(tile.rect.width) +
                        static_cast<std::size_t>(x);
      const glm::vec3 before = film.radiance[film.index(tile.rect.x + x, tile.rect.y + y)];
      const glm::vec3 d =
          glm::clamp(tile.radiance[from], 0.0f, 1.0f) - glm::clamp(before, 0.0f, 1.0f);
      sum += static_cast<double>(glm::dot(d, d));
    }
  }
  return sum;
}

LoadFunction load_or_default(LoadFunction load) {
  if (load) return load;
  return [](const std::string& source) { return load_scene(source); };
}

}  // namespace

Previewer::Previewer(Hooks hooks, RenderSettings settings)
    : first_settings_(settings),
      settings_(settings),
      session_(hooks.wake),
      loader_(load_or_default(std::move(hooks.load)), hooks.wake, hooks.forced),
      relighter_(relit, hooks.wake, Overtaken::kept) {
  settings_.crop = {};  // The window shows whole pictures.
}

void Previewer::open(const std::string& source) {
  error_.reset();
  reload_failed_ = false;
  asked_for_ = source;
  keep_view_ = false;
  loader_.open(source);
}

void Previewer::reload() {
  if (!scene_) return;
  open(scene_->source);
  keep_view_ = true;
}

void Previewer::set_picture_size(int width, int height, double now_seconds) {
  if (width <= 0 || height <= 0) {
    pending_size_.reset();
    return;
  }
  if (!sized_) {
    settings_.width = width;
    settings_.height = height;
    sized_ = true;
  } else if (width == settings_.width && height == settings_.height) {
    pending_size_.reset();
  } else if (!pending_size_ || pending_size_->width != width || pending_size_->height != height) {
    pending_size_ = {width, height, now_seconds};
  }
}

std::optional<double> Previewer::seconds_to_update(double now_seconds) const {
  // What waits for the first picture goes on with the next tiles: look again at once.
  if (out_of_date() || relighting()) return 0.0;
  std::optional<double> due;
  if (pending_size_)
    due = std::max(0.0, pending_size_->since_seconds + size_rest_seconds - now_seconds);
  const Progress progress = session_.progress();
  if (progress.running && limits_.seconds > 0.0) {
    const double left = std::max(0.0, limits_.seconds - progress.seconds);
    due = std::min(due.value_or(left), left);
  }
  return due;
}

void Previewer::update(double now_seconds) {
  settle_size(now_seconds);
  if (std::optional<LoadOutcome> outcome = loader_.take_outcome()) accept(std::move(*outcome));
  relight_if_edited();
  take_tiles();
  restart_if_changed(now_seconds);
  rest_or_go_on();
}

void Previewer::rest_or_go_on() {
  if (rest_ == Rest::stopped) return;
  const Progress progress = session_.progress();
  const std::optional<double> rmse = estimated_rmse();
  Rest rest = Rest::none;
  if (paused_) {
    rest = Rest::paused;
  } else if (limits_.seconds > 0.0 && progress.seconds >= limits_.seconds) {
    rest = Rest::time;
  } else if (limits_.rmse > 0.0 && rmse && *rmse <= limits_.rmse) {
    rest = Rest::quality;
  }
  if (rest == rest_) return;
  rest_ = rest;
  rest == Rest::none ? session_.resume() : session_.pause();
}

void Previewer::stop() {
  session_.cancel();
  if (rendered_.scene && !session_.progress().finished) rest_ = Rest::stopped;
}

void Previewer::start_again() {
  rendered_ = {};
}

std::optional<double> Previewer::estimated_rmse() const {
  const auto pixels = static_cast<std::int64_t>(film_.width) * film_.height;
  if (pixels_finished_ == 0) return std::nullopt;
  const double left = static_cast<double>(pixels - pixels_finished_) / static_cast<double>(pixels);
  return std::sqrt(std::max(0.0, left) * corrected_ /
                   (3.0 * static_cast<double>(pixels_finished_)));
}

void Previewer::settle_size(double now_seconds) {
  if (!pending_size_ || now_seconds - pending_size_->since_seconds < size_rest_seconds) return;
  settings_.width = pending_size_->width;
  settings_.height = pending_size_->height;
  pending_size_.reset();
}

void Previewer::accept(LoadOutcome outcome) {
  if (!outcome.scene) {
    error_ = outcome.scene.error();
    reload_failed_ = std::exchange(keep_view_, false);
    if (reload_failed_) files_ = std::move(outcome.files);
    return;
  }
  files_ = std::move(outcome.files);
  scene_ = std::move(*outcome.scene);
  load_seconds_ = outcome.load_seconds;
  ++scenes_opened_;
  reset_lights();
  reset_dfrs();
  lights_asked_for_ = lights_of_scene_ = lights_revision_;  // it has them
  dfrs_asked_for_ = dfrs_revision_;
  const bool keep_view = std::exchange(keep_view_, false);
  if (outcome.picture) {
    take_over(*outcome.picture);
  } else if (!keep_view) {
    choose_camera(scene_->world.cameras.empty() ? -1 : 0);
  }
  if (const Result<void> able = check_method(*scene_, settings_); !able) {
    error_ = able.error();
    error_->reason += "; ASOS takes its place";
    settings_.method = Method::asos;
  }
}

// The scene has the picture's lights and ratios already.
void Previewer::take_over(const PictureDescription& picture) {
  lights_.clear();
  for (const Light& light : scene_->world.lights) lights_.push_back(EditedLight::of(light));
  dfrs_ = dfrs_of(scene_->world);
  RenderSettings settings = picture.settings;
  settings.crop = {};
  settings.width = settings_.width;
  settings.height = settings_.height;
  settings.threads = settings_.threads;
  settings_ = std::move(settings);
  opened_display_ = picture.display;
  chosen_camera_ = -1;
  take_over(picture.camera_from(scene_->world.origin));
}

void Previewer::choose_camera(int index) {
  if (!scene_) return;
  const World& world = scene_->world;
  const bool from_file = index >= 0 && index < static_cast<int>(world.cameras.size());
  chosen_camera_ = from_file ? index : -1;
  const Camera camera = from_file ? world.cameras[static_cast<std::size_t>(index)]
                                  : default_camera(world, aspect_ratio());
  take_over(camera);
}

void Previewer::take_over(const Camera& camera) {
  const World& world = scene_->world;
  // Orbit what the camera looks at; where that is nothing, the scene's middle as seen from it.
  const double radius = radius_of(world.bounds);
  camera_.set(camera, radius, radius);
  double distance = subject_distance(*scene_, camera);
  if (distance <= 0.0 && !world.bounds.empty()) {
    const glm::dvec3 middle(0.5f * (world.bounds.lo + world.bounds.hi));
    const glm::dvec3 eye(camera.world_from_camera[3]);
    distance = glm::dot(middle - eye, -glm::dvec3(camera.world_from_camera[2]));
  }
  if (distance > 0.0) camera_.set(camera, distance, radius);
}

void Previewer::frame_all() {
  if (scene_) camera_.frame_all(scene_->world.bounds, aspect_ratio());
}

void Previewer::set_pivot_at(double x, double y) {
  if (!scene_ || !sized_) return;
  const Hit hit = seen_at(x, y);
  if (hit.valid()) camera_.look_at(glm::dvec3(view().ray(x, y).at(hit.t)));
}

View Previewer::view() const {
  return View(camera_.camera(), settings_.width, settings_.height,
              radius_around_origin(scene_->world.bounds));
}

Hit Previewer::seen_at(double x, double y) const {
  if (!scene_ || !sized_) return {};
  return scene_->rays.closest(view().ray(x, y), seen_faces(settings_));
}

bool Previewer::out_of_date() const {
  return scene_ && sized_ &&
         (rendered_.scene != scene_ || rendered_.camera_revision != camera_.revision() ||
          rendered_.settings != settings_);
}

bool Previewer::first_picture_pending() const {
  const Progress progress = session_.progress();
  return rendered_.scene && (progress.running || progress.paused) &&
         pixels_taken_ < static_cast<std::int64_t>(film_.width) * film_.height;
}

bool Previewer::should_wait(double now_seconds) const {
  const bool same_picture = rendered_.scene == scene_ && film_.width == settings_.width &&
                            film_.height == settings_.height;
  return same_picture && first_picture_pending() &&
         now_seconds - restarted_seconds_ < first_picture_seconds;
}

void Previewer::restart_if_changed(double now_seconds) {
  if (!out_of_date() || should_wait(now_seconds)) return;
  // The old scene may go only when no worker uses it any more, which restart sees to.
  session_.restart({scene_, camera_.camera(), settings_, true});
  rendered_ = {scene_, camera_.revision(), settings_, camera_.camera()};
  ++restarts_;
  restarted_seconds_ = now_seconds;
  pixels_taken_ = 0;
  corrected_ = 0.0;
  pixels_finished_ = 0;
  rest_ = rest_ == Rest::paused ? Rest::paused : Rest::none;
  if (rest_ == Rest::none) session_.resume();
  if (film_.width != settings_.width || film_.height != settings_.height) {
    film_ = stretched(film_, settings_.width, settings_.height);
    changed_ = {{0, 0, film_.width, film_.height}};
  }
}

void Previewer::take_tiles() {
  for (const FinishedTile& tile : session_.take_finished()) {
    if (!tile.coarse) {
      corrected_ += squared_difference(film_, tile);
      pixels_finished_ += static_cast<std::int64_t>(tile.rect.width) * tile.rect.height;
    }
    film_.put(tile);
    changed_.push_back(tile.rect);
    pixels_taken_ += static_cast<std::int64_t>(tile.rect.width) * tile.rect.height;
  }
}

PictureDescription Previewer::description(const PictureDisplay& display) const {
  return describe(*rendered_.scene, rendered_.camera, rendered_.settings, display);
}

double Previewer::aspect_ratio() const {
  return static_cast<double>(settings_.width) / static_cast<double>(settings_.height);
}

}  // namespace asos
