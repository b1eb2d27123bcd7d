#include "renderer/lights/form_factor.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

/// A line relative to a receiver: the point foot + s along. `along` is unit, and `foot` is the
/// line's nearest point, at the distance `height`. With the angle psi from the foot, s = height
/// tan(psi).
struct Line {
  glm::dvec3 foot, along;
  double height;
};

/// Returns x - sin(x), without a difference of nearly equal numbers for a small x.
double less_sine(double x) {
  if (std::abs(x) > 0.5) return x - std::sin(x);
  const double x2 = x * x;
  return x * x2 / 6.0 *
         (1.0 -
          x2 / 20.0 *
              (1.0 - x2 / 42.0 * (1.0 - x2 / 72.0 * (1.0 - x2 / 110.0 * (1.0 - x2 / 156.0)))));
}

/// Cuts s0..s1 to where foot_height + s slope > 0. Returns false if nothing is left.
bool cut(double foot_height, double slope, double& s0, double& s1) {
  const double begin = foot_height + s0 * slope;
  const double end = foot_height + s1 * slope;
  if (!(begin > 0.0) && !(end > 0.0)) return false;
  if (begin > 0.0 && end > 0.0) return true;
  const double crossing = std::clamp(-foot_height / slope, s0, s1);
  (begin > 0.0 ? s1 : s0) = crossing;
  return s0 < s1;
}

/// Returns the integral of height (foot_cos height + along_cos s) / d^4 ds with d^2 = height^2 +
/// s^2. It is (foot_cos (D + sin D cos S) + along_cos sin D sin S) / (2 height), where D is the
/// difference of the ends' psi and S is their sum.
double lambertian_form(double height, double foot_cos, double along_cos, double s0, double s1) {
  const double d0 = std::hypot(height, s0);
  const double d1 = std::hypot(height, s1);
  const double product = d0 * d1;
  if (!(height > 0.0) || !(product > 0.0)) return 0.0;
  const double sine = height / d0 * ((s1 - s0) / d1);
  const double cosine_sum = (height * height - s0 * s1) / product;
  const double sine_sum = height / d0 * ((s0 + s1) / d1);
  const double angle = std::atan2(height * (s1 - s0), height * height + s0 * s1);
  // For a view along the line S is near pi, so 1 + cos S is computed from the ends themselves.
  const double one_more =
      s0 * s1 > 0.0 ? height * height / product *
                          (1.0 + (height * height + s0 * s0 + s1 * s1) / (product + s0 * s1))
                    : 1.0 + cosine_sum;
  return (foot_cos * (less_sine(angle) + sine * one_more) + along_cos * sine * sine_sum) /
         (2.0 * height);
}

/// Returns the integral of (foot_cos height + along_cos s) / d^3 ds.
double even_form(double height, double foot_cos, double along_cos, double s0, double s1) {
  const double d0 = std::hypot(height, s0);
  const double d1 = std::hypot(height, s1);
  if (!(d0 * d1 > 0.0)) return 0.0;
  const double squares = (s1 - s0) / d0 * ((s1 + s0) / d1);  // s1^2 - s0^2 over both distances
  double across = 0.0;
  if (s0 * s1 > 0.0) {
    across = height * squares / (s1 * d0 + s0 * d1);
  } else if (height > 0.0) {
    across = (s1 / d1 - s0 / d0) / height;
  } else {
    return 0.0;
  }
  return foot_cos * across + along_cos * squares / (d0 + d1);
}

}  // namespace

double line_form(glm::dvec3 begin, glm::dvec3 end, bool lambertian, const Receiver& receiver) {
  const double length = glm::length(end - begin);
  if (!(length > 0.0)) return 0.0;
  const glm::dvec3 along = (end - begin) / length;
  // Start at the nearer end, since the other may be so far that the foot would lose digits.
  const glm::dvec3 from_begin = begin - receiver.position;
  const glm::dvec3 from_end = end - receiver.position;
  const bool begin_nearer = glm::dot(from_begin, from_begin) < glm::dot(from_end, from_end);
  const glm::dvec3 nearer = begin_nearer ? from_begin : from_end;
  const double s_nearer = glm::dot(nearer, along);
  const glm::dvec3 foot = nearer - s_nearer * along;
  const double height = glm::length(foot);

  double s0 = begin_nearer ? s_nearer : s_nearer - length;
  double s1 = begin_nearer ? s_nearer + length : s_nearer;
  const double normal_along = glm::dot(receiver.normal, along);
  const double normal_foot = glm::dot(receiver.normal, foot);
  if (!cut(normal_foot, normal_along, s0, s1) ||
      !cut(glm::dot(receiver.geometric, foot), glm::dot(receiver.geometric, along), s0, s1)) {
    return 0.0;
  }
  const double foot_cos = height > 0.0 ? normal_foot / height : 0.0;
  const double form = lambertian ? lambertian_form(height, foot_cos, normal_along, s0, s1)
                                 : even_form(height, foot_cos, normal_along, s0, s1);
  return std::max(0.0, form);
}

}  // namespace asos
