#include "app/report/flicker_study.h"

#include "renderer/study/curves.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asos {
namespace {

constexpr const char* flicker_subject = "asos";

/// A method's Pareto-optimal settings by time and flicker.
std::vector<CurvePoint> flicker_front(const FlickerStudy& study, const std::string& method) {
  std::vector<CurvePoint> points;
  for (const FlickerPoint& p : study.points) {
    const CurvePoint at{p.seconds(), p.meter.flicker()};
    if (p.rung.method == method && !p.under_floor && at.seconds > 0.0 && at.error > 0.0)
      points.push_back(at);
  }
  return pareto_front(std::move(points));
}

/// A rival's flicker in a given time, or that of its quickest setting if that takes longer.
std::optional<FlickerAtEqualTime> beside(const FlickerPoint& asos, const std::string& method,
                                         const std::vector<CurvePoint>& front, double floor) {
  FlickerAtEqualTime row;
  row.setting = asos.rung.setting;
  row.method = method;
  row.seconds = asos.seconds();
  row.asos_flicker = std::max(asos.meter.flicker(), floor);
  row.at_least = asos.under_floor;
  if (front.empty() || !(row.asos_flicker > 0.0)) return std::nullopt;
  if (row.seconds <= front.front().seconds) {
    row.rival_flicker = front.front().error;
    row.reading = Reading::cheapest;
    return row;
  }
  const auto read = error_at_seconds(front, row.seconds);
  row.rival_flicker = read ? read->value : front.back().error;
  if (!read || read->beyond) row.reading = Reading::extrapolated;
  return row;
}

}  // namespace

double FlickerPoint::seconds() const {
  if (frame_seconds.empty()) return 0.0;
  return std::accumulate(frame_seconds.begin(), frame_seconds.end(), 0.0) /
         static_cast<double>(frame_seconds.size());
}

void compare_flicker(FlickerStudy& study) {
  study.equal_time.clear();
  std::vector<std::string> rivals;
  for (FlickerPoint& p : study.points) {
    p.under_floor = p.meter.flicker() < study.floor;
    const bool known = std::find(rivals.begin(), rivals.end(), p.rung.method) != rivals.end();
    if (!known && p.rung.method != flicker_subject) rivals.push_back(p.rung.method);
  }
  for (const std::string& rival : rivals) {
    const std::vector<CurvePoint> front = flicker_front(study, rival);
    for (const FlickerPoint& p : study.points)
      if (p.rung.method == flicker_subject)
        if (const auto row = beside(p, rival, front, study.floor)) study.equal_time.push_back(*row);
  }
}

}  // namespace asos
