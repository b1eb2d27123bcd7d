#include "renderer/study/floor_bound.h"

#include <algorithm>
#include <vector>

namespace asos {
namespace {

const StudyPoint* quickest_under_floor(const SceneStudy& study) {
  const StudyPoint* quickest = nullptr;
  for (const StudyPoint& p : study.points) {
    if (p.rung.method != "asos" || !p.under_floor || !(p.seconds() > 0.0)) continue;
    if (!quickest || p.seconds() < quickest->seconds()) quickest = &p;
  }
  return quickest;
}

/// Returns the best settings of a method, including those below the floor.
std::vector<CurvePoint> whole_front(const SceneStudy& study, const std::string& method) {
  std::vector<CurvePoint> points;
  for (const StudyPoint& p : study.points)
    if (p.rung.method == method && p.seconds() > 0.0 && p.measures.rmse > 0.0)
      points.push_back({p.seconds(), p.measures.rmse});
  return pareto_front(std::move(points));
}

}  // namespace

std::optional<FloorBound> bound_at_floor(const SceneStudy& study, const std::string& rival) {
  const StudyPoint* own = quickest_under_floor(study);
  const std::vector<CurvePoint> front = whole_front(study, rival);
  // If the quickest setting is below the floor, the time to reach the floor is unknown.
  if (!own || front.empty() || front.front().error <= study.floor) return std::nullopt;
  FloorBound bound{own->rung.setting, own->seconds()};
  if (const auto at = seconds_at_error(front, study.floor); at && !at->beyond) {
    bound.rival_seconds = at->value;
  } else {
    bound.rival_seconds = front.back().seconds;
    bound.reading = Reading::unreached;
  }
  bound.factor = bound.rival_seconds / bound.asos_seconds;
  return bound;
}

}  // namespace asos
