#include "tests/bench/measured_ladder.h"

#include "renderer/comparison/method.h"
#include "renderer/film/image_io.h"
#include "renderer/study/ladders.h"

#include <fmt/format.h>

#include <fstream>
#include <utility>

namespace asos::bench {

MeasuredLadder MeasuredLadder::of_study(Method method, const RenderSettings& base,
                                        const std::string& prefix) {
  MeasuredLadder ladder;
  const MethodRow& row = row_of(method);
  const std::vector<LadderStep> steps = ladder_of(row.name, base).value();
  for (const LadderStep& step : steps)
    ladder.add(
        prefix + (row.samples == SampleCount::none ? eps_text(step.settings.asos.eps)
                                                   : fmt::format("{}", step.settings.sampling.spp)),
        step.settings);
  return ladder;
}

void MeasuredLadder::add(const std::string& label, const RenderSettings& settings) {
  steps_.push_back({label, settings});
}

void MeasuredLadder::render(Snapshot snapshot, const Judge& judge) {
  points_.clear();
  for (MeasuredStep& step : steps_) {
    snapshot.settings = step.settings;
    const RenderResult rendered = step.times.render(snapshot);
    step.statistics = rendered.statistics;
    judge(step, rendered.film);
    points_.push_back({step.times.medians().cpu, step.error.rmse});
  }
}

bool MeasuredLadder::read(const std::string& path) {
  std::ifstream file(path);
  std::vector<CurvePoint> points;
  for (const MeasuredStep& step : steps_) {
    std::string label;
    CurvePoint point;
    if (!(file >> label >> point.error >> point.seconds) || label != step.label) return false;
    points.push_back(point);
  }
  points_ = std::move(points);
  return true;
}

Result<void> MeasuredLadder::write(const std::string& path) const {
  std::string text;
  for (std::size_t i = 0; i < points_.size(); ++i)
    text += fmt::format("{} {} {}\n", steps_[i].label, points_[i].error, points_[i].seconds);
  return write_file_atomically(path, {text.begin(), text.end()});
}

}  // namespace asos::bench
