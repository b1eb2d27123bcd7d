#include "renderer/stability/case.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

// Scale and place: a scene's picture depends neither on its units nor on its origin.

namespace asos::stability {
namespace {

constexpr const char* scale_group = "scale and place";

const char* const scaled_rounding_reason =
    "16 roundings of float32 (vertex, eye, ray and its test) move each of the edges in a pixel; "
    "the length of an edge there is at most the diagonal";

/// Compares the tilted card under a similarity with its closed form at unit scale.
Result<Outcome> placed_card(const glm::dmat4& similarity, double scale, double more,
                            const std::string& why) {
  const Face card = tilted_card();
  const PictureView view{card_camera(), picture_side, picture_side};
  const Scene scene = transformed(scene_of({card}, view.camera), similarity, scale);
  const double bound = rounding_bound(view, {1.5, 4.0 - 1.5, 2, 0.65}) + more;
  return worst_pixel({"radiance of the worst of 16x16 pixels", bound, scaled_rounding_reason + why},
                     render(scene, settings_of(picture_side, picture_side)),
                     [&](int x, int y) { return faces_radiance(view, {card}, x, y); });
}

/// Compares the lit still life under a similarity with the original.
Result<Outcome> placed_still_life(const glm::dmat4& similarity, double scale,
                                  const Measure& measure) {
  const RenderSettings settings = settings_of(24, picture_side, 5);
  return worst_difference(measure, render(still_life(), settings),
                          render(transformed(still_life(), similarity, scale), settings));
}

glm::dmat4 scaled(double scale) {
  return glm::scale(glm::dmat4(1.0), glm::dvec3(scale));
}

glm::dmat4 moved(double distance) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(distance, -distance, 0.5 * distance));
}

void add_scales(std::vector<Case>& cases) {
  for (const int power : {-12, -9, -6, -3, 3, 6, 9, 12}) {
    cases.push_back({fmt::format("a card scaled by 1e{}", power), scale_group, true, [power] {
                       const double scale = std::pow(10.0, power);
                       return placed_card(scaled(scale), scale, 0.0, "");
                     }});
  }
  const Measure bits{"radiance of the pixel that differs most", 0.0,
                     "a power of two changes no float's digits, so that no bit may differ"};
  for (const int power : {-40, -20, 20, 40}) {
    cases.push_back(
        {fmt::format("a lit room scaled by 2^{}", power), scale_group, true, [power, bits] {
           const double scale = std::ldexp(1.0, power);
           return placed_still_life(scaled(scale), scale, bits);
         }});
  }
  const Measure passed{"radiance of the pixel that differs most", 2.0 / 2048.0,
                       "at MAX 5 and EPS 0 either picture may be off by 1/2048, what an 8-bit "
                       "display cannot show; rounding of the input is far below that"};
  for (const int power : {-12, 12}) {
    cases.push_back(
        {fmt::format("a lit room scaled by 1e{}", power), scale_group, true, [power, passed] {
           const double scale = std::pow(10.0, power);
           return placed_still_life(scaled(scale), scale, passed);
         }});
  }
}

void add_moves(std::vector<Case>& cases) {
  for (const int power : {3, 6, 9}) {
    cases.push_back({fmt::format("a card moved by 1e{}", power), scale_group, true, [power] {
                       const double distance = std::pow(10.0, power);
                       // The scene's coordinates are doubles; the bound allows three roundings of
                       // them.
                       const PictureView view{card_camera(), picture_side, picture_side};
                       const double more = 2.0 * std::sqrt(2.0) * 3.0 * distance * 1.2e-16 *
                                           view.pixels_per_unit() / 2.5;
                       return placed_card(moved(distance), 1.0, more,
                                          "; and three roundings of doubles of the move's size");
                     }});
  }
  const Measure bits{"radiance of the pixel that differs most", 0.0,
                     "the scene is recentred in double, where this move loses no digit, so that no "
                     "bit may differ"};
  for (const int power : {10, 20, 30}) {
    cases.push_back(
        {fmt::format("a lit room moved by 2^{}", power), scale_group, true,
         [power, bits] { return placed_still_life(moved(std::ldexp(1.0, power)), 1.0, bits); }});
  }
  cases.push_back(
      {"a card whose vertices themselves lie 1000 away", scale_group, true, [] {
         Face card = tilted_card();
         Camera camera = card_camera();
         for (glm::dvec3& corner : card.corners) corner.x += 1000.0;
         camera.world_from_camera[3].x += 1000.0;
         const PictureView view{camera, picture_side, picture_side};
         const double bound = rounding_bound(view, {1000.0, 2.5, 2, 0.65});
         return worst_pixel(
             {"radiance of the worst of 16x16 pixels", bound,
              std::string(scaled_rounding_reason) + "; the file's floats are 1000 large"},
             render(scene_of({card}, camera), settings_of(picture_side, picture_side)),
             [&](int x, int y) { return faces_radiance(view, {card}, x, y); });
       }});
}

/// A card before a far larger ground, which it hides partly.
Result<Outcome> card_on_ground(const Face& ground) {
  const Face card = tilted_card();
  const PictureView view{card_camera(), picture_side, picture_side};
  // The ground contributes where the card does not hide it.
  const auto expected = [&](int x, int y) {
    const double hidden = coverage(view, card.corners, x, y);
    return hidden * static_cast<double>(card.colour) +
           (1.0 - hidden) * static_cast<double>(ground.colour);
  };
  return worst_pixel(
      {"radiance of the worst of 16x16 pixels", rounding_bound(view, {1.5, 2.5, 2, 1.0}),
       std::string(scaled_rounding_reason) +
           ", of the card's size: a part's own coordinates must not lose digits to "
           "another part"},
      render(scene_of({card, ground}, view.camera), settings_of(picture_side, picture_side)),
      expected);
}

void add_sizes(std::vector<Case>& cases) {
  cases.push_back(
      {"a card in the middle of a ground 1e9 times its size", scale_group, true, [] {
         const double far = 1e9;
         return card_on_ground(
             {{{-far, -far, -1}, {far, -far, -1}, {far, far, -1}, {-far, far, -1}}, 0.0f});
       }});
  cases.push_back({"a card at the corner of a ground 1e9 times its size", scale_group, true, [] {
                     const double far = 2e9;
                     return card_on_ground(
                         {{{-8, -8, -1}, {far, -8, -1}, {far, far, -1}, {-8, far, -1}}, 0.0f});
                   }});
}

/// Renders a card with another camera.
Result<Outcome> card_from(const Face& card, const Camera& camera, const RoundingCase& rounded) {
  const PictureView view{camera, picture_side, picture_side};
  return worst_pixel({"radiance of the worst of 16x16 pixels", rounding_bound(view, rounded),
                      scaled_rounding_reason},
                     render(scene_of({card}, camera), settings_of(picture_side, picture_side)),
                     [&](int x, int y) { return faces_radiance(view, {card}, x, y); });
}

void add_distances(std::vector<Case>& cases) {
  cases.push_back(
      {"the camera 1e-4 from a surface 0.02 wide", scale_group, true, [] {
         Face card = tilted_card();
         for (glm::dvec3& p : card.corners) p = p * 0.01 + glm::dvec3(0.0093359375, 0.0, 0.0);
         return card_from(card, look_at({0, 0, 1e-4}, {0, 0, 0}, 50.0), {0.02, 1e-4, 2, 0.65});
       }});
  // Three units of the scene fill the picture's height.
  const double fov = glm::degrees(3.0 / 1e7);
  cases.push_back(
      {"the camera 1e7 away, on an axis", scale_group, true, [fov] {
         return card_from(tilted_card(), look_at({0, 0, 1e7}, {0, 0, 0}, fov), {1.5, 1e7, 2, 0.65});
       }});
  cases.push_back(
      {"the camera 1e7 away, on no axis", scale_group, true, [fov] {
         const glm::dvec3 eye = 1e7 * glm::normalize(glm::dvec3(0.3, 0.5, 0.81));
         return card_from(tilted_card(), look_at(eye, {0, 0, 0}, fov), {1.5, 1e7, 2, 0.65});
       }});
}

}  // namespace

std::vector<Case> scale_cases() {
  std::vector<Case> cases;
  add_scales(cases);
  add_moves(cases);
  add_sizes(cases);
  add_distances(cases);
  return cases;
}

}  // namespace asos::stability
