#pragma once

#include "renderer/film/split_map.h"
#include "renderer/settings/settings.h"

#include <array>

namespace asos {

/// The name of a value on the command line, in statistics and in pictures' texts. The names of
/// methods are in method_table (renderer/comparison/method.h).
template <typename T>
struct Named {
  const char* name;
  T value;
};

inline constexpr std::array on_off_names{
    Named<bool>{"on", true},
    Named<bool>{"off", false},
};
inline constexpr std::array leaf_names{
    Named<LeafKind>{"exact", LeafKind::exact},
    Named<LeafKind>{"point", LeafKind::point},
};
inline constexpr std::array rule_names{
    Named<StoppingRule>{"unresolved", StoppingRule::unresolved},
    Named<StoppingRule>{"published", StoppingRule::published},
};
inline constexpr std::array detection_names{
    Named<Detection>{"square", Detection::square},
    Named<Detection>{"cone", Detection::cone},
};
inline constexpr std::array texture_filter_names{
    Named<TextureFilter>{"footprint", TextureFilter::footprint},
    Named<TextureFilter>{"point", TextureFilter::point},
};
inline constexpr std::array curved_mirror_names{
    Named<CurvedMirror>{"approximate", CurvedMirror::approximate},
    Named<CurvedMirror>{"tangent", CurvedMirror::tangent},
    Named<CurvedMirror>{"supersample", CurvedMirror::supersample},
    Named<CurvedMirror>{"adaptive", CurvedMirror::adaptive},
};

inline constexpr std::array shadow_quality_names{
    Named<ShadowQuality>{"refined", ShadowQuality::refined},
    Named<ShadowQuality>{"centre", ShadowQuality::centre},
    Named<ShadowQuality>{"supersampling", ShadowQuality::supersampling},
    Named<ShadowQuality>{"forced", ShadowQuality::forced},
    Named<ShadowQuality>{"extended", ShadowQuality::extended},
    Named<ShadowQuality>{"extended-divided", ShadowQuality::extended_divided},
    Named<ShadowQuality>{"extended-adaptive", ShadowQuality::extended_adaptive},
};
inline constexpr std::array light_rule_names{
    Named<LightRule>{"physical", LightRule::physical},
    Named<LightRule>{"published", LightRule::published},
};

inline constexpr std::array split_map_names{
    Named<SplitMapColours>{"level", SplitMapColours::level},
    Named<SplitMapColours>{"cause", SplitMapColours::cause},
    Named<SplitMapColours>{"rays", SplitMapColours::rays},
    Named<SplitMapColours>{"time", SplitMapColours::time},
};

inline constexpr std::array background_names{
    Named<BackgroundKind>{"environment", BackgroundKind::environment},
    Named<BackgroundKind>{"blurred", BackgroundKind::blurred},
    Named<BackgroundKind>{"colours", BackgroundKind::colours},
    Named<BackgroundKind>{"transparent", BackgroundKind::transparent},
};
inline constexpr std::array ground_names{
    Named<Ground>{"off", Ground::off},
    Named<Ground>{"on", Ground::on},
    Named<Ground>{"mirror", Ground::mirror},
};

inline constexpr std::array needs_names{
    Named<FeatureChoice>{"scene", FeatureChoice::scene},
    Named<FeatureChoice>{"all", FeatureChoice::all},
};

/// Returns the name of `value` in `names`.
template <typename Names, typename T>
[[nodiscard]] constexpr const char* name_in(const Names& names, T value) {
  for (const auto& named : names)
    if (named.value == value) return named.name;
  return "";
}

}  // namespace asos
