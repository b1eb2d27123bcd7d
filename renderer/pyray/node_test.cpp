#include "renderer/pyray/node_test.h"

#include <cmath>
#include <limits>

// Loops over the eight children are left to the vectoriser; each clone of the functions below is
// compiled for one instruction set and chosen when the program starts. Sanitizers run before the
// choice can be made, so there they are plain.
#if defined(ASOS_SANITIZED)
#define ASOS_CLONES
#else
#define ASOS_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#endif

namespace asos {
namespace {

constexpr int width = FeatureNode::width;
// Each coordinate is rounded when the apex is subtracted, and each product and sum after that: five
// roundings of at most 2^-24 of the magnitudes met, doubled.
constexpr float rounding = 6e-7f;
constexpr float infinity = std::numeric_limits<float>::infinity();

// Centres (relative to the apex) and half extents, the latter padded by the rounding.
struct Boxes {
  float c[3][width];
  float h[3][width];
};

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
  // Boxes relative to the apex.
  Boxes box;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < width; ++i) {
      const float centre = 0.5f * (node.lo[k][i] + node.hi[k][i]);
      box.c[k][i] = centre - frame.apex[k];
      box.h[k][i] = 0.5f * (node.hi[k][i] - node.lo[k][i]) +
                    rounding * (std::abs(centre) + std::abs(frame.apex[k]));
    }
  }
  // U, V, W of the centres, and how far the boxes reach around them.
  float at[3][width];
  float reach[3][width];
  for (int r = 0; r < 3; ++r) {
    for (int i = 0; i < width; ++i) {
      at[r][i] = frame.row[r][0] * box.c[0][i] + frame.row[r][1] * box.c[1][i] +
                 frame.row[r][2] * box.c[2][i];
      reach[r][i] = frame.row_abs[r][0] * box.h[0][i] + frame.row_abs[r][1] * box.h[1][i] +
                    frame.row_abs[r][2] * box.h[2][i];
    }
  }
  int inside[width];
  NodeTestResult out;
  for (int i = 0; i < width; ++i)
    inside[i] = (at[0][i] + reach[0][i] >= 0.0f) & (at[1][i] + reach[1][i] >= 0.0f) &
                (at[2][i] + reach[2][i] >= 0.0f);
  if (frame.parallel) {
    for (int i = 0; i < width; ++i) {
      out.u0[i] = at[0][i] - reach[0][i];
      out.u1[i] = at[0][i] + reach[0][i];
      out.v0[i] = at[1][i] - reach[1][i];
      out.v1[i] = at[1][i] + reach[1][i];
      out.q[i] = reach[2][i] - at[2][i];
      inside[i] &= (out.u0[i] <= 1.0f) & (out.v0[i] <= 1.0f);
    }
  } else {
    for (int r = 0; r < 2; ++r) {
      for (int i = 0; i < width; ++i) {
        const float f = frame.opposite[r][0] * box.c[0][i] + frame.opposite[r][1] * box.c[1][i] +
                        frame.opposite[r][2] * box.c[2][i];
        const float g = frame.opposite_abs[r][0] * box.h[0][i] +
                        frame.opposite_abs[r][1] * box.h[1][i] +
                        frame.opposite_abs[r][2] * box.h[2][i];
        inside[i] &= f + g >= 0.0f;
      }
    }
    for (int i = 0; i < width; ++i) {
      const float nearest = at[2][i] - reach[2][i];
      const float farthest = at[2][i] + reach[2][i];
      const bool ahead = nearest > 0.0f;
      const float q_near = 1.0f / nearest;
      const float q_far = 1.0f / farthest;
      const float ulo = at[0][i] - reach[0][i];
      const float uhi = at[0][i] + reach[0][i];
      const float vlo = at[1][i] - reach[1][i];
      const float vhi = at[1][i] + reach[1][i];
      out.u0[i] = ahead ? ulo * (ulo < 0.0f ? q_near : q_far) : -infinity;
      out.u1[i] = ahead ? uhi * (uhi < 0.0f ? q_far : q_near) : infinity;
      out.v0[i] = ahead ? vlo * (vlo < 0.0f ? q_near : q_far) : -infinity;
      out.v1[i] = ahead ? vhi * (vhi < 0.0f ? q_far : q_near) : infinity;
      out.q[i] = ahead ? q_near : infinity;
    }
  }
  // No silhouette below: |axis . view| > sin(cone + ball), where the ball is the box's, seen from
  // the apex, and both angles together stay below a right one.
  for (int i = 0; i < width; ++i) {
    const float x = frame.parallel ? frame.direction[0] : box.c[0][i];
    const float y = frame.parallel ? frame.direction[1] : box.c[1][i];
    const float z = frame.parallel ? frame.direction[2] : box.c[2][i];
    const float d2 = x * x + y * y + z * z;
    const float r2 = frame.parallel ? 0.0f
                                    : box.h[0][i] * box.h[0][i] + box.h[1][i] * box.h[1][i] +
                                          box.h[2][i] * box.h[2][i];
    const float outside = d2 > r2 ? d2 - r2 : 0.0f;
    const float ball_cosine = std::sqrt(outside);  // times the distance
    const float ball_sine = std::sqrt(r2);         // times the distance
    const float facing = std::abs(node.axis[0][i] * x + node.axis[1][i] * y + node.axis[2][i] * z);
    const float limit =
        node.cone_sine[i] * ball_cosine + node.cone_cosine[i] * ball_sine + 1e-5f * std::sqrt(d2);
    const bool narrow = node.cone_cosine[i] * ball_cosine > node.cone_sine[i] * ball_sine;
    const bool no_silhouette = narrow & (facing > limit);
    inside[i] &= !(no_silhouette & (node.always[i] == 0));
  }
  for (unsigned i = 0; i < node.child_count; ++i)
    out.kept |= static_cast<unsigned>(inside[i] & 1) << i;
  return out;
}

}  // namespace asos
