#include "renderer/features/intersections.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <optional>
#include <tbb/enumerable_thread_specific.h>
#include <utility>

namespace asos {
namespace {

// Distances below this share of the coordinates are rounding.
constexpr double on_plane = 4e-7;
// Lines shorter than this share of the triangles' size are contacts at a corner.
constexpr double shortest_line = 1e-6;

using Triangle = std::array<glm::dvec3, 3>;

// Where a triangle crosses a plane: a stretch of the line that is common to both planes.
struct Stretch {
  glm::dvec3 p, q;
};

// The stretch of `t` on the plane of `other`. A corner on the plane counts as being on its positive
// side, so that two triangles which meet on the plane cross it once together. Which side that is
// must not depend on how `other` is wound: the one of the normal's largest coordinate.
std::optional<Stretch> crossing(const Triangle& t, const Triangle& other) {
  glm::dvec3 n = glm::cross(other[1] - other[0], other[2] - other[0]);
  const double length = glm::length(n);
  if (!(length > 0.0)) return std::nullopt;
  const glm::dvec3 size_of = glm::abs(n);
  const int largest = size_of.x >= size_of.y && size_of.x >= size_of.z ? 0
                      : size_of.y >= size_of.z                         ? 1
                                                                       : 2;
  if (n[largest] < 0.0) n = -n;
  double size = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      size = std::max({size, std::abs(t[i][k] - other[0][k]), std::abs(other[i][k] - other[0][k])});
  }
  double d[3];
  int negative = 0;
  for (int i = 0; i < 3; ++i) {
    d[i] = glm::dot(n, t[i] - other[0]) / length;
    if (std::abs(d[i]) <= on_plane * size) d[i] = 0.0;
    negative += d[i] < 0.0;
  }
  if (negative == 0 || negative == 3) return std::nullopt;
  glm::dvec3 found[2];
  int count = 0;
  for (int i = 0; i < 3 && count < 2; ++i) {
    const int j = (i + 1) % 3;
    if ((d[i] < 0.0) == (d[j] < 0.0)) continue;
    found[count++] = t[i] + (t[j] - t[i]) * (d[i] / (d[i] - d[j]));
  }
  return Stretch{found[0], found[1]};
}

std::optional<Stretch> intersection(const Triangle& s, const Triangle& t) {
  const std::optional<Stretch> x = crossing(s, t);
  if (!x) return std::nullopt;
  const std::optional<Stretch> y = crossing(t, s);
  if (!y) return std::nullopt;
  // Both stretches lie on one line: what they share is the intersection.
  const glm::dvec3 d = x->q - x->p;
  const double square = glm::dot(d, d);
  if (!(square > 0.0)) return std::nullopt;
  double y0 = glm::dot(y->p - x->p, d) / square;
  double y1 = glm::dot(y->q - x->p, d) / square;
  glm::dvec3 p0 = y->p, p1 = y->q;
  if (y0 > y1) {
    std::swap(y0, y1);
    std::swap(p0, p1);
  }
  const Stretch shared{y0 > 0.0 ? p0 : x->p, y1 < 1.0 ? p1 : x->q};
  const double size = std::max(glm::distance(s[0], s[1]) + glm::distance(s[0], s[2]),
                               glm::distance(t[0], t[1]) + glm::distance(t[0], t[2]));
  if ((std::min(y1, 1.0) - std::max(y0, 0.0)) * std::sqrt(square) <= shortest_line * size)
    return std::nullopt;
  return shared;
}

class Collider {
 public:
  Collider(const World& world, std::size_t max_lines) : world_(world), max_lines_(max_lines) {}

  Intersections run() {
    const std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> device(rtcNewDevice(nullptr),
                                                                   rtcReleaseDevice);
    if (!device) return {{}, false};
    const std::unique_ptr<RTCSceneTy, void (*)(RTCScene)> scene(rtcNewScene(device.get()),
                                                                rtcReleaseScene);
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(world_.triangles.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_LOW);
    rtcCommitScene(scene.get());
    rtcCollide(scene.get(), scene.get(), collide, this);
    return gather(rtcGetDeviceError(device.get()) == RTC_ERROR_NONE);
  }

 private:
  static void bounds(const RTCBoundsFunctionArguments* args) {
    const World& world = static_cast<const Collider*>(args->geometryUserPtr)->world_;
    const glm::uvec3 t = world.triangles[args->primID];
    const glm::vec3 a = world.positions[t.x], b = world.positions[t.y], c = world.positions[t.z];
    const glm::vec3 lo = glm::min(a, glm::min(b, c)), hi = glm::max(a, glm::max(b, c));
    *args->bounds_o = {lo.x, lo.y, lo.z, 0.0f, hi.x, hi.y, hi.z, 0.0f};
  }

  static void collide(void* self, RTCCollision* collisions, unsigned count) {
    auto& collider = *static_cast<Collider*>(self);
    std::vector<IntersectionLine>& lines = collider.found_.local();
    for (unsigned i = 0; i < count; ++i) {
      // Each pair comes twice.
      if (collisions[i].primID0 < collisions[i].primID1)
        collider.test(collisions[i].primID0, collisions[i].primID1, lines);
    }
  }

  void test(std::uint32_t s, std::uint32_t t, std::vector<IntersectionLine>& lines) {
    const glm::uvec3 i = world_.triangles[s], j = world_.triangles[t];
    const glm::vec3 a[3] = {world_.positions[i.x], world_.positions[i.y], world_.positions[i.z]};
    const glm::vec3 b[3] = {world_.positions[j.x], world_.positions[j.y], world_.positions[j.z]};
    // Most pairs are neighbours in a mesh.
    for (const glm::vec3& p : a)
      for (const glm::vec3& q : b)
        if (p == q) return;
    const glm::vec3 gap =
        glm::max(glm::min(a[0], glm::min(a[1], a[2])) - glm::max(b[0], glm::max(b[1], b[2])),
                 glm::min(b[0], glm::min(b[1], b[2])) - glm::max(a[0], glm::max(a[1], a[2])));
    if (gap.x > 0.0f || gap.y > 0.0f || gap.z > 0.0f) return;
    const std::optional<Stretch> line =
        intersection({glm::dvec3(a[0]), glm::dvec3(a[1]), glm::dvec3(a[2])},
                     {glm::dvec3(b[0]), glm::dvec3(b[1]), glm::dvec3(b[2])});
    if (!line || over_budget_.load(std::memory_order_relaxed)) return;
    lines.push_back({glm::vec3(line->p), glm::vec3(line->q), s, t});
    // Each thread may fill the budget by itself; the sum is checked at the end.
    if (lines.size() > max_lines_) over_budget_.store(true, std::memory_order_relaxed);
  }

  Intersections gather(bool no_error) {
    Intersections out;
    for (const std::vector<IntersectionLine>& lines : found_)
      out.lines.insert(out.lines.end(), lines.begin(), lines.end());
    if (!no_error || over_budget_ || out.lines.size() > max_lines_) return {{}, false};
    std::sort(out.lines.begin(), out.lines.end(),
              [](const IntersectionLine& x, const IntersectionLine& y) {
                return x.first_triangle != y.first_triangle ? x.first_triangle < y.first_triangle
                                                            : x.second_triangle < y.second_triangle;
              });
    return out;
  }

  const World& world_;
  std::size_t max_lines_;
  tbb::enumerable_thread_specific<std::vector<IntersectionLine>> found_;
  std::atomic<bool> over_budget_{false};
};

}  // namespace

Intersections find_intersections(const World& world, std::size_t max_lines) {
  if (world.triangles.size() < 2) return {};
  return Collider(world, max_lines).run();
}

}  // namespace asos
