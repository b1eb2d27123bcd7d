// How much of `sobol` is more than its rays: the processor time of a picture by one thread, over
// the time that its eye rays, shadow rays and reflection rays take in packets and nothing else,
// both the median of runs that take turns. What a sampler that shades for free would take is 1.
//
//   bench rays-alone [--spp N] [--size WxH] SCENE...
//
// The rays are made one by one, as the light transports do that shade without batches, and kept;
// the rays behind blended surfaces are not among them.

#include "renderer/samples/sampled_reflections.h"
#include "renderer/samples/sobol_places.h"
#include "renderer/shading/shadow_ray.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asos::bench::rays_alone {

/// Shadow rays to one light, as RayScene takes them.
struct ShadowRays {
  std::int32_t own_part = -1;
  std::vector<float> origin[3], direction[3], t_far;

  void add(const Ray& ray) {
    for (int k = 0; k < 3; ++k) {
      origin[k].push_back(ray.origin[k]);
      direction[k].push_back(ray.direction[k]);
    }
    t_far.push_back(ray.t_far);
  }
  /// Room for whole packets behind the last ray.
  void pad() {
    for (int k = 0; k < 3; ++k) {
      origin[k].resize(origin[k].size() + 16);
      direction[k].resize(direction[k].size() + 16);
    }
  }
  [[nodiscard]] RayArrays arrays() const {
    return {t_far.size(),
            {origin[0].data(), origin[1].data(), origin[2].data()},
            {direction[0].data(), direction[1].data(), direction[2].data()},
            t_far.data()};
  }
};

/// The rays of a batch of samples, as they are traced together.
struct RayBatch {
  std::vector<Ray> closest;         ///< eye rays, or those of one bounce
  std::vector<ShadowRays> shadows;  ///< by light
};

/// Keeps the rays of one sample after the other.
class Recorder final : public LightTransport {
 public:
  Recorder(const Shader& shader, SobolPlaces& places, SampledReflections& reflections,
           const PointSample& sample, std::map<std::uint32_t, ShadowRays>& shadows)
      : shader_(shader),
        places_(places),
        reflections_(reflections),
        sample_(sample),
        shadows_(shadows) {}

  void add(const Illumination& lit, glm::vec3& /*radiance*/, RenderStatistics& counts) override {
    const glm::dvec2 at = places_.on_light(lit.index);
    const LightSample found = sample_light(lit.light, receiver_at(lit.point), at.x, at.y);
    if (lit.reflected * found.irradiance == glm::vec3(0.0f)) return;
    ++counts.shadow_rays;
    ShadowRays& rays = shadows_[lit.index];
    rays.own_part = lit.light.own_part;
    rays.add(shadow_ray(lit.point, found));
  }
  bool reflect(const Reflection& reflection, glm::vec3& /*radiance*/,
               RenderStatistics& /*counts*/) override {
    reflections_.add(reflection, sample_, glm::vec3(1.0f), shader_);
    return true;
  }

 private:
  const Shader& shader_;
  SobolPlaces& places_;
  SampledReflections& reflections_;
  const PointSample& sample_;
  std::map<std::uint32_t, ShadowRays>& shadows_;
};

/// All rays of a picture.
class Recording {
 public:
  Recording(const Snapshot& snapshot, int spp)
      : scene_(*snapshot.scene),
        view_(snapshot.camera, snapshot.settings.width, snapshot.settings.height,
              radius_around_origin(scene_.world().bounds)),
        shader_(shader_of(scene_, snapshot.settings, view_)),
        faces_(culling_of(snapshot.settings)),
        places_(snapshot.settings.seed),
        reflections_(scene_.world(), places_) {
    const int width = snapshot.settings.width, height = snapshot.settings.height;
    for (int by = 0; by < height; by += block_size) {
      for (int bx = 0; bx < width; bx += block_size)
        record_block({bx, by, std::min(block_size, width - bx), std::min(block_size, height - by)},
                     spp);
    }
  }

  /// Traces them all, and nothing else.
  void trace() const {
    std::vector<Hit> hits(batch);
    std::vector<glm::vec3> shares(batch);
    for (const RayBatch& rays : batches_) {
      hits.resize(std::max(hits.size(), rays.closest.size()));
      scene_.rays().closest(rays.closest, std::span(hits).first(rays.closest.size()), faces_);
      for (const ShadowRays& shadows : rays.shadows) {
        shares.resize(std::max(shares.size(), shadows.t_far.size()));
        scene_.rays().transmittance(shadows.arrays(), std::span(shares).first(shadows.t_far.size()),
                                    shadows.own_part);
      }
    }
  }
  [[nodiscard]] const RenderStatistics& counts() const { return counts_; }

 private:
  static constexpr std::size_t batch = 256;

  void record_block(const PixelRect& block, int spp) {
    const auto side = static_cast<float>(1.0 / std::sqrt(spp));
    std::vector<PointSample> samples;
    for (int y = block.y; y < block.y + block.height; ++y) {
      for (int x = block.x; x < block.x + block.width; ++x) {
        places_.start_pixel(x, y);
        for (int index = 0; index < spp; ++index) {
          places_.start_sample(index);
          const PixelPoint p = places_.in_pixel();
          samples.push_back({{x + p.x, y + p.y}, side, x, y, index, 0});
          if (samples.size() == batch) {
            record(samples);
            places_.start_pixel(x, y);
          }
        }
      }
    }
    record(samples);
  }

  void record(std::vector<PointSample>& samples) {
    if (samples.empty()) return;
    std::map<std::uint32_t, ShadowRays> shadows;
    RayBatch eye;
    for (const PointSample& s : samples) eye.closest.push_back(view_.ray(s.at.x, s.at.y));
    std::vector<Hit> hits(samples.size());
    scene_.rays().closest(eye.closest, hits, faces_);
    for (std::size_t i = 0; i < samples.size(); ++i)
      shade(samples[i], shader_.eye_ray(eye.closest[i], hits[i], samples[i].side), shadows);
    counts_.eye_rays += samples.size();
    batches_.push_back(std::move(eye));
    while (reflections_.waiting() > 0) {
      RayBatch bounce;
      const std::vector<ReflectedSample> next = reflections_.take();
      for (const ReflectedSample& r : next) bounce.closest.push_back(r.ray);
      hits.resize(next.size());
      scene_.rays().closest(bounce.closest, hits, faces_);
      for (std::size_t i = 0; i < next.size(); ++i)
        shade(next[i].sample, next[i].viewed(hits[i]), shadows);
      counts_.reflection_rays += next.size();
      batches_.push_back(std::move(bounce));
    }
    for (auto& [light, rays] : shadows) {
      rays.pad();
      batches_.back().shadows.push_back(std::move(rays));
    }
    samples.clear();
  }

  void shade(const PointSample& sample, const ViewedRay& seen,
             std::map<std::uint32_t, ShadowRays>& shadows) {
    places_.start_pixel(sample.x, sample.y);
    places_.start_sample(sample.index);
    Recorder recorder(shader_, places_, reflections_, sample, shadows);
    (void)shader_.radiance(seen, recorder, counts_);
  }

  const RenderScene& scene_;
  View view_;
  Shader shader_;
  Culling faces_;
  SobolPlaces places_;
  SampledReflections reflections_;
  std::vector<RayBatch> batches_;
  RenderStatistics counts_;
};

double processor_seconds(const auto& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

int measure(const std::string& source, int spp, PictureSize size) {
  const auto scene = open_scene(source);
  if (!scene) return fail(scene.error());
  Snapshot snapshot = snapshot_of(*scene, size.width, size.height);
  snapshot.settings.method = Method::sobol;
  snapshot.settings.sampling.spp = spp;
  snapshot.settings.threads = 1;
  const Recording recording(snapshot, spp);
  std::vector<double> rays, render;
  for (int run = 0; run < 5; ++run) {
    rays.push_back(processor_seconds([&] { recording.trace(); }));
    render.push_back(processor_seconds([&] { (void)render_to_end(snapshot); }));
  }
  const RenderStatistics& counts = recording.counts();
  const double alone = median(rays), whole = median(render);
  fmt::print("{}: {:.2f} times its rays ({:.3f} s, {:.3f} s; eye {}, shadow {}, reflection {})\n",
             source, whole / alone, whole, alone, counts.eye_rays, counts.shadow_rays,
             counts.reflection_rays);
  return 0;
}

int run(int argc, char** argv) {
  Options options("The time of sobol over that of its rays alone");
  int spp = 16;
  PictureSize size{320, 180};
  std::vector<std::string> scenes;
  options.number("--spp", spp, 1, 4096, "Samples a pixel");
  options.size(size);
  options.texts("scene", scenes);
  if (const auto code = options.end(argc, argv)) return *code;
  int status = 0;
  for (const std::string& scene : scenes) status |= measure(scene, spp, size);
  return status;
}

}  // namespace asos::bench::rays_alone
