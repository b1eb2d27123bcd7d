#include "renderer/settings/settings.h"

#include "renderer/settings/setting_table.h"

#include <fmt/format.h>

#include <bit>

namespace asos {
namespace {

constexpr double max_dfr_exponent = 1e6;

/// Says which setting of the table is out of its range; empty: none.
Result<void> check_table(const RenderSettings& settings) {
  for (const SettingRow& row : setting_table()) {
    const double value = row.get(settings);
    // This form of the comparison is false for NaN.
    if (value >= row.lo && value <= row.hi) continue;
    if (row.kind == SettingKind::choice)
      return unexpected(Error{row.option, "is not one of the program's"});
    return unexpected(
        Error{row.option, fmt::format("{} is not from {} to {}", value, row.lo, row.hi)});
  }
  return {};
}

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
  if (const auto within = check_table(s); !within) return unexpected(within.error());
  if (s.shutter.camera < -1)
    return unexpected(Error{"shutter camera", fmt::format("{} is below -1", s.shutter.camera)});
  if (!std::has_single_bit(static_cast<unsigned>(s.asos.fat)))
    return unexpected(Error{"fat", fmt::format("{} is not 2, 4, 8 or 16", s.asos.fat)});
  if (s.method < Method::asos || s.method > last_method)
    return unexpected(Error{"method", "is not one of the program's"});
  if (s.judged_tone < ToneCurve::none || s.judged_tone > ToneCurve::agx)
    return unexpected(Error{"tone", "is not one of the program's"});
  for (const glm::vec3& colour : {s.background.top, s.background.bottom})
    for (int c = 0; c < 3; ++c)
      if (!(colour[c] >= 0.0f && colour[c] <= Background::brightest))
        return unexpected(Error{
            "background", fmt::format("{} is not from 0 to {}", colour[c], Background::brightest)});
  if (s.background.kind < BackgroundKind::environment ||
      s.background.kind > BackgroundKind::transparent)
    return unexpected(Error{"background", "is not one of the program's"});
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
