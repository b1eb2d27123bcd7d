#include "renderer/lights/clipped_form.h"

#include "renderer/lights/form_factor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

using std::numbers::pi;

constexpr glm::dvec3 up(0.0, 0.0, 1.0);

/// Lambert's contour sum of a closed outline that is clipped to one horizon after the other, corner
/// by corner (Sutherland and Hodgman 1974). What a concave outline leaves is joined along the
/// horizon there and back, which adds up to nothing.
class ClippedContour {
 public:
  explicit ClippedContour(std::span<const glm::dvec3> normals) : normals_(normals) {}

  void push(glm::dvec3 corner) { push<0>(corner); }
  double close() {
    close_stage<0>();
    if (started_) sum_ += contour_side(last_, first_, up);
    return sum_;
  }

 private:
  struct Stage {
    glm::dvec3 first{0.0};
    glm::dvec3 last{0.0};
    double first_height = 0.0;
    double last_height = 0.0;
    bool started = false;
  };

  template <std::size_t I>
  void push(glm::dvec3 corner) {
    if constexpr (I < Horizons::most) {
      if (I < normals_.size()) {
        Stage& stage = stages_[I];
        const double height = glm::dot(normals_[I], corner);
        if (stage.started) {
          cross<I>(corner, height);
        } else {
          stage = {corner, corner, height, height, true};
        }
        if (height > 0.0) push<I + 1>(corner);
        stage.last = corner;
        stage.last_height = height;
        return;
      }
    }
    add(corner);
  }

  template <std::size_t I>
  void cross(glm::dvec3 corner, double height) {
    const Stage& stage = stages_[I];
    if ((height > 0.0) == (stage.last_height > 0.0)) return;
    const double t = stage.last_height / (stage.last_height - height);
    push<I + 1>(stage.last + (corner - stage.last) * t);
  }

  template <std::size_t I>
  void close_stage() {
    if (stages_[I].started) cross<I>(stages_[I].first, stages_[I].first_height);
    if constexpr (I + 1 < Horizons::most) close_stage<I + 1>();
  }

  void add(glm::dvec3 corner) {
    if (started_) {
      sum_ += contour_side(last_, corner, up);
    } else {
      first_ = corner;
      started_ = true;
    }
    last_ = corner;
  }

  std::span<const glm::dvec3> normals_;
  std::array<Stage, Horizons::most> stages_;
  glm::dvec3 first_{0.0};
  glm::dvec3 last_{0.0};
  bool started_ = false;
  double sum_ = 0.0;
};

/// A cone of directions about its own axis: those within (x, y) = (l1 cos, l2 sin) at z = 1, with
/// l1 >= l2. `axes` are the unit vectors along x, y and z.
struct EllipticCone {
  std::array<glm::dvec3, 3> axes;
  double l1 = 0.0;
  double l2 = 0.0;

  [[nodiscard]] glm::dvec3 local(glm::dvec3 v) const {
    return {glm::dot(axes[0], v), glm::dot(axes[1], v), glm::dot(axes[2], v)};
  }
  [[nodiscard]] glm::dvec3 at(double angle) const {
    return {l1 * std::cos(angle), l2 * std::sin(angle), 1.0};
  }
};

/// The eigenvectors of a symmetric matrix, by turning one off-diagonal element after the other to 0
/// (Jacobi 1846); its eigenvalues are left on the diagonal.
glm::dmat3 diagonalise(glm::dmat3& m) {
  glm::dmat3 vectors(1.0);
  for (int sweep = 0; sweep < 12; ++sweep) {
    const double off = m[0][1] * m[0][1] + m[0][2] * m[0][2] + m[1][2] * m[1][2];
    const double on = m[0][0] * m[0][0] + m[1][1] * m[1][1] + m[2][2] * m[2][2];
    if (!(off > 1e-40 * on)) break;
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        if (m[p][q] == 0.0) continue;
        const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
        const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
        const double c = 1.0 / std::sqrt(t * t + 1.0);
        const double s = t * c;
        const int r = 3 - p - q;
        m[p][p] -= t * m[p][q];
        m[q][q] += t * m[p][q];
        m[p][q] = m[q][p] = 0.0;
        const double rp = m[r][p];
        const double rq = m[r][q];
        m[r][p] = m[p][r] = c * rp - s * rq;
        m[r][q] = m[q][r] = s * rp + c * rq;
        const glm::dvec3 vp = vectors[p];
        const glm::dvec3 vq = vectors[q];
        vectors[p] = c * vp - s * vq;
        vectors[q] = s * vp + c * vq;
      }
    }
  }
  return vectors;
}

/// The cone of an ellipse: with x, y, z the coordinates along a, b and the centre, x^2 + y^2 = z^2
/// on it, a quadratic form whose own axes are the cone's (Heitz and Hill 2017). Nothing of an
/// ellipse that the receiver sees edge-on: l2 is 0.
EllipticCone cone_of(glm::dvec3 centre, glm::dvec3 a, glm::dvec3 b) {
  EllipticCone cone;
  const glm::dvec3 along_a = glm::cross(b, centre);
  const glm::dvec3 along_b = glm::cross(centre, a);
  const glm::dvec3 along_centre = glm::cross(a, b);
  glm::dmat3 form = glm::outerProduct(along_a, along_a) + glm::outerProduct(along_b, along_b) -
                    glm::outerProduct(along_centre, along_centre);
  const double scale = std::max({std::abs(form[0][0]), std::abs(form[1][1]), std::abs(form[2][2])});
  if (!(scale > 0.0) || !std::isfinite(scale)) return cone;
  form /= scale;
  const glm::dmat3 vectors = diagonalise(form);
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int i, int k) { return form[i][i] < form[k][k]; });
  const auto value = [&](int i) {
    return form[order[static_cast<std::size_t>(i)]][order[static_cast<std::size_t>(i)]];
  };
  if (!(value(0) < 0.0) || !(value(1) > 0.0)) return cone;
  cone.axes = {vectors[order[1]], vectors[order[2]], vectors[order[0]]};
  // The half of the double cone in which the ellipse lies.
  const double side = glm::dot(along_centre, cone.axes[2]) * glm::dot(along_centre, centre);
  if (side < 0.0) cone.axes[2] = -cone.axes[2];
  if (glm::dot(glm::cross(cone.axes[0], cone.axes[1]), cone.axes[2]) < 0.0)
    cone.axes[1] = -cone.axes[1];
  cone.l1 = std::sqrt(-value(0) / value(1));
  cone.l2 = std::sqrt(-value(0) / value(2));
  return cone;
}

/// Half the integral of normal . (p x dp) / p^2 along the cone's rim from one angle to a larger
/// one. p^2 = (1 + l1^2) cos^2 + (1 + l2^2) sin^2, and the rest is linear in cos and sin.
double rim_side(const EllipticCone& cone, double begin, double end, glm::dvec3 normal) {
  const double p = 1.0 + cone.l1 * cone.l1;
  const double q = 1.0 + cone.l2 * cone.l2;
  const double k = std::sqrt(q / p);
  const double eccentric = std::sqrt((cone.l1 - cone.l2) * (cone.l1 + cone.l2));
  const double c0 = std::cos(begin);
  const double s0 = std::sin(begin);
  const double c1 = std::cos(end);
  const double s1 = std::sin(end);
  const auto lag = [&](double c, double s) {
    return std::atan((k - 1.0) * s * c / (c * c + k * s * s));
  };
  const double of_one = (end - begin + lag(c1, s1) - lag(c0, s0)) / std::sqrt(p * q);
  const auto over = [](double f, double x) { return x == 0.0 ? 1.0 : f / x; };
  const auto by_sine = [&](double s) {
    const double x = eccentric * s / std::sqrt(p);
    return s / p * over(std::atanh(x), x);
  };
  const auto by_cosine = [&](double c) {
    const double x = eccentric * c / std::sqrt(q);
    return -c / q * over(std::atan(x), x);
  };
  const double of_cos = by_sine(s1) - by_sine(s0);
  const double of_sin = by_cosine(c1) - by_cosine(c0);
  return 0.5 * (normal.z * cone.l1 * cone.l2 * of_one - normal.x * cone.l2 * of_cos -
                normal.y * cone.l1 * of_sin);
}

/// Angles of the rim that a horizon leaves: from `begin` on over `length`, 0 to 2 pi.
struct RimPart {
  double begin = 0.0;
  double length = 2.0 * pi;
};

RimPart rim_above(const EllipticCone& cone, glm::dvec3 normal) {
  const double x = normal.x * cone.l1;
  const double y = normal.y * cone.l2;
  const double swing = std::hypot(x, y);
  if (normal.z >= swing) return {};
  if (normal.z <= -swing) return {0.0, 0.0};
  const double half = std::atan2(std::sqrt((swing - normal.z) * (swing + normal.z)), -normal.z);
  return {std::atan2(y, x) - half, 2.0 * half};
}

/// Leaves of a line what lies above a horizon, given the heights of its ends above that.
void clip(LinePart& part, double at_begin, double at_end) {
  if (at_begin > 0.0 && at_end > 0.0) return;
  if (!(at_begin > 0.0) && !(at_end > 0.0)) {
    part = {1.0, 0.0};
    return;
  }
  const double crossing = at_begin / (at_begin - at_end);
  if (at_begin > 0.0) {
    part.second = std::min(part.second, crossing);
  } else {
    part.first = std::max(part.first, crossing);
  }
}

/// What all of the parts leave of the rim, as a contour sum: each arc begins where one of the parts
/// does and ends at the nearest end of any.
double rim_form(const EllipticCone& cone, std::span<const RimPart> parts, glm::dvec3 normal) {
  double sum = 0.0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    double length = parts[i].length;
    bool kept = true;
    for (std::size_t k = 0; k < parts.size() && kept; ++k) {
      if (k == i) continue;
      double after = std::fmod(parts[i].begin - parts[k].begin, 2.0 * pi);
      if (after < 0.0) after += 2.0 * pi;
      kept = after < parts[k].length && (after > 0.0 || i < k);
      length = std::min(length, parts[k].length - after);
    }
    if (kept) sum += rim_side(cone, parts[i].begin, parts[i].begin + length, normal);
  }
  return sum;
}

}  // namespace

void Horizons::add(glm::dvec3 normal) {
  const double length = glm::length(normal);
  if (!(length > 0.0) || count_ == most) return;
  normal /= length;
  for (const glm::dvec3& there : normals()) {
    if (glm::dot(there, normal) > 0.0 && glm::length(glm::cross(there, normal)) < 1e-9) return;
  }
  normals_[count_++] = normal;
}

LinePart part_above(glm::dvec3 begin, glm::dvec3 end, const Horizons& horizons) {
  LinePart part;
  for (const glm::dvec3& normal : horizons.normals()) {
    clip(part, glm::dot(normal, begin), glm::dot(normal, end));
  }
  return part;
}

double whole_form(const Horizons& horizons) {
  double form = 0.0;
  const std::array<glm::dvec3, 4> sides{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0),
                                        glm::dvec3(-1, 0, 0), glm::dvec3(0, -1, 0)};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const std::array<glm::dvec3, 3> octant{up, sides[(i + 1) % 4], sides[i]};
    ClippedContour contour(horizons.normals().subspan(1));
    for (const glm::dvec3& corner : octant) contour.push(corner);
    form += contour.close();
  }
  return std::max(0.0, form);
}

double polygon_form(std::span<const glm::dvec3> corners, const Horizons& horizons) {
  std::array<glm::dvec3, Horizons::most> cutting;
  std::size_t count = 0;
  for (const glm::dvec3& normal : horizons.normals()) {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const glm::dvec3& corner : corners) {
      const double height = glm::dot(normal, corner);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    if (!(highest > 0.0)) return 0.0;
    if (lowest < 0.0) cutting[count++] = normal;
  }
  ClippedContour contour({cutting.data(), count});
  for (const glm::dvec3& corner : corners) contour.push(corner);
  return contour.close();
}

double ellipse_form(glm::dvec3 centre, glm::dvec3 a, glm::dvec3 b, const Horizons& horizons) {
  const double distance = glm::length(centre);
  if (!(distance > 0.0)) return 0.0;
  centre /= distance;
  a /= distance;
  b /= distance;
  const double size = std::max(glm::length(a), glm::length(b));
  // The cone of a smaller one has too few digits, and its middle stands for all of it.
  constexpr double least_size = 1e-4;
  if (size < least_size) {
    for (const glm::dvec3& normal : horizons.normals()) {
      if (!(glm::dot(normal, centre) > 0.0)) return 0.0;
    }
    return pi * std::abs(glm::dot(glm::cross(a, b), centre)) * centre.z;
  }

  // Directions above the horizons are a convex cone, and so are those to the ellipse: the border of
  // what they share is arcs of the rim and, on each horizon, the chord that lies above the others.
  const EllipticCone cone = cone_of(centre, a, b);
  if (!(cone.l2 > 0.0)) return 0.0;
  const glm::dvec3 local_up = cone.local(up);
  std::array<RimPart, Horizons::most> cuts;
  std::array<glm::dvec3, Horizons::most> cutting;
  std::size_t count = 0;
  for (const glm::dvec3& normal : horizons.normals()) {
    const glm::dvec3 local = cone.local(normal);
    const RimPart part = rim_above(cone, local);
    if (part.length == 0.0) return 0.0;
    if (part.length == 2.0 * pi) continue;
    cuts[count] = part;
    cutting[count++] = local;
  }
  if (count == 0) return std::max(0.0, rim_side(cone, 0.0, 2.0 * pi, local_up));
  double form = rim_form(cone, {cuts.data(), count}, local_up);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 from = cone.at(cuts[i].begin + cuts[i].length);
    const glm::dvec3 to = cone.at(cuts[i].begin);
    LinePart part;
    for (std::size_t k = 0; k < count; ++k) {
      if (k != i) clip(part, glm::dot(cutting[k], from), glm::dot(cutting[k], to));
    }
    if (!(part.first < part.second)) continue;
    // Counter-clockwise about the cone's axis is clockwise as seen from the receiver.
    form -=
        contour_side(from + part.first * (to - from), from + part.second * (to - from), local_up);
  }
  return std::max(0.0, form);
}

}  // namespace asos
