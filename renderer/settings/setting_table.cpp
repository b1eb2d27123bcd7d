#include "renderer/settings/setting_table.h"

#include "renderer/settings/names.h"
#include "renderer/settings/value_text.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace asos {
namespace {

constexpr int max_side = 32768;
constexpr int max_spp = 65536;
constexpr int max_threads = 1024;
constexpr int largest_int = std::numeric_limits<int>::max();

/// Makes a row for the member that `Member`, a lambda without captures, returns by reference.
template <typename Member>
SettingRow row(const char* key, const char* option, Member /*member*/, double lo, double hi,
               const char* about) {
  using Value = std::remove_reference_t<decltype(Member{}(std::declval<RenderSettings&>()))>;
  SettingRow made;
  made.key = key;
  made.option = option;
  made.kind = std::is_same_v<Value, bool>  ? SettingKind::flag
              : std::is_same_v<Value, int> ? SettingKind::whole
              : std::is_enum_v<Value>      ? SettingKind::choice
                                           : SettingKind::number;
  made.lo = lo;
  made.hi = hi;
  made.about = about;
  made.get = [](const RenderSettings& s) { return static_cast<double>(Member{}(s)); };
  made.set = [](RenderSettings& s, double value) {
    if constexpr (std::is_enum_v<Value>)
      Member{}(s) = static_cast<Value>(static_cast<int>(value));
    else
      Member{}(s) = static_cast<Value>(value);
  };
  return made;
}

template <typename Member>
SettingRow flag(const char* key, const char* option, Member member, const char* about) {
  return row(key, option, member, 0.0, 1.0, about);
}

/// `names` holds each value from 0 on once.
template <typename Member, typename Names>
SettingRow choice(const char* key, const char* option, Member member, const Names& names,
                  const char* about) {
  SettingRow made = row(key, option, member, 0.0, static_cast<double>(names.size()) - 1.0, about);
  made.names.resize(names.size());
  for (const auto& name : names) made.names.at(static_cast<std::size_t>(name.value)) = name.name;
  return made;
}

std::vector<SettingRow> asos_rows() {
  return {
      row(
          "max_level", "max", [](auto& s) -> auto& { return s.asos.max_level; }, 0, max_level_limit,
          "MAX, the deepest level, 0 to 8: cells of 1/2^K pixel with at most 4 samples each; "
          "sobol-adaptive: at most 4^(K+1) samples per pixel"),
      row(
          "eps", "eps", [](auto& s) -> auto& { return s.asos.eps; }, 0, 1,
          "EPS, the allowed error of a pixel's display intensity, 0 to 1; sobol-adaptive: the "
          "standard error"),
      choice(
          "leaf", "leaf", [](auto& s) -> auto& { return s.asos.leaf; }, leaf_names,
          "Cell shading: exact (cut along edges) or point (one sample)"),
      choice(
          "rule", "rule", [](auto& s) -> auto& { return s.asos.rule; }, rule_names,
          "When to stop splitting: unresolved (unresolved area <= EPS) or published (L / 2^2K "
          "<= EPS for each object)"),
      choice(
          "detect", "detect", [](auto& s) -> auto& { return s.asos.detect; }, detection_names,
          "Edge test: square (the pixel) or cone (the cone around it)"),
      row(
          "fat", "fat", [](auto& s) -> auto& { return s.asos.fat; }, 2, 16,
          "Block size for the edge search in pixels: 2, 4, 8 or 16"),
      flag(
          "refine_shading", "no-shading-refinement",
          [](auto& s) -> auto& { return s.asos.refine_shading; },
          "Split for varying shading, not at edges only"),
      row(
          "filter_width", "filter-width", [](auto& s) -> auto& { return s.filter_width; }, 1,
          RenderSettings::max_filter_width,
          "Width of the box filter in pixels, 1 to 4 (CGF'98 section 3)"),
      flag(
          "jitter", "jitter", [](auto& s) -> auto& { return s.asos.jitter; },
          "Jitter the samples of cells unresolved at MAX"),
  };
}

std::vector<SettingRow> sampling_rows() {
  return {
      row(
          "spp", "spp", [](auto& s) -> auto& { return s.sampling.spp; }, 1, max_spp,
          "Samples per pixel of sobol and, at high contrast, mitchell; rounded up to a square for "
          "uniform, stochastic and ray-bound"),
      row(
          "contrast", "contrast", [](auto& s) -> auto& { return s.sampling.contrast; }, 0, 1,
          "whitted: contrast above which a square is split, display intensity 0 to 1"),
      row(
          "depth", "depth", [](auto& s) -> auto& { return s.sampling.depth; }, 0, max_level_limit,
          "whitted: deepest level, 0 to 8"),
      flag(
          "spheres", "spheres", [](auto& s) -> auto& { return s.sampling.spheres; },
          "whitted: also split where a ray misses an object but hits its enlarged sphere"),
      row(
          "contrast_scale", "contrast-scale",
          [](auto& s) -> auto& { return s.sampling.contrast_scale; }, 0,
          SamplingSettings::max_contrast_scale,
          "mitchell: scale of the contrast thresholds 0.4, 0.3, 0.6 (red, green, blue); 0 (high "
          "density everywhere) to 4 (nowhere)"),
      choice(
          "texture_filter", "texture-filter", [](auto& s) -> auto& { return s.texture.filter; },
          texture_filter_names,
          "Texture filter: footprint (averages textures and highlights over the area of a "
          "sample) or point (single points)"),
      row(
          "texture_resolution", "tr", [](auto& s) -> auto& { return s.texture.resolution; }, 1,
          TextureSettings::max_resolution,
          "TR, 1 to 8: N x N texture samples per pixel without edges (CGF'98 section 3.2)"),
  };
}

std::vector<SettingRow> light_rows() {
  return {
      flag(
          "shadows", "no-shadows", [](auto& s) -> auto& { return s.shadow.cast; },
          "Lights cast shadows"),
      choice(
          "shadow_quality", "shadow-quality", [](auto& s) -> auto& { return s.shadow.quality; },
          shadow_quality_names,
          "Method for soft shadows: refined (one look at the light, split where it varies), "
          "centre, supersampling, forced, extended, extended-divided or extended-adaptive "
          "(CGF'98 sections 4.2 to 4.3.4)"),
      row(
          "shadow_divisions", "shadow-divisions",
          [](auto& s) -> auto& { return s.shadow.divisions; }, 1, 16,
          "Divisions of a patch per side, for the qualities that divide it: 1 to 16"),
      choice(
          "light_rule", "light-rule", [](auto& s) -> auto& { return s.shadow.light_rule; },
          light_rule_names,
          "Light of area lights: physical (closed forms) or published (I A cos theta with "
          "inverse square at each cell)"),
      row(
          "reflections", "reflections", [](auto& s) -> auto& { return s.mirror.bounces; }, 0,
          MirrorSettings::max_bounces, "Maximum mirror and refraction bounces, 0 (none) to 64"),
      row(
          "roughest_mirror", "roughest-mirror", [](auto& s) -> auto& { return s.mirror.roughest; },
          0, 1,
          "Largest roughness that reflects the scene, 0 to 1; rougher surfaces reflect the mean "
          "sky"),
      choice(
          "curved_mirror", "curved-mirror", [](auto& s) -> auto& { return s.mirror.curved; },
          curved_mirror_names,
          "Reflection on curved mirrors: approximate (nearest pyramid), tangent (tangent "
          "plane), supersample (split to MAX first) or adaptive (split where rays diverge; "
          "CGF'98 section 5.2)"),
      row(
          "mirror_angle", "mirror-angle",
          [](auto& s) -> auto& { return s.mirror.widest_angle_deg; }, 0, 180,
          "Largest angle of a reflected pyramid on curved shapes, 0 to 180 degrees; meshes use an "
          "eighth of it"),
  };
}

std::vector<SettingRow> newer_rows() {
  std::vector<SettingRow> rows{
      flag(
          "sky_shadows", "sky-shadows", [](auto& s) -> auto& { return s.shadow.sky; },
          "Ambient occlusion: objects block sky light (slower)"),
      row(
          "bounces", "bounces", [](auto& s) -> auto& { return s.shadow.bounces; }, 0, 1,
          "Bounces of indirect diffuse light, 0 or 1; includes ambient occlusion (slower)"),
      row(
          "line_width", "line-width", [](auto& s) -> auto& { return s.line_width; }, 0,
          RenderSettings::max_line_width, "Width of lines and points in pixels, 0 (hidden) to 16"),
      choice(
          "ground", "ground", [](auto& s) -> auto& { return s.ground; }, ground_names,
          "Ground plane: off, on (catches shadows) or mirror (also reflects)"),
      row(
          "shutter_seconds", "shutter", [](auto& s) -> auto& { return s.shutter.seconds; }, 0,
          ShutterSettings::longest,
          "Motion blur: how long the shutter is open around the picture's time, in seconds"),
  };
  for (SettingRow& row : rows) row.saved = Saved::unless_usual;
  return rows;
}

std::vector<SettingRow> all_rows() {
  std::vector<SettingRow> rows{
      row(
          "width", "width", [](auto& s) -> auto& { return s.width; }, 1, max_side,
          "Width of the picture in pixels"),
      row(
          "height", "height", [](auto& s) -> auto& { return s.height; }, 1, max_side,
          "Height of the picture in pixels"),
  };
  const auto add = [&](std::vector<SettingRow> more) {
    for (SettingRow& row : more) rows.push_back(std::move(row));
  };
  add(asos_rows());
  add(sampling_rows());
  add(light_rows());
  add({flag(
           "cull", "no-culling", [](auto& s) -> auto& { return s.cull; },
           "Hide the backs of single-sided materials, as glTF says"),
       row(
           "seed", "seed", [](auto& s) -> auto& { return s.seed; }, 0, largest_int,
           "Seed of the noise of sobol, sobol-adaptive, mitchell, whitted and average")});
  add(newer_rows());
  rows.push_back(row(
      "threads", "threads", [](auto& s) -> auto& { return s.threads; }, 0, max_threads,
      "Worker threads, 1 to 1024; 0: one for each core"));
  rows.back().saved = Saved::never;
  return rows;
}

}  // namespace

std::span<const SettingRow> setting_table() {
  static const std::vector<SettingRow> rows = all_rows();
  return rows;
}

const SettingRow* find_setting(std::string_view key) {
  for (const SettingRow& row : setting_table())
    if (key == row.key) return &row;
  return nullptr;
}

const SettingRow& setting_of_option(std::string_view option) {
  for (const SettingRow& row : setting_table())
    if (option == row.option) return row;
  throw std::logic_error(fmt::format("no setting has the option {}", option));
}

std::string SettingRow::text_of(double value) const {
  switch (kind) {
    case SettingKind::flag:
      return name_in(on_off_names, value != 0.0);
    case SettingKind::choice:
      return names.at(static_cast<std::size_t>(value));
    case SettingKind::whole:
    case SettingKind::number:
      break;
  }
  return fmt::format("{}", value);
}

Result<double> SettingRow::parse(std::string_view text) const {
  const auto as_double = [](auto value) { return static_cast<double>(value); };
  switch (kind) {
    case SettingKind::flag:
      return parse_name(text, std::span(on_off_names)).map(as_double);
    case SettingKind::whole:
      return parse_whole(text, static_cast<int>(lo), static_cast<int>(hi)).map(as_double);
    case SettingKind::number:
      return parse_number(text, lo, hi);
    case SettingKind::choice:
      break;
  }
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (text == names[i]) return static_cast<double>(i);
    all += (all.empty() ? "" : ", ") + std::string(names[i]);
  }
  return unexpected(Error{fmt::format("\"{}\"", text), "not one of " + all});
}

}  // namespace asos
