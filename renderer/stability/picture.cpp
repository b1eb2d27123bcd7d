#include "renderer/stability/picture.h"

#include "renderer/comparison/method.h"
#include "renderer/session/render_session.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace asos::stability {
namespace {

// Set by tests only.
thread_local std::optional<InjectedError> next_disturbance;

/// Moves the camera so that the picture moves by `pixels`.
Camera moved(Camera camera, glm::dvec2 pixels, int height) {
  glm::dmat4& world = camera.world_from_camera;
  if (camera.type == Camera::Type::orthographic) {
    const double unit = camera.height / height;
    world = glm::translate(world, {-pixels.x * unit, pixels.y * unit, 0.0});
    return camera;
  }
  const double angle = 2.0 * std::tan(0.5 * camera.fov_y_rad) / height;
  world = glm::rotate(world, pixels.x * angle, {0, 1, 0});
  world = glm::rotate(world, pixels.y * angle, {1, 0, 0});
  return camera;
}

Outcome outcome_of(const Measure& measure, const Picture& picture) {
  Outcome outcome;
  outcome.quantity = measure.quantity;
  outcome.bound = measure.bound;
  outcome.reason = measure.reason;
  outcome.rejected_samples = picture.statistics.rejected_samples;
  outcome.bad_pixels = picture.bad_pixels;
  return outcome;
}

}  // namespace

double Picture::at(int x, int y) const {
  return static_cast<double>(film.radiance[film.index(x, y)].x);
}

ErrorInjection::ErrorInjection(const InjectedError& disturbance) {
  next_disturbance = disturbance;
}
ErrorInjection::~ErrorInjection() {
  next_disturbance.reset();
}

RenderSettings settings_of(int width, int height, int max_level) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.asos.max_level = max_level;
  settings.asos.eps = 0.0;
  settings.threads = 1;
  return settings;
}

Result<Picture> render(const Scene& scene, const RenderSettings& settings) {
  if (const auto valid = validated(settings); !valid) return unexpected(valid.error());
  const auto prepared = prepare(scene).and_then(with_boundaries);
  if (!prepared) return unexpected(prepared.error());
  if (const auto fits = check_method(**prepared, settings); !fits) return unexpected(fits.error());
  if ((*prepared)->world().cameras.empty()) return unexpected(Error{scene.name, "has no camera"});
  const InjectedError wrong =
      std::exchange(next_disturbance, std::nullopt).value_or(InjectedError{});
  const Camera camera = moved((*prepared)->world().cameras.front(), wrong.pixels, settings.height);
  RenderResult rendered = render_to_end({*prepared, camera, settings, false});
  // Light is additive: brighter lights scale the picture.
  for (glm::vec3& c : rendered.film.radiance) c *= static_cast<float>(wrong.light);
  Picture picture{std::move(rendered.film), std::move(rendered.statistics), 0};
  for (const glm::vec3& c : picture.film.radiance) {
    if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) ++picture.bad_pixels;
  }
  return picture;
}

Result<Outcome> worst_pixel(const Measure& measure, const Result<Picture>& picture,
                            const std::function<double(int x, int y)>& expected) {
  if (!picture) return unexpected(picture.error());
  Outcome outcome = outcome_of(measure, *picture);
  outcome.error = -1.0;
  for (int y = 0; y < picture->film.height; ++y) {
    for (int x = 0; x < picture->film.width; ++x) {
      const double wanted = expected(x, y);
      const double got = picture->at(x, y);
      const double error = std::abs(got - wanted);
      // Written so that NaN counts as the worst error.
      if (error <= outcome.error || std::isnan(outcome.error)) continue;
      outcome.expected = wanted;
      outcome.got = got;
      outcome.error = error;
    }
  }
  return outcome;
}

Result<Outcome> worst_difference(const Measure& measure, const Result<Picture>& expected,
                                 const Result<Picture>& picture) {
  if (!expected) return unexpected(expected.error());
  if (picture && (picture->film.width != expected->film.width ||
                  picture->film.height != expected->film.height))
    return unexpected(Error{measure.quantity, "the pictures differ in size"});
  Result<Outcome> outcome =
      worst_pixel(measure, picture, [&](int x, int y) { return expected->at(x, y); });
  if (outcome) {
    outcome->bad_pixels += expected->bad_pixels;
    outcome->rejected_samples += expected->statistics.rejected_samples;
  }
  return outcome;
}

Result<Outcome> one_value(const Measure& measure, double expected, const Result<Picture>& picture,
                          const std::function<double(const Picture&)>& value) {
  if (!picture) return unexpected(picture.error());
  Outcome outcome = outcome_of(measure, *picture);
  outcome.expected = expected;
  outcome.got = value(*picture);
  outcome.error = std::abs(outcome.got - expected);
  return outcome;
}

Outcome plain_value(const Measure& measure, double expected, double got) {
  Outcome outcome = outcome_of(measure, {});
  outcome.expected = expected;
  outcome.got = got;
  outcome.error = std::abs(got - expected);
  return outcome;
}

}  // namespace asos::stability
