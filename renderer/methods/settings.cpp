#include "renderer/methods/settings.h"

#include "renderer/methods/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

namespace asos {
namespace {

constexpr int max_side = 32768;
constexpr int max_spp = 65536;
constexpr int max_threads = 1024;
constexpr double max_dfr_exponent = 1e6;

struct Range {
  const char* name;
  int value;
  int lo;
  int hi;
};

struct RealRange {
  const char* name;
  double value;
  double hi;
  double lo = 0.0;
};

}  // namespace

RenderSettings as_published(RenderSettings settings) {
  if (settings.method != Method::asos_published) return settings;
  settings.leaf = Leaf::point;
  settings.rule = StoppingRule::published;
  settings.detect = Detection::cone;
  settings.refine_shading = false;
  // "Our current implementation uses this method" (CGF'98 section 4.3.2).
  settings.shadow_quality = ShadowQuality::extended;
  settings.light_rule = LightRule::published;
  return settings;
}

int block_side(const RenderSettings& settings) {
  switch (settings.method) {
    case Method::asos:
    case Method::asos_published:
      return std::max(block_size, settings.fat);
    case Method::whitted:
    case Method::average:
      return shared_block_size;
    default:
      return block_size;
  }
}

Result<RenderSettings> validated(const RenderSettings& s) {
  for (const Range& r : {Range{"width", s.width, 1, max_side},
                         {"height", s.height, 1, max_side},
                         {"max", s.max_level, 0, RenderSettings::max_level_limit},
                         {"spp", s.spp, 1, max_spp},
                         {"depth", s.depth, 0, RenderSettings::max_level_limit},
                         {"threads", s.threads, 0, max_threads},
                         {"fat", s.fat, 2, 16},
                         {"tr", s.texture_resolution, 1, RenderSettings::max_texture_resolution},
                         {"shadow-divisions", s.shadow_divisions, 1, 16},
                         {"reflections", s.reflections, 0, RenderSettings::max_reflections},
                         {"seed", s.seed, 0, std::numeric_limits<int>::max()}}) {
    if (r.value < r.lo || r.value > r.hi) {
      return unexpected(Error{r.name, fmt::format("{} is not from {} to {}", r.value, r.lo, r.hi)});
    }
  }
  for (const RealRange& r :
       {RealRange{"eps", s.eps, 1.0},
        {"contrast", s.contrast, 1.0},
        {"roughest-mirror", s.roughest_mirror, 1.0},
        {"mirror-angle", s.mirror_angle, 180.0},
        {"filter-width", s.filter_width, RenderSettings::max_filter_width, 1.0},
        {"contrast-scale", s.contrast_scale, RenderSettings::max_contrast_scale}}) {
    // The comparison is written so that NaN fails it.
    if (!(r.value >= r.lo && r.value <= r.hi)) {
      return unexpected(Error{r.name, fmt::format("{} is not from {} to {}", r.value, r.lo, r.hi)});
    }
  }
  if (!std::has_single_bit(static_cast<unsigned>(s.fat)))
    return unexpected(Error{"fat", fmt::format("{} is not 2, 4, 8 or 16", s.fat)});
  if (s.method < Method::asos || s.method > Method::beam)
    return unexpected(Error{"method", "is not one of the program's"});
  if (s.leaf != Leaf::exact && s.leaf != Leaf::point) {
    return unexpected(Error{"leaf", "is neither exact nor point"});
  }
  if (s.rule != StoppingRule::unresolved && s.rule != StoppingRule::published) {
    return unexpected(Error{"rule", "is neither unresolved nor published"});
  }
  if (s.detect != Detection::square && s.detect != Detection::cone) {
    return unexpected(Error{"detect", "is neither square nor cone"});
  }
  if (s.texture_filter != TextureFilter::footprint && s.texture_filter != TextureFilter::point) {
    return unexpected(Error{"texture-filter", "is neither footprint nor point"});
  }
  if (s.shadow_quality < ShadowQuality::refined ||
      s.shadow_quality > ShadowQuality::extended_adaptive)
    return unexpected(Error{"shadow-quality", "is not one of the program's"});
  if (s.dfr) {
    const auto within = [](double x, double hi) { return x >= 0.0 && x <= hi; };
    for (const DfrCurve& c : s.dfr->rgb) {
      if (!within(c.min, 1.0) || !within(c.max, 1.0) || !within(c.exponent, max_dfr_exponent))
        return unexpected(Error{"dfr", fmt::format("{},{},{} is not from 0 to 1, 0 to 1, 0 to {}",
                                                   c.min, c.max, c.exponent, max_dfr_exponent)});
    }
    if (!within(s.dfr->perturbation, 1.0))
      return unexpected(Error{"dfr", "its perturbation is not from 0 to 1"});
  }
  if (s.curved_mirror < CurvedMirror::approximate || s.curved_mirror > CurvedMirror::adaptive)
    return unexpected(Error{"curved-mirror", "is not one of the program's"});
  if (s.light_rule != LightRule::physical && s.light_rule != LightRule::published) {
    return unexpected(Error{"light-rule", "is neither physical nor published"});
  }
  if (s.crop == PixelRect{}) return s;
  const PixelRect c = s.crop;
  const auto name = [&] { return fmt::format("{},{},{},{}", c.x, c.y, c.width, c.height); };
  if (c.empty()) return unexpected(Error{"crop", name() + " is empty"});
  // Written as differences, which cannot overflow.
  if (c.x < 0 || c.y < 0 || c.width > s.width - c.x || c.height > s.height - c.y) {
    return unexpected(Error{"crop", fmt::format("{} does not lie within the picture of {} x {}",
                                                name(), s.width, s.height)});
  }
  return s;
}

}  // namespace asos
