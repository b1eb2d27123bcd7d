#include "app/report/html_page.h"

#include <fmt/format.h>

#include <algorithm>

// The comparisons that ASOS does not win, and those without a result.

namespace asos {
namespace {

const StudyPoint* quickest(const SceneStudy& study, bool asos) {
  const StudyPoint* found = nullptr;
  for (const StudyPoint& p : study.points)
    if ((p.rung.method == "asos") == asos && (!found || p.seconds() < found->seconds())) found = &p;
  return found;
}

/// Notes that ASOS has no picture in times below its quickest setting.
std::string too_quick_text(const SceneStudy& study) {
  const StudyPoint* asos = quickest(study, true);
  const StudyPoint* other = quickest(study, false);
  if (!asos || !other || other->seconds() >= asos->seconds()) return "";
  return fmt::format(
      "<li>{}: in less than {} there is no ASOS picture at all. {} {} gives one in {} (RMSE {}; "
      "ASOS's quickest, {}: {}).</li>\n",
      escaped(study.scene), seconds_text(asos->seconds()), escaped(other->rung.method),
      other->rung.setting, seconds_text(other->seconds()), error_text(other->measures.rmse),
      asos->rung.setting, error_text(asos->measures.rmse));
}

std::string losing_row(const SceneStudy& study, const std::string& setting, bool best,
                       const std::string& method, const std::string& basis,
                       const std::string& result) {
  return fmt::format(
      "<tr><td class=\"t\">{}</td><td class=\"t\">asos {}{}</td><td class=\"t\">{}</td>"
      "<td class=\"t\">{}</td><td class=\"t loss\">{}</td></tr>\n",
      escaped(study.scene), escaped(setting), best ? "" : " (not one of its best)", escaped(method),
      basis, result);
}

/// The rows of comparisons that ASOS does not win, and the number of all comparisons.
struct Losses {
  std::string rows;
  int count = 0;
  int all = 0;
};

void add_losses(const SceneStudy& study, Losses& losses) {
  for (const EqualError& row : study.equal_error) {
    ++losses.all;
    if (outcome_of(row.speedup) == Outcome::win || row.reading == Reading::unreached ||
        row.reading == Reading::levelled)
      continue;
    ++losses.count;
    const char* word = outcome_of(row.speedup) == Outcome::even ? "even" : "slower";
    losses.rows += losing_row(
        study, row.setting, row.best, row.method, "same error, RMSE " + error_text(row.rmse),
        fmt::format("{}: {} against {}, {}\u00d7 as fast{}", word, seconds_text(row.asos_seconds),
                    seconds_text(row.rival_seconds), factor_text(row.speedup),
                    row.reading == Reading::extrapolated ? " (extrapolated)" : ""));
  }
  for (const EqualTime& row : study.equal_time) {
    ++losses.all;
    if (outcome_of(row.ratio) == Outcome::win) continue;
    ++losses.count;
    const char* word = outcome_of(row.ratio) == Outcome::even ? "even" : "less accurate";
    losses.rows += losing_row(
        study, row.setting, row.best, row.method, "same time, " + seconds_text(row.seconds),
        fmt::format("{}: RMSE {} against {}{}", word, error_text(row.asos_rmse),
                    error_text(row.rival_rmse),
                    row.reading == Reading::extrapolated ? " (extrapolated)" : ""));
  }
}

/// Says which of ASOS's settings are below the noise floor and so not compared.
std::string under_floor_text(const SceneStudy& study) {
  const auto [all, under] = incomparable(study);
  if (under == 0) return "";
  return fmt::format(
      "<li>{}: {} of ASOS's {} settings are not compared with anything, because their error is "
      "under the floor of the reference ({}). A longer --budget lowers it.</li>\n",
      escaped(study.scene), under, all, error_text(study.floor));
}

/// Lists the settings that exceeded the time limit, or were skipped because quicker ones had.
std::string given_up_text(const SceneReport& scene, double longest_seconds) {
  if (scene.timed_out.empty()) return "";
  return fmt::format("<li>{}: given up after {}, or as dearer than what was: {}.</li>\n",
                     escaped(scene.study.scene), seconds_text(longest_seconds),
                     escaped(list_text(scene.timed_out)));
}

/// Longer lists of rows are folded.
constexpr int most_open_rows = 20;

/// List by scene of the methods that ASOS's best settings do not beat.
std::string losses_matrix(const StudyReport& report) {
  std::string items;
  for (const SceneReport& scene : report.scenes) {
    std::vector<std::string> words;
    for (const MethodComparison& v : verdicts(scene.study.equal_error))
      if (v.losses + v.evens > 0)
        words.push_back(fmt::format("{} at the same error, {} of {} settings (down to {}\u00d7)",
                                    escaped(v.method), v.losses + v.evens,
                                    v.wins + v.evens + v.losses, factor_text(v.least)));
    for (const MethodComparison& v : verdicts(scene.study.equal_time))
      if (v.losses + v.evens > 0)
        words.push_back(fmt::format("{} in the same time, {} of {} settings (down to {}\u00d7)",
                                    escaped(v.method), v.losses + v.evens,
                                    v.wins + v.evens + v.losses, factor_text(v.least)));
    if (!words.empty())
      items += fmt::format("<li><strong>{}</strong>, of its best settings against {}.</li>\n",
                           escaped(scene.study.scene), list_text(words));
  }
  return items.empty() ? "" : "<ul>\n" + items + "</ul>\n";
}

}  // namespace

std::string html_losses(const StudyReport& report) {
  Losses losses;
  std::string quick;
  for (const SceneReport& scene : report.scenes) {
    add_losses(scene.study, losses);
    quick += too_quick_text(scene.study) + under_floor_text(scene.study) +
             given_up_text(scene, report.plan.longest_seconds);
  }
  std::string text = "<h3 id=\"losses\">Where ASOS does not win</h3>\n";
  text += losses.count == 0
              ? fmt::format(
                    "<p>In none of the {} comparisons below, of all settings of ASOS with "
                    "each method, does ASOS come out even or behind.</p>\n",
                    losses.all)
              : fmt::format(
                    "<p>ASOS comes out <strong>even or behind in {} of {}</strong> "
                    "comparisons (each setting of ASOS, good or not, with each method, at the "
                    "same error and in the same time).</p>\n",
                    losses.count, losses.all);
  text += losses_matrix(report);
  if (!quick.empty()) text += "<ul>\n" + quick + "</ul>\n";
  if (losses.count > 0)
    text += fmt::format(
        "<details{}><summary>All {} of them, one a line</summary>\n<div class=\"scroll\"><table>\n"
        "<thead><tr><th class=\"t\">Scene</th><th class=\"t\">ASOS setting</th>"
        "<th class=\"t\">Against</th><th class=\"t\">Compared at</th><th class=\"t\">ASOS is</th>"
        "</tr></thead>\n<tbody>\n{}</tbody></table></div>\n</details>\n",
        losses.count <= most_open_rows ? " open" : "", losses.count, losses.rows);
  return text;
}

}  // namespace asos
