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

/// Where the samples of one pixel lie, in the pixel and on the lights: what the methods that only
/// place samples differ in.
class SamplePlaces : public LightPlaces {
 public:
  virtual void start_pixel(int x, int y) = 0;
  /// Goes to sample `index` of the pixel.
  virtual void start_sample(int index) = 0;
  [[nodiscard]] virtual PixelPoint in_pixel() const = 0;
  /// Of samples `first` and on of the pixel; the one under way is the last of them.
  virtual void in_pixel(int first, std::span<PixelPoint> points);

  /// From now on samples have places on the camera's lens, too.
  virtual void use_lens() {}
  /// Where the sample under way starts on the camera's lens, in [0, 1) each.
  [[nodiscard]] virtual glm::dvec2 on_lens() const = 0;

  /// From now on samples have times while the shutter is open, too.
  virtual void use_time() {}
  /// When the sample under way looks, in [0, 1) from the shutter's opening to its closing.
  [[nodiscard]] virtual double in_time() const = 0;

  using LightPlaces::on_light;
  /// One sample after the other.
  void start_batch(std::span<const SampleIndex> samples) override { batch_ = samples; }
  void on_light(std::uint32_t light, LightPlaceBatch& places) override;

 private:
  std::span<const SampleIndex> batch_;
};

/// The points of a pixel's samples that methods ask for at a time.
inline constexpr int points_at_a_time = 16;

/// The side of the first square of at least `spp` samples.
[[nodiscard]] int grid_side(int spp);

/// The side, in pixels, of the footprint of one of so many samples of a pixel, whose filter is
/// `width` wide, but for colours. Where they are more than a few it is half of the square that a
/// sample stands for: they are scattered all over it as it is, and a lobe that is widened by a
/// patch of normals has tails that the patch has not.
[[nodiscard]] float sample_side(double width, int samples);

/// The side of what a sample's colours are averaged over, in that of the square that it stands for:
/// they add up as they are, so that wide footprints take noise from them and bring no tails; but
/// those that reach beyond what the square shows look past where a texture ends.
inline constexpr float colour_side = 0.75f;

/// A block of pixels as the mean of `samples` point samples each, through packets of rays, in the
/// rounds of PixelSamples. A sample stands for its share of the pixel's area.
[[nodiscard]] BlockResult sample_block(const BlockJob& job, SamplePlaces& places, int samples);

/// n x n strata of the pixel and of time, and for the lens and each light another assignment of its
/// own n x n strata to the samples, seeded by pixel: a sample in the middle of each stratum, or
/// anywhere in it. Samples go from stratum to stratum so that the first few are spread over the
/// pixel as well.
class GridPlaces final : public SamplePlaces {
 public:
  GridPlaces(int n, bool jittered);

  void start_pixel(int x, int y) override { x_ = x, y_ = y; }
  void start_sample(int index) override {
    index_ = static_cast<int>(static_cast<std::int64_t>(index) * step_ % (n_ * n_));
  }
  [[nodiscard]] PixelPoint in_pixel() const override;
  using SamplePlaces::in_pixel;
  using SamplePlaces::on_light;
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
  /// A place in the strata, likewise.
  [[nodiscard]] glm::dvec2 in_strata(std::uint32_t stream) const;

  int n_;
  int step_;  // from one sample's stratum to the next one's
  bool jittered_;
  int x_ = 0, y_ = 0;
  int index_ = 0;  // of the stratum
};

}  // namespace asos
