#include "tests/bench/measured_ladder.h"

#include "renderer/film/image_io.h"

#include <fmt/format.h>

#include <fstream>
#include <utility>

namespace asos::bench {

void MeasuredLadder::add(const std::string& label, const RenderSettings& settings) {
  steps_.push_back({label, settings, {}});
}

void MeasuredLadder::render(Snapshot snapshot, const HalvedReference& reference) {
  points_.clear();
  known_.clear();
  for (Step& step : steps_) {
    snapshot.settings = step.settings;
    const KnownError error = reference.error_of(step.times.render(snapshot).film);
    points_.push_back({step.times.medians().cpu, error.rmse});
    known_.push_back(error.known);
  }
}

bool MeasuredLadder::read(const std::string& path) {
  std::ifstream file(path);
  std::vector<CurvePoint> points;
  for (const Step& step : steps_) {
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
