#include "renderer/study/analysis.h"

#include "renderer/study/reference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

constexpr const char* subject = "asos";

/// Largest extrapolation of a rival's last step, as a factor of its longest measured time.
constexpr double furthest = 16.0;

// A method has levelled off if two doublings of its time leave at least this fraction of its error.
// For random samples it is a half.
constexpr double levelled_share = 0.9;

template <typename Get>
double median_of(const std::vector<Cost>& costs, Get get) {
  std::vector<double> values;
  for (const Cost& cost : costs) values.push_back(get(cost));
  return values.empty() ? 0.0 : median(std::move(values));
}

/// Returns the quotable points that satisfy `wanted`.
template <typename Wanted>
std::vector<CurvePoint> quotable(const SceneStudy& study, Wanted wanted) {
  std::vector<CurvePoint> points;
  for (const StudyPoint& p : study.points)
    if (!p.under_floor && wanted(p) && p.seconds() > 0.0 && p.measures.rmse > 0.0)
      points.push_back({p.seconds(), p.measures.rmse});
  return points;
}

std::vector<CurvePoint> front_of(const SceneStudy& study, const std::string& method) {
  return pareto_front(
      quotable(study, [&](const StudyPoint& p) { return p.rung.method == method; }));
}

/// Returns the names without repeats, in order.
template <typename Get>
std::vector<std::string> names_in(const SceneStudy& study, Get get) {
  std::vector<std::string> names;
  for (const StudyPoint& p : study.points)
    if (std::find(names.begin(), names.end(), get(p)) == names.end()) names.push_back(get(p));
  return names;
}

void mark_best(SceneStudy& study) {
  for (StudyPoint& p : study.points) {
    p.under_floor = p.measures.rmse < study.floor;
    p.best = std::none_of(study.points.begin(), study.points.end(), [&](const StudyPoint& other) {
      return other.rung.method == p.rung.method && &other != &p && other.seconds() <= p.seconds() &&
             other.measures.rmse <= p.measures.rmse &&
             (other.seconds() < p.seconds() || other.measures.rmse < p.measures.rmse);
    });
  }
}

/// Returns whether the best error of a method hardly falls over the last two doublings of its time.
bool levels_off(const SceneStudy& study, const std::string& method) {
  const auto points = quotable(study, [&](const StudyPoint& p) { return p.rung.method == method; });
  double longest = 0.0;
  for (const CurvePoint& p : points) longest = std::max(longest, p.seconds);
  double before = std::numeric_limits<double>::infinity();
  double in_all = before;
  for (const CurvePoint& p : points) {
    in_all = std::min(in_all, p.error);
    if (4.0 * p.seconds <= longest) before = std::min(before, p.error);
  }
  return std::isfinite(before) && in_all > levelled_share * before;
}

std::optional<ResidualBias> bias_of(const SceneStudy& study) {
  const StudyPoint* best = nullptr;
  for (const StudyPoint& p : study.points) {
    if (p.rung.method == subject && (!best || p.measures.rmse < best->measures.rmse)) best = &p;
  }
  if (!best || best->under_floor) return std::nullopt;
  const double rmse = best->measures.rmse;
  return ResidualBias{std::sqrt(std::max(0.0, rmse * rmse - study.noise * study.noise)),
                      levels_off(study, subject), best->rung.setting};
}

/// A method's best settings, and whether its error has levelled off.
struct Rival {
  std::vector<CurvePoint> front;
  bool levelled = false;
};
Rival rival_of(const SceneStudy& study, const std::string& method) {
  return {front_of(study, method), levels_off(study, method)};
}

struct Read {
  double value = 0.0;
  Reading reading = Reading::measured;
};

/// Returns a rival's seconds at an error. If its quickest setting is already better, returns that
/// setting's time, since no setting is quicker.
std::optional<Read> rival_seconds(const Rival& rival, double error) {
  const std::vector<CurvePoint>& front = rival.front;
  if (!front.empty() && front.front().error <= error)
    return Read{front.front().seconds,
                front.front().error == error ? Reading::measured : Reading::cheapest};
  if (front.empty()) return std::nullopt;
  const double longest = front.back().seconds;
  if (rival.levelled && error < front.back().error) return Read{longest, Reading::levelled};
  const auto value = seconds_at_error(front, error);
  if (!value || value->value > furthest * longest) return Read{longest, Reading::unreached};
  return Read{value->value, value->beyond ? Reading::extrapolated : Reading::measured};
}

/// Returns a rival's error at a time in seconds. Returns nothing if all measured settings take
/// longer, or if all take only a small fraction of the time.
std::optional<Read> rival_error(const std::vector<CurvePoint>& front, double seconds) {
  if (front.empty() || seconds < front.front().seconds || seconds > furthest * front.back().seconds)
    return std::nullopt;
  const auto value = error_at_seconds(front, seconds);
  if (!value) return std::nullopt;
  return Read{value->value, value->beyond ? Reading::extrapolated : Reading::measured};
}

std::optional<EqualError> equal_error_on(const Rival& rival, const StudyPoint& p,
                                         const std::string& name) {
  const double seconds = p.seconds();
  const double rmse = p.measures.rmse;
  if (p.under_floor || !(seconds > 0.0)) return std::nullopt;
  const auto read = rival_seconds(rival, rmse);
  if (!read) return std::nullopt;
  return EqualError{p.rung.setting,        name,          rmse,  seconds, read->value,
                    read->value / seconds, read->reading, p.best};
}

void compare(SceneStudy& study, const std::string& name) {
  const Rival rival = rival_of(study, name);
  for (const StudyPoint& p : study.points) {
    if (p.rung.method != subject || p.under_floor || !(p.seconds() > 0.0)) continue;
    const double seconds = p.seconds();
    const double rmse = p.measures.rmse;
    if (const auto row = equal_error_on(rival, p, name)) study.equal_error.push_back(*row);
    if (const auto read = rival_error(rival.front, seconds))
      study.equal_time.push_back({p.rung.setting, name, seconds, rmse, read->value,
                                  read->value / rmse, read->reading, p.best});
  }
}

/// Compares at the times when `sobol` finishes 1, 4, 16 and 64 samples.
std::vector<AtMoment> moments_of(const SceneStudy& study) {
  std::vector<AtMoment> moments;
  const auto asos = std::find_if(study.while_rendering.begin(), study.while_rendering.end(),
                                 [](const RenderCurve& c) { return c.method == subject; });
  if (asos == study.while_rendering.end()) return moments;
  for (const StudyPoint& p : study.points) {
    const bool chosen = p.rung.method == "sobol" && p.rung.settings.sampling.spp <= 64;
    if (!chosen || !(p.seconds() > 0.0) || !(p.measures.rmse > 0.0)) continue;
    const auto shown = error_shown_at(asos->points, p.seconds());
    if (!shown) continue;
    const double sobol = p.measures.rmse;
    moments.push_back({p.rung.setting, p.seconds(), sobol, *shown, *shown / sobol,
                       p.under_floor || *shown < study.floor});
  }
  return moments;
}

double value_of(const EqualError& row) {
  return row.speedup;
}
double value_of(const EqualTime& row) {
  return row.ratio;
}

template <typename Row>
std::vector<MethodComparison> verdicts_of(const std::vector<Row>& rows) {
  std::vector<MethodComparison> all;
  std::vector<std::vector<double>> values, beyond;
  for (const Row& row : rows) {
    if (all.empty() || all.back().method != row.method) {
      all.push_back({row.method});
      values.emplace_back();
      beyond.emplace_back();
    }
    if (!row.best) continue;
    MethodComparison& verdict = all.back();
    const double value = value_of(row);
    if (row.reading == Reading::extrapolated) {
      ++verdict.extrapolated;
      beyond.back().push_back(value);
      continue;
    }
    if (row.reading == Reading::unreached || row.reading == Reading::levelled) {
      ++(row.reading == Reading::levelled ? verdict.levelled : verdict.unreached);
      continue;
    }
    values.back().push_back(value);
    ++(value >= 1.0 + even_band   ? verdict.wins
       : value <= 1.0 - even_band ? verdict.losses
                                  : verdict.evens);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!beyond[i].empty()) all[i].beyond_median = median(beyond[i]);
    if (values[i].empty()) continue;
    all[i].least = *std::min_element(values[i].begin(), values[i].end());
    all[i].most = *std::max_element(values[i].begin(), values[i].end());
    all[i].median = median(values[i]);
  }
  return all;
}

}  // namespace

double StudyPoint::seconds() const {
  return median_of(costs, [](const Cost& c) { return c.cpu_seconds; });
}

double StudyPoint::spread() const {
  if (costs.empty()) return 0.0;
  const auto [lo, hi] = std::minmax_element(
      costs.begin(), costs.end(),
      [](const Cost& a, const Cost& b) { return a.cpu_seconds < b.cpu_seconds; });
  return seconds() > 0.0 ? 0.5 * (hi->cpu_seconds - lo->cpu_seconds) / seconds() : 0.0;
}

double StudyPoint::wall_seconds() const {
  return median_of(costs, [](const Cost& c) { return c.wall_seconds; });
}

double StudyPoint::memory_mb() const {
  return median_of(costs, [](const Cost& c) { return c.memory_mb; });
}

const char* name_of(Reading reading) {
  switch (reading) {
    case Reading::measured:
      return "measured";
    case Reading::cheapest:
      return "cheapest";
    case Reading::extrapolated:
      return "extrapolated";
    case Reading::unreached:
      return "unreached";
    case Reading::levelled:
      return "levelled";
  }
  return "";
}

std::optional<EqualError> at_equal_error(const SceneStudy& study, const StudyPoint& point,
                                         const std::string& rival) {
  return equal_error_on(rival_of(study, rival), point, rival);
}

NoiseFloorCount incomparable(const SceneStudy& study) {
  NoiseFloorCount found;
  for (const StudyPoint& p : study.points) {
    if (p.rung.method != subject) continue;
    ++found.settings;
    found.under_floor += p.under_floor;
  }
  return found;
}

void analyse(SceneStudy& study) {
  study.floor = floor_of(study.noise);
  study.equal_error.clear();
  study.equal_time.clear();
  study.slopes.clear();
  mark_best(study);
  study.bias = bias_of(study);
  study.at_moments = moments_of(study);
  for (const std::string& method :
       names_in(study, [](const StudyPoint& p) { return p.rung.method; }))
    if (method != subject) compare(study, method);
  for (const std::string& curve :
       names_in(study, [](const StudyPoint& p) { return p.rung.curve; })) {
    const auto points = quotable(study, [&](const StudyPoint& p) { return p.rung.curve == curve; });
    if (const auto slope = log_log_slope(points))
      study.slopes.push_back({curve, *slope, static_cast<int>(points.size())});
  }
}

std::vector<MethodComparison> verdicts(const std::vector<EqualError>& rows) {
  return verdicts_of(rows);
}

std::vector<MethodComparison> verdicts(const std::vector<EqualTime>& rows) {
  return verdicts_of(rows);
}

}  // namespace asos
