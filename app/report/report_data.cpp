#include "app/report/report_data.h"

#include "renderer/picture/settings_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace asos {
namespace {

using json = nlohmann::ordered_json;

json measures_json(const Measures& m) {
  return {{"rmse", m.rmse},
          {"rmse_raw", m.rmse_raw},
          {"mae", m.mae},
          {"p99", m.p99},
          {"p999", m.p999},
          {"max", m.max},
          {"rmse_display", m.rmse_display},
          {"perceptual", m.perceptual}};
}

json point_json(const StudyPoint& p) {
  json j{{"method", p.rung.method},
         {"setting", p.rung.setting},
         {"curve", p.rung.curve},
         {"settings", settings_json(p.rung.settings)},
         {"seconds", p.seconds()},
         {"spread", p.spread()},
         {"wall_seconds", p.wall_seconds()},
         {"memory_mb", p.memory_mb()},
         {"rays", p.rays},
         {"pyrays", p.pyrays},
         {"rejected_samples", p.rejected_samples},
         {"under_floor", p.under_floor},
         {"best", p.best},
         {"same_picture", p.same_picture}};
  j.update(measures_json(p.measures));
  for (std::size_t r = 0; r < region_count; ++r)
    j["regions"][region_names[r]] = {{"pixels", p.regions[r].pixels},
                                     {"rmse", p.regions[r].rmse},
                                     {"share", p.regions[r].share}};
  return j;
}

json while_rendering_json(const SceneStudy& study) {
  json curves = json::array();
  for (const RenderCurve& curve : study.while_rendering) {
    json points = json::array();
    for (const CurvePoint& p : curve.points)
      points.push_back({{"seconds", p.seconds}, {"rmse", p.error}});
    curves.push_back({{"method", curve.method},
                      {"setting", curve.setting},
                      {"finished", curve.finished},
                      {"points", std::move(points)}});
  }
  return curves;
}

json at_moments_json(const SceneStudy& study) {
  json rows = json::array();
  for (const AtMoment& row : study.at_moments)
    rows.push_back({{"sobol_setting", row.setting},
                    {"seconds", row.seconds},
                    {"sobol_rmse", row.sobol_rmse},
                    {"asos_rmse", row.asos_rmse},
                    {"error_ratio", row.ratio},
                    {"under_floor", row.under_floor}});
  return rows;
}

json scene_json(const SceneReport& scene) {
  json j{{"scene", scene.study.scene},
         {"triangles", scene.facts.triangles},
         {"lights", scene.facts.lights},
         {"left_out", scene.facts.left_out},
         {"given_up", scene.timed_out},
         {"reference",
          {{"passes", scene.passes},
           {"samples", scene.samples},
           {"noise", scene.study.noise},
           {"floor", scene.study.floor},
           {"quiet_enough", scene.quiet}}},
         {"points", json::array()}};
  for (const StudyPoint& p : scene.study.points) j["points"].push_back(point_json(p));
  j["while_rendering"] = while_rendering_json(scene.study);
  j["asos_while_rendering"] = at_moments_json(scene.study);
  if (const auto& bias = scene.study.bias)
    j["asos_bias"] = {
        {"at_most", bias->at_most}, {"levels_off", bias->levels_off}, {"setting", bias->setting}};
  return j;
}

void add_comparisons(const SceneStudy& study, json& report) {
  for (const EqualError& row : study.equal_error)
    report["equal_error"].push_back({{"scene", study.scene},
                                     {"setting", row.setting},
                                     {"method", row.method},
                                     {"rmse", row.rmse},
                                     {"seconds", row.asos_seconds},
                                     {"method_seconds", row.rival_seconds},
                                     {"speedup", row.speedup},
                                     {"reading", name_of(row.reading)},
                                     {"best", row.best}});
  for (const EqualTime& row : study.equal_time)
    report["equal_time"].push_back({{"scene", study.scene},
                                    {"setting", row.setting},
                                    {"method", row.method},
                                    {"seconds", row.seconds},
                                    {"rmse", row.asos_rmse},
                                    {"method_rmse", row.rival_rmse},
                                    {"error_ratio", row.ratio},
                                    {"reading", name_of(row.reading)},
                                    {"best", row.best}});
  for (const Slope& slope : study.slopes)
    report["slopes"].push_back({{"scene", study.scene},
                                {"curve", slope.curve},
                                {"slope", slope.slope},
                                {"points", slope.points}});
}

json ratio_or_null(double ratio) {
  return ratio > 0.0 ? json(ratio) : json(nullptr);
}

json paper_json(const StudyReport& report) {
  json rows = json::array();
  for (const PaperRow& row : paper_rows(report)) {
    const PaperCase& published = *row.published;
    json j{{"figure", published.figure},
           {"image", published.image},
           {"settings", published.settings},
           {"published_minutes", published.asos_minutes},
           {"published_ratio", ratio_or_null(row.published_ratio())},
           {"scene", row.scene},
           {"method", row.method},
           {"seconds", row.asos_seconds},
           {"rmse", row.asos_rmse},
           {"under_floor", row.under_floor},
           {"ratio", ratio_or_null(row.ratio())}};
    if (published.rival_spp > 0) {
      j["stochastic_spp"] = published.rival_spp;
      j["stochastic_seconds"] = row.rival_seconds;
      j["stochastic_rmse"] = row.rival_rmse;
    }
    if (row.equal_error) {
      j["ratio_at_equal_error"] = row.equal_error->speedup;
      j["reading"] = name_of(row.equal_error->reading);
    }
    rows.push_back(std::move(j));
  }
  return rows;
}

const SceneReport* scene_called(const StudyReport& report, const std::string& name) {
  for (const SceneReport& scene : report.scenes)
    if (scene.study.scene == name) return &scene;
  return nullptr;
}

const StudyPoint* point_at(const SceneReport& scene, const std::string& method,
                           const std::string& setting) {
  for (const StudyPoint& p : scene.study.points)
    if (p.rung.method == method && p.rung.setting == setting) return &p;
  return nullptr;
}

void add_measured(const StudyReport& report, const PaperCase& published,
                  std::vector<PaperRow>& rows) {
  const std::string name = scene_of(published).name();
  const SceneReport* scene = scene_called(report, name);
  if (!scene) return;
  for (const char* method : {"asos", "asos-published"}) {
    const StudyPoint* asos = point_at(*scene, method, asos_rung(published, method, {}).setting);
    if (!asos) continue;
    PaperRow row;
    row.published = &published;
    row.scene = name;
    row.method = method;
    row.asos_seconds = asos->seconds();
    row.asos_rmse = asos->measures.rmse;
    row.under_floor = asos->under_floor;
    row.equal_error = at_equal_error(scene->study, *asos, "stochastic");
    const std::string spp = sampling_rung("stochastic", {}, published.rival_spp).setting;
    if (const StudyPoint* rival = point_at(*scene, "stochastic", spp)) {
      row.rival_seconds = rival->seconds();
      row.rival_rmse = rival->measures.rmse;
    }
    rows.push_back(row);
  }
}

}  // namespace

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string points_csv(const StudyReport& report) {
  std::string text =
      "scene,method,setting,repetition,seconds,rmse,mae,p99,p999,max,rmse_display,perceptual,rays,"
      "pyrays,memory_mb\n";
  for (const SceneReport& scene : report.scenes) {
    for (const StudyPoint& p : scene.study.points) {
      const Measures& m = p.measures;
      for (std::size_t r = 0; r < p.costs.size(); ++r)
        text += fmt::format(
            "{},{},{},{},{:.6f},{:.6e},{:.6e},{:.6e},{:.6e},{:.6e},{:.6e},{:.6e},"
            "{},{},{:.1f}\n",
            csv_field(scene.study.scene), csv_field(p.rung.method), csv_field(p.rung.setting),
            r + 1, p.costs[r].cpu_seconds, m.rmse, m.mae, m.p99, m.p999, m.max, m.rmse_display,
            m.perceptual, p.rays, p.pyrays, p.costs[r].memory_mb);
    }
  }
  return text;
}

std::string progress_csv(const StudyReport& report) {
  std::string text = "scene,method,setting,picture,seconds,rmse\n";
  for (const SceneReport& scene : report.scenes)
    for (const RenderCurve& curve : scene.study.while_rendering)
      for (std::size_t k = 0; k < curve.points.size(); ++k)
        text += fmt::format("{},{},{},{},{:.6f},{:.6e}\n", csv_field(scene.study.scene),
                            csv_field(curve.method), csv_field(curve.setting), k + 1,
                            curve.points[k].seconds, curve.points[k].error);
  return text;
}

json report_json(const StudyReport& report) {
  json j{{"settings", plan_json(report.plan)},
         {"seconds_are", "processor time of all threads together, median of the repetitions"},
         {"perceptual_is", "mean CIEDE2000"},
         {"first_job", report.first},
         {"last_job", report.last},
         {"machines", json::array()},
         {"scenes", json::array()},
         {"equal_error", json::array()},
         {"equal_time", json::array()},
         {"slopes", json::array()}};
  for (const Machine& machine : report.machines) j["machines"].push_back(machine_json(machine));
  if (!report.machines.empty()) {
    j["machine"] = report.machines.front().processor;
    j["build"] = report.machines.front().compiler;
    j["commit"] = report.machines.front().commit;
  }
  for (const SceneReport& scene : report.scenes) {
    j["scenes"].push_back(scene_json(scene));
    add_comparisons(scene.study, j);
  }
  if (report.plan.paper) j["paper"] = paper_json(report);
  return j;
}

std::vector<PaperRow> paper_rows(const StudyReport& report) {
  std::vector<PaperRow> rows;
  if (!report.plan.paper) return rows;
  for (const PaperCase& published : paper_cases) add_measured(report, published, rows);
  return rows;
}

}  // namespace asos
