#include "ui/previewer.h"

#include "renderer/methods/method.h"
#include "renderer/scene/load.h"

#include <algorithm>
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

/// The scene as it was prepared, before its lights were edited.
const RenderScene& built_scene(const RenderScene& scene) {
  return scene.built_from ? *scene.built_from : scene;
}

LoadFunction load_or_default(LoadFunction load) {
  if (load) return load;
  return [](const std::string& source) { return load_scene(source); };
}

}  // namespace

Previewer::Previewer(Hooks hooks, RenderSettings settings)
    : settings_(settings),
      session_(hooks.wake),
      loader_(load_or_default(std::move(hooks.load)), hooks.wake, hooks.forced),
      relighter_(
          [](const Relight& r) {
            return Relit{r.scene, with_lights(r.scene, r.lights)};
          },
          hooks.wake, Overtaken::kept) {
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
  if (!pending_size_) return std::nullopt;
  return std::max(0.0, pending_size_->since_seconds + size_rest_seconds - now_seconds);
}

void Previewer::update(double now_seconds) {
  settle_size(now_seconds);
  if (std::optional<LoadOutcome> outcome = loader_.take_outcome()) accept(std::move(*outcome));
  relight_if_edited();
  take_tiles();
  restart_if_changed(now_seconds);
}

std::vector<EditedLight>& Previewer::edit_lights() {
  ++lights_revision_;
  return lights_;
}

bool Previewer::relighting() const {
  return lights_asked_for_ != lights_revision_ || relighter_.pending();
}

void Previewer::reset_lights() {
  if (!scene_) return;
  lights_.clear();
  for (const Light& light : built_scene(*scene_).world.lights)
    lights_.push_back(EditedLight::of(light));
  ++lights_revision_;
}

void Previewer::relight_if_edited() {
  if (std::optional<Relit> relit = relighter_.take_outcome()) {
    // Another scene may have been opened meanwhile.
    const bool current = scene_ && &built_scene(*scene_) == &built_scene(*relit->from);
    if (current && relit->scene) scene_ = std::move(*relit->scene);
    if (current && !relit->scene) error_ = relit->scene.error();
  }
  if (!scene_ || lights_asked_for_ == lights_revision_) return;
  lights_asked_for_ = lights_revision_;
  relighter_.ask({scene_, lights_on(lights_)});
}

bool Previewer::same_as(const Edits& edits) const {
  RenderSettings sized = edits.settings;
  sized.width = settings_.width;
  sized.height = settings_.height;
  return settings_ == sized && camera_.revision() == edits.camera.revision() &&
         lights_revision_ == edits.lights_revision;
}

Previewer::Edits Previewer::edits() const {
  return {settings_, camera_, chosen_camera_, lights_, lights_revision_};
}

void Previewer::restore(const Edits& edits) {
  const int width = settings_.width, height = settings_.height;
  settings_ = edits.settings;
  settings_.width = width;
  settings_.height = height;
  if (camera_.revision() != edits.camera.revision()) {
    camera_.restore(edits.camera);
    chosen_camera_ = edits.chosen_camera;
  }
  if (lights_revision_ != edits.lights_revision) {
    lights_ = edits.lights;
    ++lights_revision_;
  }
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
    return;
  }
  scene_ = std::move(*outcome.scene);
  load_seconds_ = outcome.load_seconds;
  ++scenes_opened_;
  reset_lights();
  lights_asked_for_ = lights_revision_;  // it has them
  if (!std::exchange(keep_view_, false)) choose_camera(scene_->world.cameras.empty() ? -1 : 0);
  if (const Result<void> able = check_method(*scene_, settings_); !able) {
    error_ = able.error();
    error_->reason += "; ASOS takes its place";
    settings_.method = Method::asos;
  }
}

void Previewer::choose_camera(int index) {
  if (!scene_) return;
  const World& world = scene_->world;
  const bool from_file = index >= 0 && index < static_cast<int>(world.cameras.size());
  chosen_camera_ = from_file ? index : -1;
  const Camera camera = from_file ? world.cameras[static_cast<std::size_t>(index)]
                                  : default_camera(world, aspect_ratio());

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
  return rendered_.scene && session_.progress().running &&
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
  rendered_ = {scene_, camera_.revision(), settings_};
  ++restarts_;
  restarted_seconds_ = now_seconds;
  pixels_taken_ = 0;
  if (film_.width != settings_.width || film_.height != settings_.height) {
    film_ = stretched(film_, settings_.width, settings_.height);
    changed_ = {{0, 0, film_.width, film_.height}};
  }
}

void Previewer::take_tiles() {
  for (const FinishedTile& tile : session_.take_finished()) {
    film_.put(tile);
    changed_.push_back(tile.rect);
    pixels_taken_ += static_cast<std::int64_t>(tile.rect.width) * tile.rect.height;
  }
}

double Previewer::aspect_ratio() const {
  return static_cast<double>(settings_.width) / static_cast<double>(settings_.height);
}

}  // namespace asos
