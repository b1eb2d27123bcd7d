#include "app/report/html_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace asos {
namespace {

std::string name_of_method(const std::string& method) {
  return method == "asos-published" ? "asos-published (ASOS as the papers have it)" : method;
}

std::string range_text(const Verdict& v) {
  if (v.wins + v.evens + v.losses == 0) return "";
  if (v.least == v.most) return factor_text(v.median) + "\u00d7";
  return fmt::format("{}\u00d7; {} to {}", factor_text(v.median), factor_text(v.least),
                     factor_text(v.most));
}

/// Whom a verdict favours, in words.
std::string plain_verdict(const Verdict& v) {
  const int count = v.wins + v.evens + v.losses;
  if (count == 0) return v.beyond > 0 ? "ASOS: the other is never that accurate" : "not measured";
  if (v.wins == count) return "ASOS wins";
  if (v.losses == count) return "ASOS loses";
  if (v.evens == count) return "even";
  if (v.losses == 0) return fmt::format("ASOS wins {} of {}, the rest even", v.wins, count);
  if (v.wins == 0) return fmt::format("ASOS loses {} of {}, the rest even", v.losses, count);
  return fmt::format("depends: ASOS wins {}, loses {} of {}", v.wins, v.losses, count);
}

std::string verdict_text(const Verdict& v) {
  if (v.beyond == 0 || v.wins + v.evens + v.losses == 0) return plain_verdict(v);
  return fmt::format("{} ({} more: the other is never that accurate)", plain_verdict(v), v.beyond);
}

const char* class_of(const Verdict& v) {
  return v.losses > 0 ? "loss" : v.wins > 0 ? "win" : "";
}

template <typename Rows>
std::optional<Verdict> verdict_on(const Rows& rows, const std::string& method) {
  for (const Verdict& v : verdicts(rows))
    if (v.method == method) return v;
  return std::nullopt;
}

/// "uniform (5.2x), stochastic (3.1x)": the rivals that `wanted` picks.
template <typename Wanted>
std::string rivals_where(const SceneStudy& study, Wanted wanted) {
  std::vector<std::string> words;
  for (const Verdict& v : verdicts(study.equal_error))
    if (wanted(v)) words.push_back(fmt::format("{} ({})", escaped(v.method), range_text(v)));
  return list_text(words);
}

std::string scene_sentence(const SceneStudy& study) {
  const auto measured = [](const Verdict& v) { return v.wins + v.evens + v.losses > 0; };
  const std::string won = rivals_where(
      study, [&](const Verdict& v) { return measured(v) && v.losses == 0 && v.wins > 0; });
  const std::string lost = rivals_where(
      study, [&](const Verdict& v) { return measured(v) && v.losses > 0 && v.wins == 0; });
  const std::string mixed =
      rivals_where(study, [](const Verdict& v) { return v.losses > 0 && v.wins > 0; });
  const std::string even = rivals_where(
      study, [&](const Verdict& v) { return measured(v) && v.losses == 0 && v.wins == 0; });
  std::vector<std::string> parts;
  if (!won.empty()) parts.push_back("is <strong>faster</strong> than " + won);
  if (!mixed.empty())
    parts.push_back("is <strong>faster or slower depending on the quality</strong> against " +
                    mixed);
  if (!lost.empty()) parts.push_back("is <strong>slower</strong> than " + lost);
  if (!even.empty()) parts.push_back("is even with " + even);
  std::vector<std::string> out_of_reach;
  for (const Verdict& v : verdicts(study.equal_error))
    if (!measured(v) && v.beyond > 0) out_of_reach.push_back(escaped(v.method));
  if (!out_of_reach.empty())
    parts.push_back("is <strong>more accurate</strong> than " + list_text(out_of_reach) +
                    " at any setting measured");
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "; it ") + part;
  if (text.empty()) text = "could not be compared with any other method above the floor";
  return fmt::format("<li><strong>{}</strong>: for the same error ASOS {}.</li>\n",
                     escaped(study.scene), text);
}

std::string verdict_table(const StudyReport& report) {
  std::string rows;
  for (const SceneReport& scene : report.scenes) {
    bool first = true;
    for (const Verdict& error : verdicts(scene.study.equal_error)) {
      const auto time = verdict_on(scene.study.equal_time, error.method);
      rows += fmt::format(
          "<tr{}><td class=\"t\">{}</td><td class=\"t\">{}</td><td class=\"t {}\">{}</td>"
          "<td>{}</td><td class=\"t {}\">{}</td><td>{}</td></tr>\n",
          first ? " class=\"first\"" : "", first ? escaped(scene.study.scene) : "",
          escaped(name_of_method(error.method)), class_of(error), verdict_text(error),
          range_text(error), time ? class_of(*time) : "",
          time ? verdict_text(*time) : "not measured", time ? range_text(*time) : "");
      first = false;
    }
  }
  if (rows.empty()) return "<p>No comparison could be made.</p>\n";
  return fmt::format(
      "<div class=\"scroll\"><table>\n<caption>ASOS at its best settings against each method at "
      "its "
      "best. Median, and least to most, over ASOS's settings.</caption>\n"
      "<thead><tr><th class=\"t\">Scene</th><th class=\"t\">Against</th>"
      "<th class=\"t\">Same error: who is faster</th><th>its time / ASOS's</th>"
      "<th class=\"t\">Same time: who is more accurate</th><th>its error / ASOS's</th></tr></thead>"
      "\n"
      "<tbody>\n{}</tbody></table></div>\n",
      rows);
}

const StudyPoint* quickest(const SceneStudy& study, bool asos) {
  const StudyPoint* found = nullptr;
  for (const StudyPoint& p : study.points)
    if ((p.rung.method == "asos") == asos && (!found || p.seconds() < found->seconds())) found = &p;
  return found;
}

/// Below ASOS's quickest setting there is no ASOS at all.
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

/// Rows that ASOS does not win, by any reading, and how many there are of all.
struct Losses {
  std::string rows;
  int count = 0;
  int all = 0;
};

void add_losses(const SceneStudy& study, Losses& losses) {
  for (const EqualError& row : study.equal_error) {
    ++losses.all;
    if (outcome_of(row.speedup) == Outcome::win || row.reading == Reading::unreached) continue;
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

/// How much of ASOS no comparison tells anything about.
std::string under_floor_text(const SceneStudy& study) {
  const auto is_asos = [](const StudyPoint& p) { return p.rung.method == "asos"; };
  const auto all = std::count_if(study.points.begin(), study.points.end(), is_asos);
  const auto under = std::count_if(study.points.begin(), study.points.end(),
                                   [&](const auto& p) { return is_asos(p) && p.under_floor; });
  if (under == 0) return "";
  return fmt::format(
      "<li>{}: {} of ASOS's {} settings are not compared with anything, because their error is "
      "under the floor of the reference ({}). A longer --budget lowers it.</li>\n",
      escaped(study.scene), under, all, error_text(study.floor));
}

std::string where_not(const StudyReport& report) {
  Losses losses;
  std::string quick;
  for (const SceneReport& scene : report.scenes) {
    add_losses(scene.study, losses);
    quick += too_quick_text(scene.study) + under_floor_text(scene.study);
  }
  std::string text = "<h3 id=\"losses\">Where ASOS does not win</h3>\n";
  text += losses.count == 0
              ? fmt::format(
                    "<p>In none of the {} comparisons below, of all settings of ASOS with "
                    "each method, does ASOS come out even or behind.</p>\n",
                    losses.all)
              : fmt::format(
                    "<p>ASOS comes out <strong>even or behind in {} of {}</strong> "
                    "comparisons (each setting of ASOS, each method, at the same error and "
                    "in the same time). All of them:</p>\n",
                    losses.count, losses.all);
  if (!quick.empty()) text += "<ul>\n" + quick + "</ul>\n";
  if (losses.count > 0)
    text += fmt::format(
        "<div class=\"scroll\"><table>\n<thead><tr><th class=\"t\">Scene</th>"
        "<th class=\"t\">ASOS setting</th><th class=\"t\">Against</th><th class=\"t\">Compared at"
        "</th><th class=\"t\">ASOS is</th></tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
        losses.rows);
  return text;
}

/// "2026-01-31 12:00 UTC"
std::string date_text(const std::string& when) {
  return when.size() < 16 ? escaped(when)
                          : escaped(when.substr(0, 10) + " " + when.substr(11, 5) + " UTC");
}

std::string compared_text(const StudyReport& report) {
  std::vector<std::string> methods;
  std::size_t settings = 0;
  for (const SceneReport& scene : report.scenes) {
    for (const StudyPoint& p : scene.study.points) {
      ++settings;
      if (p.rung.method != "asos" &&
          std::find(methods.begin(), methods.end(), p.rung.method) == methods.end())
        methods.push_back(p.rung.method);
    }
  }
  std::vector<std::string> scenes;
  for (const SceneReport& scene : report.scenes) scenes.push_back(escaped(scene.study.scene));
  return fmt::format(
      "<p><strong>Compared:</strong> ASOS (adaptive supersampling in object space) with {} other "
      "ways to antialias: {}. On {}, {}\u202f\u00d7\u202f{} pixels, all with the same ray tracer, "
      "lights and shading. Each method runs over its own quality settings ({} in all), each "
      "{}; every picture is held against a reference of many more samples. Error is the root "
      "mean square (RMSE) of linear radiance; time is processor time.</p>\n",
      methods.size(), list_text(methods), list_text(scenes), report.plan.width, report.plan.height,
      settings,
      report.plan.repetitions == 1 ? "once" : fmt::format("{} times", report.plan.repetitions));
}

}  // namespace

std::string html_summary(const StudyReport& report) {
  const Machine& machine = report.machines.front();
  std::string text = fmt::format(
      "<h1>ASOS report: error against run time</h1>\n<p class=\"sub\">asos {} (commit {}), {}, {} "
      "cores; measured from {} to {}</p>\n",
      escaped(machine.version), escaped(machine.commit), escaped(machine.processor), machine.cores,
      date_text(report.first), date_text(report.last));
  if (report.machines.size() > 1)
    text += fmt::format(
        "<p><strong>Beware:</strong> jobs ran on {} different machines or builds (listed at the "
        "end), so their times may not be comparable.</p>\n",
        report.machines.size());
  text += "<div class=\"short\">\n<h2 id=\"short\">In short</h2>\n" + compared_text(report);
  text += "<ul>\n";
  for (const SceneReport& scene : report.scenes) text += scene_sentence(scene.study);
  text +=
      "</ul>\n<p class=\"note\">2\u00d7 means: the other method takes twice as long to the same "
      "error. Above 1 ASOS is faster, below 1 it is slower; differences below 5 % are called "
      "even.</p>\n</div>\n";
  return text + verdict_table(report) + where_not(report);
}

}  // namespace asos
