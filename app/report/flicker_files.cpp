#include "app/report/flicker_files.h"

#include "app/printed_json.h"
#include "app/report/job_record.h"
#include "app/report/pictures.h"
#include "app/report/report_data.h"
#include "app/report/report_files.h"
#include "renderer/picture/settings_json.h"
#include "renderer/study/measures.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace asos {
namespace {

using ordered_json = nlohmann::ordered_json;

constexpr int gap = 2;  // pixels between the frames of a strip

/// Writes the frames side by side with white gaps.
Result<void> write_strip(const std::string& path, const std::vector<Film>& frames) {
  const int width = frames.front().width, height = frames.front().height;
  const auto count = static_cast<int>(frames.size());
  Film strip(count * width + (count - 1) * gap, height);
  std::fill(strip.radiance.begin(), strip.radiance.end(), glm::vec3(1.0f));
  for (int i = 0; i < count; ++i)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const Film& frame = frames[static_cast<std::size_t>(i)];
        strip.radiance[strip.index(i * (width + gap) + x, y)] = frame.radiance[frame.index(x, y)];
      }
  return write_png(path, strip, 0.0f, {});
}

Result<void> write_error_strip(const std::string& path, const std::vector<Film>& frames,
                               const std::vector<Film>& references, double scale) {
  const int width = frames.front().width, height = frames.front().height;
  const auto count = static_cast<int>(frames.size());
  const auto row = static_cast<std::size_t>(count * width + (count - 1) * gap);
  return write_map(path, static_cast<int>(row), height, [&](std::size_t i) {
    const auto x = static_cast<int>(i % row);
    const int at = x % (width + gap);
    if (at >= width) return glm::u8vec3(255);
    const auto frame = static_cast<std::size_t>(x / (width + gap));
    const std::size_t pixel = frames[frame].index(at, static_cast<int>(i / row));
    return error_colour(std::sqrt(squared_error(frames[frame].radiance[pixel],
                                                references[frame].radiance[pixel], true)) /
                        scale);
  });
}

/// The 99.9th percentile of the pixels' flicker at the point that flickers most.
double scale_of(const std::vector<const FlickerPoint*>& points) {
  double scale = 0.0;
  for (const FlickerPoint* p : points) {
    std::vector<double> map = p->meter.map();
    const auto rank = static_cast<std::ptrdiff_t>(0.999 * static_cast<double>(map.size() - 1));
    std::nth_element(map.begin(), map.begin() + rank, map.end());
    scale = std::max(scale, map[static_cast<std::size_t>(rank)]);
  }
  return scale > 0.0 ? scale : 1.0;
}

Result<void> write_shown_strips(const FlickerStudy& study, const std::string& folder,
                                const std::string& name, FlickerFigures& figures) {
  figures.strips.push_back(
      {"reference", figure_path(folder, name, "reference.png"), "", "", nullptr});
  if (auto written = write_strip(figures.strips[0].frames, study.strip); !written) return written;
  const auto points = alike_in_time(study.points);
  figures.error_scale = scale_of(points);
  for (const FlickerPoint* p : points) {
    const std::string& method = p->rung.method;
    ShownStrip shown{fmt::format("{} {}", method, p->rung.setting),
                     figure_path(folder, name, method + ".png"),
                     figure_path(folder, name, method + "-errors.png"),
                     figure_path(folder, name, method + "-flicker.png"), p};
    const std::vector<double> map = p->meter.map();
    const auto written =
        write_strip(shown.frames, p->strip)
            .and_then([&] {
              return write_error_strip(shown.errors, p->strip, study.strip, figures.error_scale);
            })
            .and_then([&] {
              return write_map(shown.flicker, study.width, study.height, [&](std::size_t i) {
                return error_colour(map[i] / figures.error_scale);
              });
            });
    if (!written) return written;
    figures.strips.push_back(std::move(shown));
  }
  return {};
}

/// Plots flicker, or the RMSE, against the CPU time of a frame.
CurvePlot plot_of_flicker(const FlickerStudy& study, bool flicker) {
  CurvePlot plot{study.scene,
                 flicker ? "Flicker: RMS over time of what varies of the error"
                         : "RMSE over all frames, linear radiance clipped to 0..1",
                 {},
                 flicker ? study.floor : 0.0};
  for (const FlickerPoint& p : study.points) {
    const auto [lo, hi] = std::minmax_element(p.frame_seconds.begin(), p.frame_seconds.end());
    const double value = flicker ? p.meter.flicker() : p.meter.rmse();
    plot.add(p.rung, {p.seconds(), value, *lo, *hi, value < plot.floor});
  }
  return plot;
}

ordered_json flicker_json(const FlickerStudy& study) {
  ordered_json j{
      {"scene", study.scene},
      {"animation", study.animation},
      {"animation_number", study.animation_number},
      {"first_frame", study.first_frame},
      {"frames", study.frames},
      {"frames_per_second", study.fps},
      {"width", study.width},
      {"height", study.height},
      {"when", study.when},
      {"machine", machine_json(study.machine)},
      {"reference", {{"samples", study.samples}, {"noise", study.noise}, {"floor", study.floor}}},
      {"given_up", study.timed_out},
      {"points", ordered_json::array()},
      {"equal_time", ordered_json::array()}};
  for (const FlickerPoint& p : study.points)
    j["points"].push_back({{"method", p.rung.method},
                           {"setting", p.rung.setting},
                           {"settings", settings_json(p.rung.settings)},
                           {"seconds", p.seconds()},
                           {"rmse", p.meter.rmse()},
                           {"flicker", p.meter.flicker()},
                           {"steady", p.meter.steady()},
                           {"step", p.meter.step()},
                           {"under_floor", p.under_floor}});
  for (const FlickerAtEqualTime& row : study.equal_time)
    j["equal_time"].push_back({{"setting", row.setting},
                               {"method", row.method},
                               {"seconds", row.seconds},
                               {"asos_flicker", row.asos_flicker},
                               {"rival_flicker", row.rival_flicker},
                               {"ratio", row.ratio()},
                               {"at_least", row.at_least},
                               {"reading", name_of(row.reading)}});
  return j;
}

}  // namespace

std::string flicker_csv(const std::vector<FlickerStudy>& studies) {
  std::string text =
      "scene,animation,method,setting,first_frame,frames,frames_per_second,seconds,rmse,flicker,"
      "steady,step,under_floor\n";
  for (const FlickerStudy& study : studies)
    for (const FlickerPoint& p : study.points)
      text += fmt::format("{},{},{},{},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{}\n",
                          csv_field(study.scene), csv_field(study.animation),
                          csv_field(p.rung.method), csv_field(p.rung.setting), study.first_frame,
                          study.frames, study.fps, p.seconds(), p.meter.rmse(), p.meter.flicker(),
                          p.meter.steady(), p.meter.step(), p.under_floor);
  return text;
}

Result<void> write_flicker_report(const std::vector<FlickerStudy>& studies,
                                  const std::string& folder) {
  const std::string plots = (std::filesystem::path(folder) / "plots").string();
  const std::string pictures = (std::filesystem::path(folder) / "pictures").string();
  for (const std::string& inner : {plots, pictures})
    if (auto made = make_folder(inner); !made) return made;
  std::vector<FlickerFigures> figures;
  ordered_json json = ordered_json::array();
  for (const FlickerStudy& study : studies) {
    const std::string name = plain_name(study.scene, figures.size() + 1);
    FlickerFigures& made = figures.emplace_back();
    for (const bool flicker : {true, false}) {
      const CurvePlot plot = plot_of_flicker(study, flicker);
      if (plot.empty()) continue;
      const std::string path = figure_path(plots, name, flicker ? "flicker" : "rmse");
      if (auto drawn = draw_plot(plot, path); !drawn) return drawn;
      made.plots.push_back(path);
    }
    if (auto written = write_shown_strips(study, pictures, name, made); !written) return written;
    json.push_back(flicker_json(study));
  }
  const auto page = flicker_page(studies, figures);
  if (!page) return tl::unexpected(page.error());
  return write_text(folder, "flicker.csv", flicker_csv(studies))
      .and_then([&] { return write_text(folder, "flicker.json", json_text(json)); })
      .and_then([&] { return write_text(folder, "report.html", *page); });
}

}  // namespace asos
