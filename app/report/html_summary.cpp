#include "app/report/html_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace asos {
namespace {

std::string name_of_method(const std::string& method) {
  return method == "asos-published" ? "asos-published (ASOS as the papers have it)" : method;
}

std::string range_text(const MethodComparison& v) {
  if (v.measured() == 0) return "";
  if (v.least == v.most) return factor_text(v.median) + "\u00d7";
  return fmt::format("{}\u00d7; {} to {}", factor_text(v.median), factor_text(v.least),
                     factor_text(v.most));
}

/// Lists, in words, the settings of ASOS whose error the rival was not measured at.
std::string beyond_text(const MethodComparison& v) {
  std::vector<std::string> words;
  if (v.extrapolated > 0)
    words.push_back(fmt::format("about {}\u00d7 at {}, extrapolated", factor_text(v.beyond_median),
                                v.extrapolated));
  if (v.levelled > 0)
    words.push_back(fmt::format("at {} the other levels off above ASOS's error", v.levelled));
  if (v.unreached > 0)
    words.push_back(
        fmt::format("at {} the other was not measured long enough to tell", v.unreached));
  return list_text(words);
}

/// States the result of a comparison in words.
std::string plain_verdict(const MethodComparison& v) {
  const int count = v.measured();
  if (count == 0) return v.beyond() > 0 ? beyond_text(v) : "not measured";
  if (v.wins == count) return "ASOS wins";
  if (v.losses == count) return "ASOS loses";
  if (v.evens == count) return "even";
  if (v.losses == 0) return fmt::format("ASOS wins {} of {}, the rest even", v.wins, count);
  if (v.wins == 0) return fmt::format("ASOS loses {} of {}, the rest even", v.losses, count);
  return fmt::format("depends: ASOS wins {}, loses {} of {}", v.wins, v.losses, count);
}

std::string verdict_text(const MethodComparison& v) {
  if (v.beyond() == 0 || v.measured() == 0) return plain_verdict(v);
  return fmt::format("{} (and {})", plain_verdict(v), beyond_text(v));
}

const char* class_of(const MethodComparison& v) {
  return v.losses > 0 ? "loss" : v.wins > 0 ? "win" : "";
}

template <typename Rows>
std::optional<MethodComparison> verdict_on(const Rows& rows, const std::string& method) {
  for (const MethodComparison& v : verdicts(rows))
    if (v.method == method) return v;
  return std::nullopt;
}

/// "uniform (5.2x), stochastic (3.1x)": the rivals that `wanted` selects.
template <typename Wanted>
std::string rivals_where(const SceneStudy& study, Wanted wanted) {
  std::vector<std::string> words;
  for (const MethodComparison& v : verdicts(study.equal_error))
    if (wanted(v)) words.push_back(fmt::format("{} ({})", escaped(v.method), range_text(v)));
  return list_text(words);
}

std::string scene_sentence(const SceneStudy& study) {
  const auto measured = [](const MethodComparison& v) { return v.measured() > 0; };
  const std::string won = rivals_where(
      study, [&](const MethodComparison& v) { return measured(v) && v.losses == 0 && v.wins > 0; });
  const std::string lost = rivals_where(
      study, [&](const MethodComparison& v) { return measured(v) && v.losses > 0 && v.wins == 0; });
  const std::string mixed =
      rivals_where(study, [](const MethodComparison& v) { return v.losses > 0 && v.wins > 0; });
  const std::string even = rivals_where(study, [&](const MethodComparison& v) {
    return measured(v) && v.losses == 0 && v.wins == 0;
  });
  std::vector<std::string> parts;
  if (!won.empty()) parts.push_back("is <strong>faster</strong> than " + won);
  if (!mixed.empty())
    parts.push_back("is <strong>faster or slower depending on the quality</strong> against " +
                    mixed);
  if (!lost.empty()) parts.push_back("is <strong>slower</strong> than " + lost);
  if (!even.empty()) parts.push_back("is even with " + even);
  for (const MethodComparison& v : verdicts(study.equal_error))
    if (!measured(v) && v.beyond() > 0)
      parts.push_back("was not held against " + escaped(v.method) +
                      " at an error that both reached (" + beyond_text(v) + ")");
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "; it ") + part;
  if (text.empty()) text = "could not be compared with any other method above the floor";
  return fmt::format("<li><strong>{}</strong>: for the same error ASOS {}.</li>\n",
                     escaped(study.scene), text);
}

bool was_measured(const MethodComparison& v) {
  return v.measured() > 0;
}

/// The largest RMSE such that ASOS's best settings are faster than the rival at it and at all
/// smaller ones; 0: none.
double faster_below(const SceneStudy& study, const std::string& method) {
  double won = 0.0;
  double lost = std::numeric_limits<double>::infinity();
  const auto counts = [&](const EqualError& row) {
    return row.method == method && row.best &&
           (row.reading == Reading::measured || row.reading == Reading::cheapest);
  };
  for (const EqualError& row : study.equal_error)
    if (counts(row) && outcome_of(row.speedup) != Outcome::win) lost = std::min(lost, row.rmse);
  for (const EqualError& row : study.equal_error)
    if (counts(row) && row.rmse < lost) won = std::max(won, row.rmse);
  return won;
}

/// "sobol (0.34x to 3.48x; ASOS is faster from RMSE 1e-3 down)".
std::string lost_words(const SceneStudy& study, const MethodComparison& v) {
  std::string words = fmt::format("{} ({}\u00d7 to {}\u00d7", escaped(v.method),
                                  factor_text(v.least), factor_text(v.most));
  const double below = faster_below(study, v.method);
  if (below > 0.0) words += "; ASOS is faster from RMSE " + error_text(below) + " down";
  return words + ")";
}

/// The main result of the report.
std::string headline(const StudyReport& report) {
  std::vector<std::string> won;
  std::string items;
  std::size_t compared = 0;
  for (const SceneReport& scene : report.scenes) {
    const auto rows = verdicts(scene.study.equal_error);
    if (std::none_of(rows.begin(), rows.end(), was_measured)) continue;
    ++compared;
    std::vector<std::string> depends;
    std::vector<std::string> slower;
    for (const MethodComparison& v : rows)
      if (v.losses > 0) (v.wins > 0 ? depends : slower).push_back(lost_words(scene.study, v));
    if (depends.empty() && slower.empty()) {
      won.push_back(escaped(scene.study.scene));
      continue;
    }
    items += fmt::format("<li>{}: ", escaped(scene.study.scene));
    if (!slower.empty()) items += "<strong>slower</strong> than " + list_text(slower);
    if (!depends.empty())
      items += fmt::format("{}<strong>it depends on the quality</strong> against {}",
                           slower.empty() ? "" : "; ", list_text(depends));
    items += ".</li>\n";
  }
  if (compared == 0) return "";
  std::string text = fmt::format(
      "<p><strong>Who won:</strong> to reach the same error, ASOS takes no longer than any other "
      "method, whatever the quality, on <strong>{} of {}</strong> scene{}{}.",
      won.size(), compared, compared == 1 ? "" : "s", won.empty() ? "" : ": " + list_text(won));
  if (!items.empty())
    text += " On the others:</p>\n<ul>\n" + items + "</ul>\n";
  else
    text += "</p>\n";
  return text;
}

std::string matrix_cell(const SceneStudy& study, const std::string& method) {
  const auto v = verdict_on(study.equal_error, method);
  if (!v) return "<td>-</td>";
  if (!was_measured(*v)) {
    if (v->extrapolated > 0)
      return fmt::format("<td>~{}\u00d7</td>", factor_text(v->beyond_median));
    if (v->levelled > 0) return "<td class=\"win\">levels off above it</td>";
    return v->unreached > 0 ? "<td>not reached</td>" : "<td>-</td>";
  }
  const std::string factor = factor_text(v->median) + "\u00d7";
  if (v->losses > 0 && v->wins > 0)
    return fmt::format("<td class=\"loss\">depends, {}\u00d7 to {}\u00d7</td>",
                       factor_text(v->least), factor_text(v->most));
  if (v->losses > 0) return fmt::format("<td class=\"loss\">{} slower</td>", factor);
  if (v->wins == 0) return fmt::format("<td>{} even</td>", factor);
  return fmt::format("<td class=\"win\">{}</td>", factor);
}

/// A matrix of scenes and methods: each method's time relative to ASOS for the same error.
std::string matrix(const StudyReport& report) {
  std::vector<std::string> methods;
  for (const SceneReport& scene : report.scenes)
    for (const MethodComparison& v : verdicts(scene.study.equal_error))
      if (std::find(methods.begin(), methods.end(), v.method) == methods.end())
        methods.push_back(v.method);
  if (methods.empty()) return "";
  std::string head;
  for (const std::string& method : methods) head += "<th>" + escaped(method) + "</th>";
  std::string rows;
  for (std::size_t i = 0; i < report.scenes.size(); ++i) {
    const SceneStudy& study = report.scenes[i].study;
    rows += fmt::format("<tr><td class=\"t\"><a href=\"#scene{}\">{}</a></td>", i + 1,
                        escaped(study.scene));
    for (const std::string& method : methods) rows += matrix_cell(study, method);
    rows += "</tr>\n";
  }
  return fmt::format(
      "<div class=\"scroll\"><table>\n<caption>Time of each method over that of ASOS, to the same "
      "error: the median over ASOS's best settings. 2\u00d7: the other takes twice as long; below "
      "1 ASOS is slower; within 5 % is even. ~: extrapolated, the other was not measured that far. "
      "Not reached: nor would 16 times its longest run do.</caption>\n<thead><tr><th "
      "class=\"t\">Scene</th>{}"
      "</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
      head, rows);
}

std::string verdict_table(const StudyReport& report) {
  std::string rows;
  for (const SceneReport& scene : report.scenes) {
    bool first = true;
    for (const MethodComparison& error : verdicts(scene.study.equal_error)) {
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
      "<details><summary>At the same error and in the same time, with the range</summary>\n"
      "<div class=\"scroll\"><table>\n<caption>ASOS at its best settings against each method at "
      "its best. Median, and least to most, over ASOS's settings.</caption>\n"
      "<thead><tr><th class=\"t\">Scene</th><th class=\"t\">Against</th>"
      "<th class=\"t\">Same error: who is faster</th><th>its time / ASOS's</th>"
      "<th class=\"t\">Same time: who is more accurate</th><th>its error / ASOS's</th></tr></thead>"
      "\n"
      "<tbody>\n{}</tbody></table></div>\n</details>\n",
      rows);
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

/// Says how many of ASOS's settings could not be compared, because the references were too noisy.
std::string incomparable_text(const StudyReport& report) {
  std::vector<std::string> words;
  for (const SceneReport& scene : report.scenes) {
    const NoiseFloorCount found = incomparable(scene.study);
    if (found.under_floor > 0)
      words.push_back(fmt::format("{} of {} on {}", found.under_floor, found.settings,
                                  escaped(scene.study.scene)));
  }
  if (words.empty()) return "";
  return "<p><strong>Not compared:</strong> settings of ASOS whose error is less than twice the "
         "noise of the reference, " +
         list_text(words) + ". A longer --budget tells more.</p>\n";
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
  text += headline(report) + matrix(report) + incomparable_text(report);
  text +=
      "<p class=\"note\">Small pictures put more edges into each pixel than large ones, which "
      "is hard on ASOS: read ratios together with the size. <a href=\"#losses\">Where ASOS does "
      "not win</a>: below, all of it.";
  if (report.plan.paper) text += " <a href=\"#paper\">Beside what was published</a>: at the end.";
  text += "</p>\n</div>\n<h3>Scene by scene</h3>\n<ul>\n";
  for (const SceneReport& scene : report.scenes) text += scene_sentence(scene.study);
  return text + "</ul>\n" + verdict_table(report) + html_losses(report);
}

}  // namespace asos
