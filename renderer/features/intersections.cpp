#include "renderer/features/intersections.h"

#include "renderer/features/triangle_line.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <numeric>
#include <optional>
#include <tbb/enumerable_thread_specific.h>

namespace asos {
namespace {

using Device = std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)>;
using Scene = std::unique_ptr<RTCSceneTy, void (*)(RTCScene)>;

struct Extent {
  glm::vec3 lo, hi;

  [[nodiscard]] bool meets(const Extent& other) const {
    return glm::all(glm::lessThanEqual(lo, other.hi)) && glm::all(glm::lessThanEqual(other.lo, hi));
  }
};

using Corners = glm::mat3;

Corners corners_of(const World& world, std::uint32_t triangle) {
  const glm::uvec3 t = world.triangles[triangle];
  return {world.positions[t.x], world.positions[t.y], world.positions[t.z]};
}

Extent extent_of(const Corners& c) {
  return {glm::min(c[0], glm::min(c[1], c[2])), glm::max(c[0], glm::max(c[1], c[2]))};
}

TriangleCorners in_double(const Corners& c) {
  return {glm::dvec3(c[0]), glm::dvec3(c[1]), glm::dvec3(c[2])};
}

// The corners of two triangles that lie at one place: how many, and the last such pair.
struct Meeting {
  int count = 0;
  int a = 0;
  int b = 0;
};

template <typename Triple>
Meeting meeting(const Triple& a, const Triple& b) {
  Meeting m;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      if (a[i] == b[k]) m = {m.count + 1, i, k};
  return m;
}

// Whether `b` lies on one side of `a`'s plane but for the corner that they share, by more than
// single precision can err. So do most neighbours at a corner, and these are most pairs.
bool beside(const Corners& a, const Corners& b, int corner_a, int corner_b) {
  const glm::vec3 v = a[corner_a];
  const glm::vec3 p = a[(corner_a + 1) % 3] - v, q = a[(corner_a + 2) % 3] - v;
  const glm::vec3 n = glm::cross(p, q);
  const glm::vec3 r = b[(corner_b + 1) % 3] - v, s = b[(corner_b + 2) % 3] - v;
  const float x = glm::dot(n, r), y = glm::dot(n, s);
  const float size = glm::dot(glm::abs(p), glm::vec3(1)) * glm::dot(glm::abs(q), glm::vec3(1));
  constexpr float error = 4e-6f;
  const float least = error * size * (glm::dot(glm::abs(r) + glm::abs(s), glm::vec3(1)));
  return (x > least && y > least) || (x < -least && y < -least);
}

// Some of a world's triangles, or all, as Embree wants them.
struct Selection {
  const World& world;
  std::vector<std::uint32_t> chosen;  // empty: all

  [[nodiscard]] std::size_t size() const {
    return chosen.empty() ? world.triangles.size() : chosen.size();
  }

  static void bounds(const RTCBoundsFunctionArguments* args) {
    const auto& self = *static_cast<const Selection*>(args->geometryUserPtr);
    const std::uint32_t t = self.chosen.empty() ? args->primID : self.chosen[args->primID];
    const auto [lo, hi] = extent_of(corners_of(self.world, t));
    *args->bounds_o = {lo.x, lo.y, lo.z, 0.0f, hi.x, hi.y, hi.z, 0.0f};
  }

  // Refers to the selection as long as it lives.
  [[nodiscard]] Scene build(const Device& device) {
    Scene scene(rtcNewScene(device.get()), rtcReleaseScene);
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_LOW);
    rtcCommitScene(scene.get());
    return scene;
  }
};

class Collider {
 public:
  Collider(const World& world, const IntersectionBudget& budget)
      : world_(world), budget_(budget), device_(rtcNewDevice(nullptr), rtcReleaseDevice) {}

  Intersections run() {
    if (!device_) return {{}, false};
    Selection all{world_, {}};
    const Scene scene = all.build(device_);
    if (hopeless(scene)) return {{}, false};
    rtcCollide(scene.get(), scene.get(), collide, this);
    return gather(rtcGetDeviceError(device_.get()) == RTC_ERROR_NONE);
  }

 private:
  struct Local {
    std::vector<IntersectionLine> lines;
    std::size_t pairs = 0;  // not yet in pairs_
  };
  using Partners = std::vector<std::size_t>;
  struct Survey {
    const Selection& few;
    tbb::enumerable_thread_specific<Partners> counts;
  };

  // Embree cannot be stopped once it collides, and needs nanoseconds a pair even where nobody looks
  // at the pairs. So count those of a few triangles first, chosen by a fixed rule.
  [[nodiscard]] bool hopeless(const Scene& scene) {
    const std::size_t n = world_.triangles.size();
    if (n * (n - 1) / 2 <= survey_slack * budget_.pairs) return false;
    Selection few{world_, {}};
    few.chosen.resize(std::clamp<std::size_t>((std::size_t{1} << 26) / n, 32, 256));
    std::uint64_t step = 0;
    for (std::uint32_t& t : few.chosen) {
      step += 0x9e3779b97f4a7c15ULL;
      t = static_cast<std::uint32_t>((step >> 32) % n);
    }
    const Scene chosen = few.build(device_);
    Survey found{few, tbb::enumerable_thread_specific<Partners>(few.size())};
    rtcCollide(chosen.get(), scene.get(), survey, &found);

    Partners partners(few.size());
    for (const Partners& local : found.counts)
      std::transform(local.begin(), local.end(), partners.begin(), partners.begin(), std::plus{});
    // A large floor may meet everything, but floors are few.
    std::sort(partners.begin(), partners.end());
    partners.resize(partners.size() - partners.size() / 32);
    const double mean =
        static_cast<double>(std::accumulate(partners.begin(), partners.end(), std::size_t{0})) /
        static_cast<double>(partners.size());
    return mean / 2.0 * static_cast<double>(n) > static_cast<double>(survey_slack * budget_.pairs);
  }

  static void survey(void* found, RTCCollision* collisions, unsigned count) {
    auto& [few, counts] = *static_cast<Survey*>(found);
    Partners& partners = counts.local();
    for (unsigned i = 0; i < count; ++i) {
      const std::uint32_t t = few.chosen[collisions[i].primID0];
      partners[collisions[i].primID0] +=
          extent_of(corners_of(few.world, t))
              .meets(extent_of(corners_of(few.world, collisions[i].primID1)));
    }
  }

  static void collide(void* self, RTCCollision* collisions, unsigned count) {
    auto& collider = *static_cast<Collider*>(self);
    if (collider.over_budget_.load(std::memory_order_relaxed)) return;
    Local& local = collider.found_.local();
    for (unsigned i = 0; i < count; ++i) {
      // Each pair comes twice.
      if (collisions[i].primID0 < collisions[i].primID1)
        collider.test(collisions[i].primID0, collisions[i].primID1, local);
    }
    collider.spend(local);
  }

  void test(std::uint32_t s, std::uint32_t t, Local& local) {
    // Neighbours along an edge meet there and nowhere else, unless they lie in one plane.
    if (meeting(world_.triangles[s], world_.triangles[t]).count > 1) {
      ++local.pairs;
      return;
    }
    const Corners a = corners_of(world_, s), b = corners_of(world_, t);
    // Embree reports pairs of leaves.
    if (!extent_of(a).meets(extent_of(b))) return;
    ++local.pairs;
    const Meeting m = meeting(a, b);
    if (m.count > 1) return;
    if (m.count == 1 && (beside(a, b, m.a, m.b) || beside(b, a, m.b, m.a))) return;
    const std::optional<Stretch> line = common_line(in_double(a), in_double(b), world_.origin);
    if (line) local.lines.push_back({glm::vec3(line->p), glm::vec3(line->q), s, t});
  }

  // Over the budget or not is the same whatever the threads do: every pair is counted once, and
  // counting stops early only where it is over.
  void spend(Local& local) {
    constexpr std::size_t batch = 1024;
    if (local.pairs >= batch) {
      pairs_ += local.pairs;
      local.pairs = 0;
    }
    if (local.lines.size() > budget_.lines || pairs_ > budget_.pairs) over_budget_ = true;
  }

  Intersections gather(bool no_error) {
    Intersections out;
    for (const Local& local : found_) {
      pairs_ += local.pairs;
      out.lines.insert(out.lines.end(), local.lines.begin(), local.lines.end());
    }
    if (!no_error || over_budget_ || out.lines.size() > budget_.lines || pairs_ > budget_.pairs)
      return {{}, false};
    std::sort(out.lines.begin(), out.lines.end(),
              [](const IntersectionLine& x, const IntersectionLine& y) {
                return x.first_triangle != y.first_triangle ? x.first_triangle < y.first_triangle
                                                            : x.second_triangle < y.second_triangle;
              });
    return out;
  }

  // The survey may err by its chance; it must not refuse what fits.
  static constexpr std::size_t survey_slack = 2;

  const World& world_;
  IntersectionBudget budget_;
  Device device_;
  tbb::enumerable_thread_specific<Local> found_;
  std::atomic<std::size_t> pairs_{0};
  std::atomic<bool> over_budget_{false};
};

}  // namespace

IntersectionBudget IntersectionBudget::of(const World& world) {
  const std::size_t n = world.triangles.size();
  return {std::max<std::size_t>(10'000, 4 * n), 1'000'000 + 256 * n};
}

Intersections find_intersections(const World& world, const IntersectionBudget& budget) {
  if (world.triangles.size() < 2) return {};
  return Collider(world, budget).run();
}

}  // namespace asos
