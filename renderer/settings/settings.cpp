#include "renderer/settings/settings.h"

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
  settings.asos.leaf = LeafKind::point;
  settings.asos.rule = StoppingRule::published;
  settings.asos.detect = Detection::cone;
  settings.asos.refine_shading = false;
  settings.judged_tone = ToneCurve::none;
  // "Our current implementation uses this method" (CGF'98 section 4.3.2).
  settings.shadow.quality = ShadowQuality::extended;
  settings.shadow.light_rule = LightRule::published;
  return settings;
}

Result<RenderSettings> validated(const RenderSettings& s) {
  for (const Range& r : {Range{"width", s.width, 1, max_side},
                         {"height", s.height, 1, max_side},
                         {"max", s.asos.max_level, 0, max_level_limit},
                         {"spp", s.sampling.spp, 1, max_spp},
                         {"depth", s.sampling.depth, 0, max_level_limit},
                         {"threads", s.threads, 0, max_threads},
                         {"fat", s.asos.fat, 2, 16},
                         {"tr", s.texture.resolution, 1, TextureSettings::max_resolution},
                         {"shadow-divisions", s.shadow.divisions, 1, 16},
                         {"bounces", s.shadow.bounces, 0, 1},
                         {"reflections", s.mirror.bounces, 0, MirrorSettings::max_bounces},
                         {"shutter camera", s.shutter.camera, -1, std::numeric_limits<int>::max()},
                         {"seed", s.seed, 0, std::numeric_limits<int>::max()}}) {
    if (r.value < r.lo || r.value > r.hi) {
      return unexpected(Error{r.name, fmt::format("{} is not from {} to {}", r.value, r.lo, r.hi)});
    }
  }
  for (const RealRange& r :
       {RealRange{"eps", s.asos.eps, 1.0},
        {"contrast", s.sampling.contrast, 1.0},
        {"roughest-mirror", s.mirror.roughest, 1.0},
        {"mirror-angle", s.mirror.widest_angle_deg, 180.0},
        {"shutter", s.shutter.seconds, ShutterSettings::longest},
        {"line-width", s.line_width, RenderSettings::max_line_width},
        {"filter-width", s.filter_width, RenderSettings::max_filter_width, 1.0},
        {"contrast-scale", s.sampling.contrast_scale, SamplingSettings::max_contrast_scale}}) {
    // This form of the comparison is false for NaN.
    if (!(r.value >= r.lo && r.value <= r.hi)) {
      return unexpected(Error{r.name, fmt::format("{} is not from {} to {}", r.value, r.lo, r.hi)});
    }
  }
  if (!std::has_single_bit(static_cast<unsigned>(s.asos.fat)))
    return unexpected(Error{"fat", fmt::format("{} is not 2, 4, 8 or 16", s.asos.fat)});
  if (s.method < Method::asos || s.method > last_method)
    return unexpected(Error{"method", "is not one of the program's"});
  if (s.judged_tone < ToneCurve::none || s.judged_tone > ToneCurve::agx)
    return unexpected(Error{"tone", "is not one of the program's"});
  if (s.asos.leaf != LeafKind::exact && s.asos.leaf != LeafKind::point) {
    return unexpected(Error{"leaf", "is neither exact nor point"});
  }
  if (s.asos.rule != StoppingRule::unresolved && s.asos.rule != StoppingRule::published) {
    return unexpected(Error{"rule", "is neither unresolved nor published"});
  }
  if (s.asos.detect != Detection::square && s.asos.detect != Detection::cone) {
    return unexpected(Error{"detect", "is neither square nor cone"});
  }
  if (s.texture.filter != TextureFilter::footprint && s.texture.filter != TextureFilter::point) {
    return unexpected(Error{"texture-filter", "is neither footprint nor point"});
  }
  if (s.shadow.quality < ShadowQuality::refined ||
      s.shadow.quality > ShadowQuality::extended_adaptive)
    return unexpected(Error{"shadow-quality", "is not one of the program's"});
  for (const glm::vec3& colour : {s.background.top, s.background.bottom})
    for (int c = 0; c < 3; ++c)
      if (!(colour[c] >= 0.0f && colour[c] <= Background::brightest))
        return unexpected(Error{
            "background", fmt::format("{} is not from 0 to {}", colour[c], Background::brightest)});
  if (s.background.kind < BackgroundKind::environment ||
      s.background.kind > BackgroundKind::transparent)
    return unexpected(Error{"background", "is not one of the program's"});
  if (s.ground < Ground::off || s.ground > Ground::mirror)
    return unexpected(Error{"ground", "is not one of the program's"});
  if (s.mirror.dfr) {
    const auto within = [](double x, double hi) { return x >= 0.0 && x <= hi; };
    for (const DfrCurve& c : s.mirror.dfr->rgb) {
      if (!within(c.min, 1.0) || !within(c.max, 1.0) || !within(c.exponent, max_dfr_exponent))
        return unexpected(Error{"dfr", fmt::format("{},{},{} is not from 0 to 1, 0 to 1, 0 to {}",
                                                   c.min, c.max, c.exponent, max_dfr_exponent)});
    }
    if (!within(s.mirror.dfr->perturbation, 1.0))
      return unexpected(Error{"dfr", "its perturbation is not from 0 to 1"});
  }
  if (s.mirror.curved < CurvedMirror::approximate || s.mirror.curved > CurvedMirror::adaptive)
    return unexpected(Error{"curved-mirror", "is not one of the program's"});
  if (s.shadow.light_rule != LightRule::physical && s.shadow.light_rule != LightRule::published) {
    return unexpected(Error{"light-rule", "is neither physical nor published"});
  }
  if (s.crop == PixelRect{}) return s;
  const PixelRect c = s.crop;
  const auto name = [&] { return fmt::format("{},{},{},{}", c.x, c.y, c.width, c.height); };
  if (c.empty()) return unexpected(Error{"crop", name() + " is empty"});
  // Compare differences, which cannot overflow.
  if (c.x < 0 || c.y < 0 || c.width > s.width - c.x || c.height > s.height - c.y) {
    return unexpected(Error{"crop", fmt::format("{} does not lie within the picture of {} x {}",
                                                name(), s.width, s.height)});
  }
  return s;
}

}  // namespace asos
