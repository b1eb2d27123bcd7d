#pragma once

#include "renderer/pyray/error_budget.h"
#include "renderer/pyray/estimate.h"
#include "renderer/pyray/square.h"
#include "renderer/reflections/reflection_mask.h"
#include "renderer/samples/sample_sums.h"
#include "renderer/samples/sobol_sampler.h"
#include "renderer/sampling/sequential_mean.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace asos {

/// Estimates parts of pixels by samples that are well distributed over the part and each light, in
/// packets. Used where so many boundaries or lights affect a part that an exact result would cost
/// more (design section 5, "Saturation").
class RegionSampler {
 public:
  /// `block` is the frame's block of pixels, in whose square the regions lie. `mask` has the
  /// weights of the square's parts; null: uniform. All arguments have to outlive this. After a
  /// request on `stop`, estimates use the samples taken until then.
  RegionSampler(const RenderScene& scene, const ViewContext& viewer, const RenderSettings& settings,
                PixelRect block, int seed, const ReflectionMask* mask = nullptr,
                std::stop_token stop = {}, SummedRadiance shows = SummedRadiance::all);

  /// When to stop sampling: approximate numbers of samples in the region, powers of two. The error
  /// is in display intensity, or relative to the value if that alone makes the pixel brighter than
  /// white.
  struct Goal : SamplingGoal {
    double share = 0.0;  ///< weight in its pixel; 0: too little to make it white
  };
  /// Mean of a region in linear radiance. `error` is its standard error. `cost` is the number of
  /// samples that count; 0: there is no mean.
  struct Mean : Estimate {
    double masked_share = 0.0;  ///< fraction of the samples in the region that the mask excludes
    bool one_round = false;     ///< the first round was enough
    /// Added to a negative mean, which a control variate can cause, to make it 0.
    glm::dvec3 raised{0.0};
  };

  /// See SampledLights.
  void restrict_to(std::span<const std::uint8_t> lights) { sums_.restrict_to(lights); }
  /// From now on regions have the layers that the settings ask for, too.
  void note_layers() { with_layers_ = settings_->layers.of_surfaces(); }
  /// Puts a region off until `run`; its number among those that wait, from 0. With layers, its
  /// samples and as many more eye rays as make `layer_samples` are summed up to them; 0: its layers
  /// are only the parts of its radiance.
  std::size_t add(const LeafRegion& region, const Goal& goal, std::uint32_t layer_samples = 0);
  /// Sets a place in waiting region `number` that `run` samples if no other sample meets the
  /// region.
  void set_inside(std::size_t number, glm::vec2 at) { waiting_[number].inside = at; }
  /// Samples all waiting regions and empties the queue. Returns their estimates by number, valid
  /// until the next call. Each round doubles the number of samples, until the means of eighths of a
  /// region's samples show that its goal is met, and neighbouring pixels' samples agree. The rays
  /// of all regions in a round share packets. Samples depend only on the region and on the pixel in
  /// which its square starts; squares within a pixel use different samples of one sequence. With a
  /// `kernel`, samples are distributed by it.
  std::span<const Mean> run(RenderStatistics& counts, const BlurKernel* kernel = nullptr);
  /// Runs the first of two stages: samples all waiting regions until their errors are within
  /// `times` their goals' errors. Then `take_open` returns the regions that have not met their
  /// goals, and `resume` continues with them. The bits are the same for any sampler with the same
  /// arguments.
  std::span<const Mean> start(RenderStatistics& counts, double times);
  /// Returns a waiting region. Its border is valid until the next `add`, `take_open` or `run`.
  [[nodiscard]] LeafRegion region(std::size_t number) const { return region(waiting_[number]); }
  /// Returns whether `start` left region `number` open.
  [[nodiscard]] bool open(std::size_t number) const { return !waiting_[number].done; }
  /// Ends an open region.
  void end(std::size_t number);
  /// Runs the second stage at once. Returns the estimates of all regions.
  std::span<const Mean> finish(RenderStatistics& counts);
  /// The layers of a region after `run`, `start` or `resume`, as sums over its samples.
  [[nodiscard]] const LayerSum& layers(std::size_t number) const { return layers_[number]; }
  /// Regions that were left open, in their order, with their samples so far.
  class Open;
  [[nodiscard]] Open take_open();
  /// Runs the second stage. Returns the estimates of the open regions, in order.
  std::span<const Mean> resume(Open&& open, RenderStatistics& counts);
  /// Samples one region.
  [[nodiscard]] Mean sample(const LeafRegion& region, const Goal& goal, RenderStatistics& counts,
                            const BlurKernel* kernel = nullptr) {
    add(region, goal);
    return run(counts, kernel).front();
  }

 private:
  /// A waiting region with its samples so far.
  struct Waiting {
    Square square;
    std::size_t first_edge = 0, edges = 0;  // of its border
    Goal goal;
    std::uint32_t per_sum = 0;  // number of samples in each of its sums
    std::size_t first_sum = 0;
    std::uint32_t taken = 0;  // samples so far, including those outside the region
    std::uint32_t in_region = 0;
    std::uint32_t masked = 0;  // number of samples outside the mask
    std::uint32_t layer_samples = 0;
    std::optional<glm::vec2> inside;  // a place in the region
    bool rests = false;               // until the stage ends
    bool done = false;
  };
  /// A pixel's region that the first stage finished.
  struct Finished {
    Square square;
    std::uint32_t taken = 0;
    double error = 0.0;
  };
  [[nodiscard]] LeafRegion region(const Waiting& waiting) const {
    return {waiting.square, std::span(borders_).subspan(waiting.first_edge, waiting.edges)};
  }
  void make_room();
  void sample_stage(double times, RenderStatistics& counts, const BlurKernel* kernel);
  void forget();
  void note_layers_of_waiting();
  void add_samples_for_layers(RenderStatistics& counts);
  void add_round(Waiting& waiting, const BlurKernel* kernel);
  void sample_inside();
  void add_samples(SampleSums& sums, Waiting& waiting, std::uint32_t end, const BlurKernel* kernel);
  [[nodiscard]] bool suffices(std::size_t number, double times) const;
  [[nodiscard]] bool near(const Square& a, const Square& b) const;
  [[nodiscard]] double expected_error(std::size_t number) const;
  [[nodiscard]] Mean mean_of(const Waiting& waiting) const;
  [[nodiscard]] double standard_error(const Waiting& waiting, glm::dvec3 mean) const;

  PixelRect block_;
  const ReflectionMask* mask_;
  std::stop_token stop_;
  double white_;  // the radiance that is white in a picture
  SobolSampler places_;
  SampleSums sums_;
  const RenderScene* scene_;
  const ViewContext* viewer_;
  const RenderSettings* settings_;
  bool with_layers_ = false;
  std::vector<LayerSum> layers_;  // of each region that waits; none without layers
  LayerTargets targets_;          // these
  std::vector<Waiting> waiting_;
  std::vector<Finished> finished_;  // in the first stage, if this is the second
  std::vector<BorderEdge> borders_;
  std::vector<Mean> found_;
  std::vector<bool> suffices_;
};

class RegionSampler::Open {
 public:
  [[nodiscard]] bool empty() const { return waiting_.empty(); }
  /// The layers of region `number` so far.
  [[nodiscard]] const LayerSum& layers(std::size_t number) const { return layers_[number]; }
  [[nodiscard]] std::size_t bytes() const {
    return waiting_.size() * sizeof(Waiting) + finished_.size() * sizeof(Finished) +
           borders_.size() * sizeof(BorderEdge) + sums_.size() * sizeof(SampleSums::Sum) +
           layers_.size() * sizeof(LayerSum);
  }

 private:
  friend class RegionSampler;
  std::vector<Waiting> waiting_;
  std::vector<Finished> finished_;  // near those that wait
  std::vector<BorderEdge> borders_;
  std::vector<SampleSums::Sum> sums_;  // the sums that each region uses
  std::vector<LayerSum> layers_;       // one a region, or none
};

/// Returns the sampling goal of a part of a root. Sampling starts with the pilot's number, or
/// `fewest` if larger. It ends at the number that MAX allows, or once the standard error is within
/// the allowance.
[[nodiscard]] RegionSampler::Goal sample_goal(const ErrorBudget& error_budget, double weight,
                                              std::uint32_t fewest = 1);

}  // namespace asos
