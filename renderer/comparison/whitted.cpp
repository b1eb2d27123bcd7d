#include "renderer/comparison/whitted_spheres.h"
#include "renderer/film/layer_sums.h"
#include "renderer/film/tone.h"
#include "renderer/samples/block_job.h"
#include "renderer/samples/sample_sums.h"
#include "renderer/samples/sobol_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

// Adaptive supersampling in image space (Whitted 1980; CGF'98 section 2.3): rays through the
// corners of pixels, and through those of quarters if the corners differ.

namespace asos {
namespace {

/// A corner of a square, in units of 2^-depth pixels from the block's top left corner.
struct Corner {
  int x = 0;
  int y = 0;
};

struct CornerSquare {
  Corner corner;                       // the top left one
  std::array<std::size_t, 4> samples;  // of its corners: left to right, then top to bottom
  std::size_t pixel = 0;               // of the block
};

class AdaptiveBlock {
 public:
  explicit AdaptiveBlock(const BlockJob& job)
      : job_(job),
        depth_(job.settings.sampling.depth),
        contrast_(static_cast<float>(job.settings.sampling.contrast)),
        places_(job.settings.seed),
        sums_(job, places_),
        spheres_(job.settings.sampling.spheres
                     ? std::span<const ObjectSphere>(job.scene.geometry->object_spheres)
                     : std::span<const ObjectSphere>(),
                 job.view, job.block) {
    result_.tile.rect = job.block;
    const auto pixels = static_cast<std::size_t>(job.block.width * job.block.height);
    result_.tile.split_level.assign(pixels, 0);
    sum_.resize(pixels, glm::dvec3(0.0));
    area_.resize(pixels, 0.0);
    if (!job.settings.layers.of_surfaces()) return;
    layers_.resize(pixels);
    sums_.note_layers(job_.settings, corner_targets_);
  }

  BlockResult run() {
    take_pixels_corners();
    // Samples between these corners are kept for a few pixels at a time, which bounds the memory.
    const int side = std::max(1, most_cells_across >> depth_);
    for (int y = 0; y < job_.block.height; y += side) {
      for (int x = 0; x < job_.block.width; x += side) {
        if (stopped_) return publish();
        subdivide(
            {x, y, std::min(side, job_.block.width - x), std::min(side, job_.block.height - y)});
      }
    }
    return publish();
  }

 private:
  static constexpr int most_cells_across = 256;

  [[nodiscard]] std::size_t pixels_corners() const {
    return static_cast<std::size_t>(job_.block.width + 1) *
           static_cast<std::size_t>(job_.block.height + 1);
  }

  [[nodiscard]] std::size_t pixels_corner(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(job_.block.width + 1) +
           static_cast<std::size_t>(x);
  }

  void take_pixels_corners() {
    resize(pixels_corners());
    for (int y = 0; y <= job_.block.height; ++y) {
      for (int x = 0; x <= job_.block.width; ++x)
        take({x << depth_, y << depth_}, 0, pixels_corner(x, y));
    }
    trace();
  }

  // Makes room for the samples of so many corners, and for their layers.
  void resize(std::size_t corners) {
    sums_.resize(corners);
    if (layers_.empty()) return;
    while (corner_layers_.size() > corners) corner_layers_.pop_back();
    corner_targets_.surfaces.resize(corner_layers_.size());
    corner_targets_.light.resize(corner_layers_.size());
    while (corner_layers_.size() < corners) corner_targets_.add(corner_layers_.emplace_back());
  }

  void trace() {
    sums_.trace();
    for (std::size_t i = shown_.size(); i < sums_.size(); ++i)
      shown_.push_back(
          display_rgb(glm::vec3(sums_.sum(i).radiance), {0.0f, job_.settings.judged_tone}));
    stopped_ |= job_.stop.stop_requested();
  }

  // Subdivides the pixels of a part of the block, level by level.
  void subdivide(PixelRect part) {
    finer_.clear();
    resize(pixels_corners());
    shown_.resize(pixels_corners());
    std::vector<CornerSquare> squares, quarters;
    for (int y = part.y; y < part.y + part.height; ++y) {
      for (int x = part.x; x < part.x + part.width; ++x) {
        squares.push_back({{x << depth_, y << depth_},
                           {pixels_corner(x, y), pixels_corner(x + 1, y), pixels_corner(x, y + 1),
                            pixels_corner(x + 1, y + 1)},
                           static_cast<std::size_t>(y * job_.block.width + x)});
      }
    }
    for (int level = 0; !squares.empty() && !stopped_; ++level) {
      quarters.clear();
      for (const CornerSquare& square : squares) {
        ++result_.statistics.pyrays_by_level[static_cast<std::size_t>(level)];
        const bool uneven = differ(square, level);
        if (uneven && level < depth_) {
          split(square, level, quarters);
        } else {
          finish(square, level, uneven);
        }
      }
      trace();
      squares.swap(quarters);
    }
  }

  void finish(const CornerSquare& square, int level, bool uneven) {
    const double area = std::ldexp(1.0, -2 * level);
    if (uneven) result_.statistics.unresolved_area += area;
    SampleSums::Sum all;
    for (const std::size_t i : square.samples) {
      const SampleSums::Sum sample = sums_.sum(i);
      all.radiance += sample.radiance;
      all.count += sample.count;
    }
    if (all.count == 0) return;
    sum_[square.pixel] += area * all.mean();
    area_[square.pixel] += area;
    if (layers_.empty()) return;
    LayerSum corners;
    for (const std::size_t i : square.samples) corners.add(corner_layers_[i], 1.0);
    layers_[square.pixel].add(corners, area);
  }

  // Splits a square into quarters, and samples their new corners.
  void split(const CornerSquare& square, int level, std::vector<CornerSquare>& quarters) {
    std::uint8_t& deepest = result_.tile.split_level[square.pixel];
    deepest = std::max(deepest, static_cast<std::uint8_t>(level + 1));
    const int half = 1 << (depth_ - level - 1);
    const auto at = [&](int i, int j) {
      return Corner{square.corner.x + i * half, square.corner.y + j * half};
    };
    const auto& [a, c, g, i] = square.samples;
    const std::size_t b = between(at(1, 0), level + 1), d = between(at(0, 1), level + 1),
                      e = between(at(1, 1), level + 1), f = between(at(2, 1), level + 1),
                      h = between(at(1, 2), level + 1);
    quarters.push_back({at(0, 0), {a, b, d, e}, square.pixel});
    quarters.push_back({at(1, 0), {b, c, e, f}, square.pixel});
    quarters.push_back({at(0, 1), {d, e, g, h}, square.pixel});
    quarters.push_back({at(1, 1), {e, f, h, i}, square.pixel});
  }

  // Returns the sample of a corner that is new at a level; takes it on the first request.
  [[nodiscard]] std::size_t between(Corner corner, int level) {
    const std::uint64_t key = std::uint64_t{static_cast<std::uint32_t>(corner.y)} << 32 |
                              static_cast<std::uint32_t>(corner.x);
    const auto [found, is_new] = finer_.try_emplace(key, sums_.size());
    if (is_new) {
      resize(sums_.size() + 1);
      take(corner, level, found->second);
    }
    return found->second;
  }

  // Returns whether a square's corners differ enough, or one of their rays may have missed a small
  // object.
  [[nodiscard]] bool differ(const CornerSquare& square, int level) const {
    glm::vec3 lo(1.0f), hi(0.0f);
    for (const std::size_t i : square.samples) {
      if (sums_.sum(i).count == 0) continue;
      lo = glm::min(lo, shown_[i]);
      hi = glm::max(hi, shown_[i]);
    }
    const glm::vec3 contrast = hi - lo;
    if (std::max({contrast.x, contrast.y, contrast.z}) > contrast_) return true;
    if (spheres_.empty()) return false;
    const int side = 1 << (depth_ - level);
    for (int i = 0; i < 4; ++i) {
      const glm::dvec2 p =
          place({square.corner.x + (i & 1) * side, square.corner.y + (i >> 1) * side});
      const Hit& hit = sums_.hit(square.samples[static_cast<std::size_t>(i)]);
      if (spheres_.missed(job_.view.ray(p.x, p.y), hit, job_.scene.world(), level)) return true;
    }
    return false;
  }

  // Takes a corner's sample, which depends on its position in the picture alone. Its footprint is a
  // square of the coarsest level that contains it, and its light samples are the first ones of that
  // level.
  void take(Corner corner, int level, std::size_t target) {
    const int last = 1 << depth_;
    const glm::dvec2 p = place(corner);
    PointSample sample{p, std::ldexp(1.0f, -level)};
    sample.x = job_.block.x + corner.x / last;
    sample.y = job_.block.y + corner.y / last;
    sample.index = rank(corner.x % last, corner.y % last);
    sample.target = target;
    if (!stopped_ && sums_.add(sample)) stopped_ = job_.stop.stop_requested();
  }

  // Returns the rank of a position in a pixel, coarser levels first, so that each level continues a
  // Sobol sequence over the lights.
  [[nodiscard]] int rank(int x, int y) const {
    int number = 0;
    for (int level = 1; level <= depth_; ++level) {
      const int bit = depth_ - level;
      number |= (((x >> bit) & 1) | ((y >> bit) & 1) << 1) << (2 * (level - 1));
    }
    return number;
  }

  [[nodiscard]] glm::dvec2 place(Corner corner) const {
    return {job_.block.x + std::ldexp(corner.x, -depth_),
            job_.block.y + std::ldexp(corner.y, -depth_)};
  }

  BlockResult publish() {
    BlockResult sampled = sums_.block({});
    result_.statistics += sampled.statistics;
    for (std::size_t i = 0; i < sum_.size(); ++i) {
      result_.tile.radiance.push_back(area_[i] > 0.0 ? glm::vec3(sum_[i] / area_[i])
                                                     : glm::vec3(0.0f));
      result_.statistics.split_pixels += result_.tile.split_level[i] > 0;
    }
    if (!layers_.empty()) result_.tile.layers = planes_of(layers_, job_.settings.layers);
    return std::move(result_);
  }

  BlockJob job_;
  int depth_;
  float contrast_;
  bool stopped_ = false;
  SobolSampler places_;
  SampleSums sums_;
  EnlargedSpheres spheres_;
  std::unordered_map<std::uint64_t, std::size_t> finer_;  // corners in pixels and on their sides
  std::vector<glm::vec3> shown_;                          // display intensities of the samples
  std::vector<glm::dvec3> sum_;
  std::vector<double> area_;
  std::vector<LayerSum> layers_;        // of each pixel; empty: none is asked for
  std::deque<LayerSum> corner_layers_;  // of each sample, at a fixed place
  LayerTargets corner_targets_;         // these
  BlockResult result_;
};

}  // namespace

/// Adaptive supersampling in image space (Whitted 1980; CGF'98 section 2.3). Samples lie at the
/// pixels' corners. A square is split into four if its corners differ by more than
/// `settings.sampling.contrast` in display intensity (by `settings.judged_tone`), in any channel,
/// down to `settings.sampling.depth`. A pixel is the mean of its squares' corners, by area. A
/// corner is shared by all squares around it. It samples one point of each light, which depends on
/// its position and the seed. With `settings.sampling.spheres` squares are also split if a corner's
/// ray passes through the EnlargedSpheres of an object that it misses.
BlockResult render_block_whitted(const BlockJob& job) {
  return AdaptiveBlock(job).run();
}

}  // namespace asos
