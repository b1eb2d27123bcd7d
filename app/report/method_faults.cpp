#include "app/report/method_faults.h"

#include "renderer/comparison/method.h"
#include "renderer/gltf/load.h"
#include "renderer/session/render_session.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace asos {
namespace {

constexpr int cards_width = 160, cards_height = 90;
constexpr int true_samples = 256, compared_samples = 16;

// The cards lie in the four quarters of the picture.
constexpr std::array<PixelRect, 4> parts{PixelRect{0, 0, 80, 45}, PixelRect{80, 0, 80, 45},
                                         PixelRect{0, 45, 80, 45}, PixelRect{80, 45, 80, 45}};
constexpr std::size_t wires = 2;

Film picture_of(const Snapshot& snapshot, Method method, int samples) {
  Snapshot asked = snapshot;
  asked.settings.method = method;
  asked.settings.sampling.spp = samples;
  return render_to_end(std::move(asked)).film;
}

double difference(const Film& film, const Film& truth, const PixelRect& part) {
  double sum = 0.0;
  for (int y = part.y; y < part.y + part.height; ++y) {
    for (int x = part.x; x < part.x + part.width; ++x) {
      const std::size_t at = film.index(x, y);
      const glm::dvec3 d = glm::dvec3(film.radiance[at]) - glm::dvec3(truth.radiance[at]);
      sum += glm::dot(d, d) / 3.0;
    }
  }
  return std::sqrt(sum / (static_cast<double>(part.width) * part.height));
}

// Pictures of the wires alone. The camera moves sideways by a pixel in all: the wires lie in one
// plane, so all of them move by the same.
std::vector<Film> moved_wires(const Snapshot& snapshot, Method method, int samples) {
  constexpr int steps = 8;
  constexpr double eye_distance = 6.0;
  const double pixel = 2.0 * eye_distance * std::tan(0.5 * snapshot.camera.fov_y_rad) /
                       static_cast<double>(cards_height);
  Snapshot moved = snapshot;
  moved.settings.crop = parts[wires];
  std::vector<Film> films;
  for (int step = 0; step < steps; ++step) {
    moved.camera.world_from_camera =
        glm::translate(snapshot.camera.world_from_camera, glm::dvec3(pixel * step / steps, 0, 0));
    films.push_back(picture_of(moved, method, samples));
  }
  return films;
}

double difference(const std::vector<Film>& films, const std::vector<Film>& truths) {
  double squares = 0.0;
  for (std::size_t i = 0; i < films.size(); ++i) {
    const double d = difference(films[i], truths[i], {0, 0, films[i].width, films[i].height});
    squares += d * d;
  }
  return std::sqrt(squares / static_cast<double>(films.size()));
}

}  // namespace

Result<std::vector<MethodFaults>> method_faults() {
  auto scene = load_scene("builtin:cards");
  if (!scene) return unexpected(scene.error());
  auto ready = prepare(*std::move(scene));
  if (!ready) return unexpected(ready.error());
  Snapshot snapshot;
  snapshot.scene = *std::move(ready);
  (void)snapshot.scene->features();
  snapshot.camera = snapshot.scene->world().cameras.front();
  snapshot.settings.width = cards_width;
  snapshot.settings.height = cards_height;
  const Film truth = picture_of(snapshot, Method::sobol, true_samples);
  const std::vector<Film> true_wires = moved_wires(snapshot, Method::beam, 1);
  std::vector<MethodFaults> all;
  for (const Method method :
       {Method::asos, Method::sobol, Method::cone, Method::covers, Method::mask}) {
    MethodFaults& of = all.emplace_back();
    of.method = row_of(method).name;
    const Film film = picture_of(snapshot, method, compared_samples);
    for (std::size_t i = 0; i < parts.size(); ++i) of.errors[i] = difference(film, truth, parts[i]);
    of.errors.back() = difference(moved_wires(snapshot, method, compared_samples), true_wires);
  }
  return all;
}

}  // namespace asos
