#include "renderer/study/ladders.h"

#include "renderer/comparison/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace asos {
namespace {

using Rungs = std::vector<LadderStep>;
using MakeRungs = Rungs (*)(const std::string& method, const RenderSettings& base);

std::optional<Method> method_called(const std::string& name) {
  for (const MethodRow& row : method_table())
    if (name == row.name) return row.value;
  return std::nullopt;
}

LadderStep make_rung(const std::string& method, const RenderSettings& base) {
  LadderStep rung{method, "", method, base};
  if (const auto known = method_called(method)) rung.settings.method = *known;
  return rung;
}

Rungs levels(const std::string& method, const RenderSettings& base, double eps) {
  Rungs rungs;
  for (int level = 1; level <= 5; ++level) rungs.push_back(asos_rung(method, base, level, eps));
  return rungs;
}

/// Returns EPS from 1/8 to 1/2048 at the default MAX.
Rungs asos_rungs(const std::string& method, const RenderSettings& base) {
  Rungs rungs;
  const int max_level = AsosSettings{}.max_level;
  for (double inverse = 8.0; inverse <= 2048.0; inverse *= 2.0)
    rungs.push_back(asos_rung(method, base, max_level, 1.0 / inverse));
  for (LadderStep& rung : rungs) rung.curve = method;
  return rungs;
}

Rungs published_rungs(const std::string& method, const RenderSettings& base) {
  return levels(method, base, 1.0 / 256.0);
}

Rungs sample_rungs(const std::string& method, const RenderSettings& base) {
  Rungs rungs;
  for (const int spp : {1, 4, 16, 64, 256}) rungs.push_back(sampling_rung(method, base, spp));
  return rungs;
}

Rungs one_rung(const std::string& method, const RenderSettings& base) {
  LadderStep rung = make_rung(method, base);
  rung.setting = "fixed";
  return {rung};
}

/// Returns steps in which smaller and smaller differences between corners split squares deeper and
/// deeper; with and without the enlarged bounding spheres.
Rungs whitted_rungs(const std::string& method, const RenderSettings& base) {
  Rungs rungs;
  for (const bool spheres : {false, true}) {
    double contrast = 0.2;
    for (int depth = 1; depth <= 5; ++depth, contrast *= 0.5) {
      LadderStep& rung = rungs.emplace_back(make_rung(method, base));
      const char* with = spheres ? " spheres" : "";
      rung.setting = fmt::format("contrast {} depth {}{}", contrast, depth, with);
      rung.curve = method + with;
      rung.settings.sampling.contrast = contrast;
      rung.settings.sampling.depth = depth;
      rung.settings.sampling.spheres = spheres;
    }
  }
  return rungs;
}

/// More than four samples, since the first level takes four.
Rungs two_level_rungs(const std::string& method, const RenderSettings& base) {
  Rungs rungs;
  for (const int spp : {8, 16, 32, 64, 256}) rungs.push_back(sampling_rung(method, base, spp));
  return rungs;
}

/// Returns steps that halve the allowed error. MAX is larger than the first of these need.
Rungs adaptive_rungs(const std::string& method, const RenderSettings& base) {
  Rungs rungs;
  for (const double inverse : {8.0, 16.0, 32.0, 64.0, 128.0, 256.0})
    rungs.push_back(asos_rung(method, base, 5, 1.0 / inverse));
  for (LadderStep& rung : rungs) rung.curve = method;
  return rungs;
}

/// A method, the function that makes its ladder, and whether a study without named methods includes
/// it.
struct Ladder {
  const char* method;
  MakeRungs make;
  bool by_default;
};

// clang-format off
constexpr Ladder all_ladders[] = {
    {"asos", asos_rungs, true},
    {"asos-published", published_rungs, true},
    {"uniform", sample_rungs, true},
    {"stochastic", sample_rungs, true},
    {"sobol", sample_rungs, true},
    {"sobol-adaptive", adaptive_rungs, true},
    {"whitted", whitted_rungs, true},
    {"mitchell", two_level_rungs, true},
    {"ray-bound", sample_rungs, true},
    {"average", one_rung, true},
    {"beam", one_rung, false},
    {"cone", one_rung, false},
    {"covers", one_rung, false},
    {"mask", one_rung, false},
};
// clang-format on

std::vector<std::string> methods_where(bool all) {
  std::vector<std::string> names;
  for (const Ladder& ladder : all_ladders)
    if ((all || ladder.by_default) && method_called(ladder.method)) names.push_back(ladder.method);
  return names;
}

}  // namespace

std::vector<std::string> ladder_methods() {
  return methods_where(true);
}

std::vector<std::string> default_methods() {
  return methods_where(false);
}

Result<std::vector<LadderStep>> ladder_of(const std::string& method, const RenderSettings& base) {
  for (const Ladder& ladder : all_ladders)
    if (method == ladder.method && method_called(method)) return ladder.make(method, base);
  std::string known;
  for (const std::string& name : ladder_methods()) known += (known.empty() ? "" : ", ") + name;
  return unexpected(Error{fmt::format("\"{}\"", method), "not one of " + known});
}

Result<LadderStep> watched_rung(const std::string& method, const RenderSettings& base) {
  constexpr int most_samples = 256;
  const auto ladder = ladder_of(method, base);
  if (!ladder) return unexpected(ladder.error());
  const AsosSettings usual;
  const auto watched = [&](const LadderStep& rung) {
    const RenderSettings& settings = rung.settings;
    if (settings.method == Method::asos)
      return settings.asos.eps == usual.eps && settings.asos.max_level == usual.max_level;
    return row_of(settings.method).samples == SampleCount::none ||
           settings.sampling.spp <= most_samples;
  };
  const auto found = std::find_if(ladder->rbegin(), ladder->rend(), watched);
  return found != ladder->rend() ? *found : ladder->back();
}

LadderStep asos_rung(const std::string& method, const RenderSettings& base, int max_level,
                     double eps) {
  LadderStep rung = make_rung(method, base);
  rung.setting = fmt::format("MAX {} EPS {}", max_level, eps_text(eps));
  if (base.texture.resolution > 1) rung.setting += fmt::format(" TR {}", base.texture.resolution);
  rung.curve = fmt::format("{} EPS {}", method, eps_text(eps));
  rung.settings.asos.max_level = max_level;
  rung.settings.asos.eps = eps;
  return rung;
}

LadderStep sampling_rung(const std::string& method, const RenderSettings& base, int spp) {
  LadderStep rung = make_rung(method, base);
  rung.setting = fmt::format("{} spp", spp);
  rung.settings.sampling.spp = spp;
  return rung;
}

std::string eps_text(double eps) {
  const double inverse = 1.0 / eps;
  if (eps > 0.0 && eps < 1.0 && inverse == std::floor(inverse)) return fmt::format("1/{}", inverse);
  return fmt::format("{}", eps);
}

}  // namespace asos
