// Cost of exact shadow answers in units of shadow rays, on which pyray/prices.h is based. For the
// pixels' centres of a picture and each light that something may shade: time of an exact answer
// relative to one ray of a sampled answer, on one thread. Prints quartiles over all such cases.
//
//   bench prices [--size WxH] SCENE...

#include "renderer/asos/eye_samples.h"
#include "renderer/pyray/tracer.h"
#include "renderer/pyray/tuning.h"
#include "renderer/shadows/penumbra.h"
#include "renderer/shadows/shadow.h"
#include "tests/bench/bench_support.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace asos::bench::prices {

constexpr int block_width = 8;

/// Costs of one kind of answer, in rays.
class Costs {
 public:
  void add(double rays) { rays_.push_back(rays); }
  void print(const char* what, double price) {
    if (rays_.empty()) return fmt::print("  {:28} never asked\n", what);
    std::sort(rays_.begin(), rays_.end());
    const auto at = [&](double share) {
      return rays_[static_cast<std::size_t>(share * static_cast<double>(rays_.size() - 1))];
    };
    double sum = 0.0;
    for (const double rays : rays_) sum += rays;
    fmt::print("  {:28} {:6.1f} {:6.1f} {:6.1f}   mean {:6.1f}   price {:4.0f}   ({} questions)\n",
               what, at(0.25), at(0.5), at(0.75), sum / static_cast<double>(rays_.size()), price,
               rays_.size());
  }

 private:
  std::vector<double> rays_;
};

struct AllCosts {
  Costs light_pyramid, penumbra_test, patch;
};

/// Computes the light at one point of a block, exactly and by rays.
class PointLights final : public LightTransport {
 public:
  PointLights(ShadowContext& block, const Leaf& leaf, const Patch& patch, AllCosts& costs)
      : block_(block), leaf_(leaf), patch_(patch), costs_(costs) {}

  void add(const Illumination& lit, glm::vec3& /*radiance*/,
           RenderStatistics& /*counts*/) override {
    const glm::vec3 all = lit.reflected * lit.unshadowed;
    constexpr float least_intensity = 1.0f / 32.0f;
    if (lit.layer > 0 || std::max({all.x, all.y, all.z}) < least_intensity) return;
    // The first call also computes the data that the block shares.
    (void)ask(lit, exact);
    const Answer exactly = ask(lit, exact);
    const Answer by_rays = ask(lit, coarse);
    if (exactly.pyrays == 0 || by_rays.pyrays > 0 || by_rays.rays == 0) return;
    const double ray = by_rays.seconds / static_cast<double>(by_rays.rays);
    (lit.light.extended() ? costs_.light_pyramid : costs_.patch).add(exactly.seconds / ray);
    if (!lit.light.extended()) return;
    block_.rules.error_budget.eps = exact;
    const float reflected = std::max({lit.reflected.x, lit.reflected.y, lit.reflected.z});
    const auto start = std::chrono::steady_clock::now();
    RenderStatistics counts;
    (void)find_penumbra(block_, {lit.light, lit.index, lit.point, patch_, reflected, 0, 1.0},
                        counts);
    costs_.penumbra_test.add(seconds_since(start) / ray);
  }

 private:
  // EPS for exact answers, and for answers from a few rays.
  static constexpr double exact = 0.0;
  static constexpr double coarse = 0.5;

  struct Answer {
    double seconds = 0.0;
    std::uint64_t rays = 0;
    std::uint64_t pyrays = 0;
  };
  Answer ask(const Illumination& lit, double eps) {
    block_.rules.error_budget.eps = eps;
    RenderStatistics counts;
    const auto start = std::chrono::steady_clock::now();
    (void)light_visibility(block_, lit, leaf_, counts);
    return {seconds_since(start), counts.shadow_rays, counts.shadow_pyrays};
  }

  ShadowContext& block_;
  const Leaf& leaf_;
  const Patch& patch_;
  AllCosts& costs_;
};

void measure_block(const Snapshot& snapshot, const View& view, const Shader& shader, int x, int y,
                   AllCosts& costs) {
  // Trace rays through the pixels' centres.
  const RenderSettings& settings = snapshot.settings;
  const RenderScene& scene = *snapshot.scene;
  const Frame frame = view.frame(x, y, block_width, block_width);
  RenderStatistics counts;
  EyeContext eye{&scene,
                 &settings,
                 ViewContext::camera(view, shader, 1.0),
                 &frame,
                 {x, y, block_width, block_width}};
  eye.error_budget = ErrorBudget::of(settings);
  eye.counts = &counts;
  EyeSamples samples(eye);
  std::vector<glm::vec2> middles;
  for (int i = 0; i < block_width * block_width; ++i)
    middles.emplace_back((glm::vec2(i % block_width, i / block_width) + 0.5f) /
                         static_cast<float>(block_width));
  samples.probe(middles);
  // The occluders that the block's answers share.
  const ShadowScene shadow_scene{scene.world(), scene.features(), scene.rays()};
  ShadowGroups groups(shadow_scene);
  groups.reset(shader.lights().size());
  for (SampleId i = 0; i < middles.size(); ++i) {
    if (!samples.hit(i).valid()) continue;
    const SurfacePoint point = samples.point(i);
    groups.add(samples.hit(i), point.position, point.geometric_normal, samples.patch(i, 1.0));
  }
  ShadowWorkspace work;
  ShadowContext block;
  block.scene = &shadow_scene;
  block.rules = {nullptr, eye.error_budget, nullptr, scene.render_features.varying_opacity};
  block.lights = shader.lights().size();
  block.frame = &frame;
  block.view = &samples;
  block.groups = &groups;
  block.work = &work;
  // Measure the light at each pixel centre.
  for (SampleId i = 0; i < middles.size(); ++i) {
    if (!samples.hit(i).valid()) continue;
    Leaf leaf;
    leaf.root_side = eye.root_side();
    leaf.region = {{middles[i].x - 0.5f * leaf.root_side, middles[i].y - 0.5f * leaf.root_side,
                    leaf.root_side},
                   {}};
    leaf.at = middles[i];
    leaf.seed = samples.seed(i);
    PointLights transport(block, leaf, samples.patch(i, 1.0), costs);
    (void)shader.radiance(samples.ray(i), samples.hit(i), 1.0f, transport, counts);
  }
}

int measure(const std::string& source, PictureSize size) {
  const auto opened = open_scene(source);
  if (!opened) return fail(opened.error());
  const Snapshot snapshot = snapshot_of(*opened, size.width, size.height);
  const View view(snapshot.camera, size.width, size.height,
                  radius_around_origin((*opened)->world().bounds));
  const Shader shader = shader_of(**opened, snapshot.settings, view);
  AllCosts costs;
  for (int y = 0; y + block_width <= size.height; y += block_width) {
    for (int x = 0; x + block_width <= size.width; x += block_width)
      measure_block(snapshot, view, shader, x, y, costs);
  }
  fmt::print("{}\n", source);
  costs.light_pyramid.print("light cut exactly", LeafCosts::light_view);
  costs.penumbra_test.print("search for a penumbra", LeafCosts::light_view);
  costs.patch.print("patch cut by a hard shadow", LeafCosts::patch);
  return 0;
}

int run(int argc, char** argv) {
  Options options("What exact answers of shadows cost in rays");
  PictureSize size{160, 90};
  std::vector<std::string> scenes;
  options.size(size);
  options.texts("scene", scenes);
  if (const auto code = options.end(argc, argv)) return *code;
  fmt::print("quartiles over all questions, in the time of one ray among those of a few\n");
  int status = 0;
  for (const std::string& scene : scenes) status |= measure(scene, size);
  return status;
}

}  // namespace asos::bench::prices
