#include "renderer/pyray/node_test.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

// Tests eight children at a time, in the vector types that GCC and Clang offer on all machines.
// Each clone of the function below is compiled for one instruction set and selected at program
// start. Sanitizers run before the selection, so there is only one version with them.
#if defined(ASOS_SANITIZED)
#define ASOS_CLONES
#else
#define ASOS_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#endif
#define ASOS_INLINE __attribute__((always_inline)) inline

// Vectors are passed to always-inlined functions only, so no calling convention matters.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace asos {
namespace {

constexpr int width = FeatureNode::width;
// Rounding occurs at the subtraction of the apex, and at each product and sum after that: five
// roundings of at most 2^-24 of the magnitudes, doubled.
constexpr float rounding = 6e-7f;
constexpr float infinity = std::numeric_limits<float>::infinity();

using Floats = float __attribute__((vector_size(sizeof(float) * width)));
using Masks = std::int32_t __attribute__((vector_size(sizeof(float) * width)));

ASOS_INLINE Floats load(const float (&from)[width]) {
  Floats values;
  std::memcpy(&values, from, sizeof values);
  return values;
}

ASOS_INLINE void store(const Floats& values, float (&to)[width]) {
  std::memcpy(to, &values, sizeof values);
}

ASOS_INLINE Floats all(float value) {
  return value - Floats{};
}

ASOS_INLINE Floats magnitude(const Floats& x) {
  return x < 0.0f ? -x : x;
}

ASOS_INLINE Floats square_root(const Floats& x) {
  Floats root;
  for (int i = 0; i < width; ++i) root[i] = std::sqrt(x[i]);
  return root;
}

// row . (x, y, z)
ASOS_INLINE Floats along(const float (&row)[3], const Floats (&x)[3]) {
  return row[0] * x[0] + row[1] * x[1] + row[2] * x[2];
}

}  // namespace

NodeTestFrame::NodeTestFrame(const Frame& frame) : parallel(frame.parallel()) {
  const glm::dvec3 rows[3] = {frame.row_u(), frame.row_v(), frame.row_w()};
  for (int k = 0; k < 3; ++k) {
    apex[k] = static_cast<float>(frame.apex()[k]);
    direction[k] = static_cast<float>(frame.direction()[k]);
    for (int r = 0; r < 3; ++r) {
      row[r][k] = static_cast<float>(rows[r][k]);
      row_abs[r][k] = std::abs(row[r][k]);
    }
    for (int r = 0; r < 2; ++r) {
      opposite[r][k] = static_cast<float>(rows[2][k] - rows[r][k]);
      opposite_abs[r][k] = std::abs(opposite[r][k]);
    }
  }
}

ASOS_CLONES
NodeTestResult test_children(const FeatureNode& node, const NodeTestFrame& frame) {
  // Boxes: centres relative to the apex, and half extents, padded by the rounding.
  Floats c[3], h[3];
  for (int k = 0; k < 3; ++k) {
    const Floats lo = load(node.lo[k]), hi = load(node.hi[k]);
    const Floats centre = 0.5f * (lo + hi);
    c[k] = centre - frame.apex[k];
    h[k] = 0.5f * (hi - lo) + rounding * (magnitude(centre) + std::abs(frame.apex[k]));
  }
  // U, V, W of the centres, and the extent of the boxes around them.
  Floats at[3], reach[3];
  for (int r = 0; r < 3; ++r) {
    at[r] = along(frame.row[r], c);
    reach[r] = along(frame.row_abs[r], h);
  }
  // Find the boxes that meet the pyray, with their rectangles and greatest nearness.
  Masks inside =
      (at[0] + reach[0] >= 0.0f) & (at[1] + reach[1] >= 0.0f) & (at[2] + reach[2] >= 0.0f);
  Floats u0 = at[0] - reach[0], u1 = at[0] + reach[0];
  Floats v0 = at[1] - reach[1], v1 = at[1] + reach[1];
  Floats nearness;
  if (frame.parallel) {
    nearness = reach[2] - at[2];
    inside &= (u0 <= 1.0f) & (v0 <= 1.0f);
  } else {
    for (int r = 0; r < 2; ++r)
      inside &= along(frame.opposite[r], c) + along(frame.opposite_abs[r], h) >= 0.0f;
    const Floats nearest = at[2] - reach[2];
    const Masks ahead = nearest > 0.0f;
    const Floats q_near = 1.0f / nearest;
    const Floats q_far = 1.0f / (at[2] + reach[2]);
    u0 = ahead ? u0 * (u0 < 0.0f ? q_near : q_far) : all(-infinity);
    u1 = ahead ? u1 * (u1 < 0.0f ? q_far : q_near) : all(infinity);
    v0 = ahead ? v0 * (v0 < 0.0f ? q_near : q_far) : all(-infinity);
    v1 = ahead ? v1 * (v1 < 0.0f ? q_far : q_near) : all(infinity);
    nearness = ahead ? q_near : all(infinity);
  }
  // A child contains no silhouette if |axis . view| > sin(cone + ball), where the ball is the
  // sphere around its box, seen from the apex, and the two angles add up to less than 90 degrees.
  // All terms are multiplied by the distance.
  Floats view[3], r2 = {};
  for (int k = 0; k < 3; ++k) {
    view[k] = frame.parallel ? all(frame.direction[k]) : c[k];
    if (!frame.parallel) r2 += h[k] * h[k];
  }
  const Floats d2 = view[0] * view[0] + view[1] * view[1] + view[2] * view[2];
  const Floats outside = d2 > r2 ? d2 - r2 : Floats{};
  const Floats ball_cosine = square_root(outside), ball_sine = square_root(r2);
  const Floats facing = magnitude(load(node.axis[0]) * view[0] + load(node.axis[1]) * view[1] +
                                  load(node.axis[2]) * view[2]);
  const Floats cone_sine = load(node.cone_sine), cone_cosine = load(node.cone_cosine);
  const Floats limit = cone_sine * ball_cosine + cone_cosine * ball_sine + 1e-5f * square_root(d2);
  const Masks no_silhouette =
      (cone_cosine * ball_cosine > cone_sine * ball_sine) & (facing > limit);

  // Store the children that are kept.
  static_assert(width == 8);
  NodeTestResult out;
  store(u0, out.u0), store(u1, out.u1);
  store(v0, out.v0), store(v1, out.v1);
  store(nearness, out.nearness);
  const Masks bits = {1, 2, 4, 8, 16, 32, 64, 128};
  Masks always;
  for (int i = 0; i < width; ++i) always[i] = node.always[i];
  const Masks kept = inside & ((no_silhouette == 0) | (always != 0)) & bits;
  for (int i = 0; i < width; ++i) out.kept |= static_cast<unsigned>(kept[i]);
  out.kept &= (1u << node.child_count) - 1u;
  return out;
}

}  // namespace asos
