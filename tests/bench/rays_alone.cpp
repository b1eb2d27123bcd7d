// Overhead of a method over its rays: CPU time of a picture on one thread relative to the time in
// its own calls of Embree, filters included. Both are medians of alternating runs. A sampler with
// free shading would have 1.
//
//   bench rays-alone [--method sobol|asos] [--spp N] [--size WxH] [SCENE...]

#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <ctime>
#include <dlfcn.h>
#include <string>
#include <vector>

namespace asos::bench::rays_alone {
namespace {

using Clock = std::chrono::steady_clock;

/// Time spent in Embree; counts a single thread.
struct Calls {
  bool timed = false;
  Clock::duration time{};
  std::uint64_t count = 0;
  std::uint64_t rays = 0;
};
Calls calls;  // the functions below replace Embree's and can reach it only as a global

template <typename Function>
Function* embrees(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

template <typename Call>
void timed(std::uint64_t rays, const Call& call) {
  if (!calls.timed) return call();
  const auto start = Clock::now();
  call();
  calls.time += Clock::now() - start;
  ++calls.count;
  calls.rays += rays;
}

template <int width>
std::uint64_t active(const int* valid) {
  std::uint64_t rays = 0;
  for (int lane = 0; lane < width; ++lane) rays += valid[lane] != 0;
  return rays;
}

}  // namespace
}  // namespace asos::bench::rays_alone

// The linker prefers the program's own definitions to those of the shared library, also for the
// renderer.
#define ASOS_TIMED_PACKETS(NAME, WIDTH, RAYS)                                                 \
  extern "C" void NAME(const int* valid, RTCScene scene, RTCIntersectContext* context,        \
                       RAYS* rays) {                                                          \
    using namespace asos::bench::rays_alone;                                                  \
    static auto* const own = embrees<decltype(NAME)>(#NAME);                                  \
    timed(calls.timed ? active<WIDTH>(valid) : 0, [&] { own(valid, scene, context, rays); }); \
  }
#define ASOS_TIMED_RAY(NAME, RAYS)                                                 \
  extern "C" void NAME(RTCScene scene, RTCIntersectContext* context, RAYS* rays) { \
    using namespace asos::bench::rays_alone;                                       \
    static auto* const own = embrees<decltype(NAME)>(#NAME);                       \
    timed(1, [&] { own(scene, context, rays); });                                  \
  }
ASOS_TIMED_RAY(rtcIntersect1, RTCRayHit)
ASOS_TIMED_RAY(rtcOccluded1, RTCRay)
ASOS_TIMED_PACKETS(rtcIntersect4, 4, RTCRayHit4)
ASOS_TIMED_PACKETS(rtcOccluded4, 4, RTCRay4)
ASOS_TIMED_PACKETS(rtcIntersect8, 8, RTCRayHit8)
ASOS_TIMED_PACKETS(rtcOccluded8, 8, RTCRay8)
ASOS_TIMED_PACKETS(rtcIntersect16, 16, RTCRayHit16)
ASOS_TIMED_PACKETS(rtcOccluded16, 16, RTCRay16)
#undef ASOS_TIMED_PACKETS
#undef ASOS_TIMED_RAY

namespace asos::bench::rays_alone {
namespace {

double seconds(Clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

/// Time in seconds that two readings of the clock add to an interval.
double clocks_own_time() {
  constexpr int times = 1 << 16;
  Clock::duration sum{};
  for (int i = 0; i < times; ++i) {
    const auto start = Clock::now();
    sum += Clock::now() - start;
  }
  return seconds(sum) / times;
}

double processor_seconds(const Snapshot& snapshot) {
  const std::clock_t start = std::clock();
  (void)render_to_end(snapshot);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

int measure(const std::string& source, Method method, int spp, PictureSize size) {
  const auto scene = open_scene(source);
  if (!scene) return fail(scene.error());
  Snapshot snapshot = snapshot_of(*scene, size.width, size.height);
  snapshot.settings.method = method;
  snapshot.settings.sampling.spp = spp;
  snapshot.settings.threads = 1;
  const double own_time = clocks_own_time();
  std::vector<double> rays, render;
  for (int run = 0; run < 5; ++run) {
    render.push_back(processor_seconds(snapshot));
    calls = {.timed = true};
    (void)render_to_end(snapshot);
    calls.timed = false;
    rays.push_back(seconds(calls.time) - own_time * static_cast<double>(calls.count));
  }
  const double alone = median(rays), whole = median(render);
  fmt::print("{}: {:.2f} times its rays ({:.3f} s, {:.3f} s; {} rays, {:.1f} a call)\n", source,
             whole / alone, whole, alone, calls.rays,
             static_cast<double>(calls.rays) / static_cast<double>(calls.count));
  return 0;
}

}  // namespace

int run(int argc, char** argv) {
  Options options("The time of a method over that of its rays alone");
  std::string method = "sobol";
  int spp = 16;
  PictureSize size{320, 180};
  std::vector<std::string> scenes;
  options.choice("--method", method, {"sobol", "asos"});
  options.number("--spp", spp, 1, 4096, "Samples a pixel");
  options.size(size);
  options.texts("scene", scenes);
  if (const auto code = options.end(argc, argv)) return *code;
  int status = 0;
  for (const NamedScene& scene : chosen_scenes(scenes))
    status |= measure(scene.source, method == "asos" ? Method::asos : Method::sobol, spp, size);
  return status;
}

}  // namespace asos::bench::rays_alone
