#pragma once

#include "renderer/samples/block_job.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/sampling/random.h"

#include <cstdint>
#include <span>

namespace asos {

/// A sample's place in its pixel, each coordinate 0 to 1.
struct PixelPoint {
  double x = 0.5;
  double y = 0.5;
};

/// Places of a pixel's samples, in the pixel and on the lights. Sampling methods differ only in
/// this class.
class PixelSampler : public LightSamplePoints {
 public:
  virtual void start_pixel(int x, int y) = 0;
  /// Selects sample `index` of the pixel as the current one.
  virtual void start_sample(int index) = 0;
  [[nodiscard]] virtual PixelPoint in_pixel() const = 0;
  /// Computes the places of successive samples of the pixel, starting with `first`. The last
  /// becomes the current one.
  virtual void in_pixel(int first, std::span<PixelPoint> points);

  /// Enables places on the camera's lens for all later samples.
  virtual void use_lens() {}
  /// Returns the current sample's place on the camera's lens, in [0, 1) each.
  [[nodiscard]] virtual glm::dvec2 on_lens() const = 0;

  /// From now on samples have times while the shutter is open, too.
  virtual void use_time() {}
  /// Returns the current sample's time, in [0, 1) from the shutter's opening to its closing.
  [[nodiscard]] virtual double in_time() const = 0;

  using LightSamplePoints::on_light;
  /// Handles one sample after the other.
  void start_batch(std::span<const SampleIndex> samples) override { batch_ = samples; }
  void on_light(std::uint32_t light, LightPointBatch& places) override;
  void on_light(std::uint32_t light, std::span<const std::uint32_t> of,
                LightPointBatch& places) override;

 private:
  std::span<const SampleIndex> batch_;
};

/// Number of a pixel's points that methods request at a time.
inline constexpr int points_at_a_time = 16;

/// Returns the side of the smallest square grid with at least `spp` samples.
[[nodiscard]] int grid_side(int spp);

/// Returns the side, in pixels, of the footprint of a sample, for this many samples per pixel and a
/// filter of width `width`; colours use colour_side. With more than a few samples it is half the
/// square that a sample represents. The samples already cover the square, and a lobe that is
/// widened by a patch of normals has longer tails than the patch.
[[nodiscard]] float sample_side(double width, int samples);

/// Side of the square over which a sample's colours are averaged, relative to the square that it
/// represents. Averages of colours are exact, so wide footprints reduce noise without tails.
/// Footprints beyond the square would reach past the border of a texture.
inline constexpr float colour_side = 0.75f;

/// Renders a block of pixels as the mean of `samples` point samples each, in packets of rays and in
/// the rounds of PixelSamples. Each sample represents an equal part of the pixel's area.
[[nodiscard]] BlockResult sample_block(const BlockJob& job, PixelSampler& places, int samples);

/// Samples n x n strata of the pixel. The lens, the time and each light have their own n x n
/// strata, assigned to the samples in another order, seeded by pixel. A sample lies in the middle
/// of its stratum, or anywhere in it. Samples go from stratum to stratum so that the first few are
/// spread over the pixel as well.
class GridSampler final : public PixelSampler {
 public:
  GridSampler(int n, bool jittered);

  void start_pixel(int x, int y) override { x_ = x, y_ = y; }
  void start_sample(int index) override {
    index_ = static_cast<int>(static_cast<std::int64_t>(index) * step_ % (n_ * n_));
  }
  [[nodiscard]] PixelPoint in_pixel() const override;
  using PixelSampler::in_pixel;
  using PixelSampler::on_light;
  [[nodiscard]] glm::dvec2 on_light(std::uint32_t light) const override;
  [[nodiscard]] glm::dvec2 on_lens() const override;
  [[nodiscard]] double in_time() const override;

 private:
  /// A stratum, by a stream of random numbers, and a place in it.
  struct Stratum {
    int cell;
    RandomPair place;
  };
  [[nodiscard]] Stratum stratum(std::uint32_t stream) const;
  /// Returns a place in the unit square, in the stratum of a stream.
  [[nodiscard]] glm::dvec2 in_strata(std::uint32_t stream) const;

  int n_;
  int step_;  // from one sample's stratum to the next
  bool jittered_;
  int x_ = 0, y_ = 0;
  int index_ = 0;  // of the stratum
};

}  // namespace asos
