#include "app/report/html_page.h"

#include <fmt/format.h>

#include <algorithm>

namespace asos {
namespace {

/// Describes the error of ASOS that remains at any run time.
std::string bias_text(const SceneStudy& study) {
  if (!study.bias)
    return fmt::format(
        "<p>ASOS's own bias beside the rendering equation: under the floor of {} RMSE.</p>\n",
        error_text(study.floor));
  const ResidualBias& bias = *study.bias;
  return fmt::format("<p>ASOS's own bias beside the rendering equation: {} {} RMSE ({}{}).</p>\n",
                     bias.levels_off ? "about" : "at most", error_text(bias.at_most),
                     escaped(bias.setting),
                     bias.levels_off ? "; twice and four times its time hardly help" : "");
}

std::string facts_text(const SceneReport& scene) {
  std::string text = fmt::format(
      "<p>{} triangles, {} lights, {:.1f} MB. Reference: {} samples a pixel, noise {} RMSE; errors "
      "below the floor of {} (twice the noise) are hardly known, marked, and not compared.{}</p>\n",
      count_text(scene.facts.triangles), scene.facts.lights, scene.facts.memory_mb,
      count_text(static_cast<std::uint64_t>(scene.samples)), error_text(scene.study.noise),
      error_text(scene.study.floor),
      scene.quiet ? " The noise is at most a quarter of the smallest error."
                  : " The reference's budget ended before its noise was a quarter of the smallest "
                    "error.");
  text += bias_text(scene.study);
  if (!scene.facts.left_out.empty()) {
    std::string items;
    for (const std::string& word : scene.facts.left_out)
      items += "<li>" + escaped(word) + "</li>\n";
    text += fmt::format(
        "<details><summary>Left out, because nothing needs it: {} features, with what that "
        "saves</summary>\n<ul class=\"note\">\n{}</ul>\n</details>\n",
        scene.facts.left_out.size(), items);
  }
  return text;
}

std::string plots_text(const SceneFigures& figures, Embedder& embed) {
  std::string text;
  for (const Plot& plot : figures.plots)
    text += fmt::format(
        "<figure class=\"plot\"><img alt=\"{0} over processor seconds\" "
        "src=\"{1}\"><figcaption>{0} "
        "over processor time; lower left is better. {2}</figcaption></figure>\n",
        escaped(plot.title), embed.uri(plot.path + ".svg"), escaped(plot.note));
  return text;
}

std::string mark_of(const StudyPoint& p) {
  std::string mark = p.under_floor ? "under the floor" : p.best ? "best of its method" : "";
  if (!p.same_picture) mark += " repetitions differ";
  if (p.rejected_samples > 0)
    mark += fmt::format(" {} samples not finite", count_text(p.rejected_samples));
  return mark;
}

/// The cells with a point's errors, in brackets if below the noise floor.
std::string error_cells(const StudyPoint& p) {
  const Measures& m = p.measures;
  std::string cells;
  for (const double value : {m.rmse, m.mae, m.p99, m.p999, m.max, m.rmse_display})
    cells += p.under_floor ? fmt::format("<td>({})</td>", error_text(value))
                           : fmt::format("<td>{}</td>", error_text(value));
  const std::string perceptual = fmt::format("{:.3f}", m.perceptual);
  return cells + "<td>" + (p.under_floor ? "(" + perceptual + ")" : perceptual) + "</td>";
}

std::string points_table(const SceneStudy& study) {
  std::string rows;
  std::string last;
  for (const StudyPoint& p : study.points) {
    std::string classes = last != p.rung.curve ? "first" : "";
    if (p.under_floor) classes += " under";
    last = p.rung.curve;
    rows += fmt::format(
        "<tr class=\"{}\"><td class=\"t\">{}</td><td class=\"t\">{}</td><td>{}</td><td>{:.0f} "
        "%</td>"
        "<td>{}</td>{}<td>{}</td><td>{}</td><td>{:.0f}</td><td class=\"t\">{}</td></tr>\n",
        classes, escaped(p.rung.method), escaped(p.rung.setting), seconds_text(p.seconds()),
        100.0 * p.spread(), seconds_text(p.wall_seconds()), error_cells(p), count_text(p.rays),
        count_text(p.pyrays), p.memory_mb(), mark_of(p));
  }
  return fmt::format(
      "<h3>All settings</h3>\n<p class=\"note\">Errors in brackets are under the floor: hardly "
      "known, and compared with nothing.</p>\n<div class=\"scroll\"><table class=\"wide\">\n"
      "<thead><tr><th class=\"t\">Method</th><th class=\"t\">Setting</th><th>Processor time</th>"
      "<th>\u00b1</th><th>Wall time</th><th>RMSE</th><th>Mean abs.</th><th>99 %</th><th>99.9 %</th>"
      "<th>Max.</th><th>RMSE, sRGB</th><th>\u0394E<sub>00</sub></th><th>Rays</th><th>Pyrays</th>"
      "<th>MB</th><th class=\"t\">Mark</th></tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
      rows);
}

/// A factor with its qualification; losses and draws are marked in words, not by colour alone.
std::string factor_cell(double factor, Reading reading, const char* loss) {
  if (reading == Reading::unreached) return "<td>not reached</td>";
  if (reading == Reading::levelled) return "<td class=\"win\">levels off above it</td>";
  const char* before = reading == Reading::extrapolated ? "~" : "";
  const char* after = reading == Reading::cheapest ? "\u2020" : "";
  const std::string number = fmt::format("{}{}\u00d7{}", before, factor_text(factor), after);
  switch (outcome_of(factor)) {
    case Outcome::win:
      return fmt::format("<td class=\"win\">{}</td>", number);
    case Outcome::even:
      return fmt::format("<td>{} even</td>", number);
    case Outcome::loss:
      break;
  }
  return fmt::format("<td class=\"loss\">{} {}</td>", number, loss);
}

template <typename Rows>
std::vector<std::string> rivals_in(const Rows& rows) {
  std::vector<std::string> rivals;
  for (const auto& row : rows)
    if (std::find(rivals.begin(), rivals.end(), row.method) == rivals.end())
      rivals.push_back(row.method);
  return rivals;
}

/// A table with ASOS's settings as rows and the rivals as columns. `fixed` and `value` name the
/// compared quantities.
template <typename Rows, typename Fixed, typename Value>
std::string comparison_table(const SceneStudy& study, const Rows& rows, const char* title,
                             const char* note, const char* loss, Fixed fixed, Value value) {
  if (rows.empty()) return "";
  const std::vector<std::string> rivals = rivals_in(rows);
  std::string head;
  for (const std::string& rival : rivals) head += "<th>" + escaped(rival) + "</th>";
  std::string body;
  for (const StudyPoint& p : study.points) {
    if (p.rung.method != "asos") continue;
    body += fmt::format("<tr{}><td class=\"t\">asos {}{}</td><td>{}</td>",
                        p.under_floor ? " class=\"under\"" : "", escaped(p.rung.setting),
                        p.best && !p.under_floor ? " (best)" : "", fixed(p));
    for (const std::string& rival : rivals) {
      const auto at = std::find_if(rows.begin(), rows.end(), [&](const auto& row) {
        return row.method == rival && row.setting == p.rung.setting;
      });
      body += at != rows.end() ? factor_cell(value(*at), at->reading, loss)
              : p.under_floor  ? "<td class=\"under\">-</td>"
                               : "<td>not measured</td>";
    }
    body += "</tr>\n";
  }
  return fmt::format(
      "<h3>{}</h3>\n<p class=\"note\">{}</p>\n<div class=\"scroll\"><table>\n<thead><tr>"
      "<th class=\"t\">ASOS setting</th><th>at</th>{}</tr></thead>\n<tbody>\n{}</tbody></table>"
      "</div>\n",
      title, note, head, body);
}

std::string comparisons_text(const SceneStudy& study) {
  return comparison_table(
             study, study.equal_error, "Speed at equal error",
             "How many times as long each method takes to the error of that ASOS setting, read off "
             "between its own best settings, both axes logarithmic. \u2020 its quickest setting is "
             "already that accurate, or more. ~ extrapolated: it was not measured that far. "
             "Not reached: nor would it get there in 16 times the time of its slowest setting.",
             "slower",
             [](const StudyPoint& p) {
               return p.under_floor ? shown_error(p) : "RMSE " + shown_error(p);
             },
             [](const EqualError& row) { return row.speedup; }) +
         comparison_table(
             study, study.equal_time, "Error in equal time",
             "The error of each method after the time of that ASOS setting, over that of ASOS. ~ "
             "extrapolated; not measured: all its settings take longer, or all less than a "
             "sixteenth.",
             "worse", [](const StudyPoint& p) { return seconds_text(p.seconds()); },
             [](const EqualTime& row) { return row.ratio; });
}

/// ASOS's picture during its render, at the times at which `sobol` finishes.
std::string while_rendering_table(const SceneStudy& study) {
  if (study.at_moments.empty()) return "";
  std::string rows;
  for (const AtMoment& row : study.at_moments) {
    const std::string ratio = row.under_floor ? "<td class=\"under\">under the floor</td>"
                              : row.ratio <= 1.0 - even_band
                                  ? fmt::format("<td class=\"win\">{:.2f}</td>", row.ratio)
                              : row.ratio < 1.0 + even_band
                                  ? fmt::format("<td>{:.2f} even</td>", row.ratio)
                                  : fmt::format("<td class=\"loss\">{:.2f} worse</td>", row.ratio);
    rows +=
        fmt::format("<tr><td class=\"t\">sobol {}</td><td>{}</td><td>{}</td><td>{}</td>{}</tr>\n",
                    escaped(row.setting), seconds_text(row.seconds), error_text(row.sobol_rmse),
                    error_text(row.asos_rmse), ratio);
  }
  return fmt::format(
      "<h3>While rendering</h3>\n<p class=\"note\">The error of ASOS's picture, while it renders "
      "at "
      "the default EPS and MAX, at the moment at which a render by sobol has finished; and its "
      "ratio to sobol's error. Below 1: ASOS is better.</p>\n<table>\n<thead><tr><th "
      "class=\"t\">When finished</th><th>at</th><th>RMSE of sobol</th><th>RMSE of ASOS</th>"
      "<th>Ratio</th></tr></thead>\n<tbody>\n{}</tbody></table>\n",
      rows);
}

std::string slopes_table(const SceneStudy& study) {
  if (study.slopes.empty()) return "";
  std::string rows;
  for (const Slope& slope : study.slopes)
    rows += fmt::format("<tr><td class=\"t\">{}</td><td>{:.2f}</td><td>{}</td></tr>\n",
                        escaped(slope.curve), slope.slope, slope.points);
  return fmt::format(
      "<h3>How quickly errors fall</h3>\n<p class=\"note\">The slope of log RMSE over log time, by "
      "least squares over the points above the floor. -0.5 is what independent random samples "
      "give; "
      "steeper is better.</p>\n<table>\n<thead><tr><th class=\"t\">Curve</th><th>Slope</th>"
      "<th>Points</th></tr></thead>\n<tbody>\n{}</tbody></table>\n",
      rows);
}

std::string regions_table(const SceneReport& scene) {
  std::string head;
  for (std::size_t r = 0; r < region_count; ++r)
    head += fmt::format("<th>{}</th>", region_names[r]);
  std::string sizes;
  const auto all = static_cast<double>(scene.regions.region.size());
  for (const std::size_t pixels : scene.region_pixels)
    sizes += fmt::format("<td>{:.1f} %</td>", 100.0 * static_cast<double>(pixels) / all);
  std::string rows;
  for (const StudyPoint* p : alike_in_time(scene.study.points)) {
    rows += fmt::format("<tr{}><td class=\"t\">{} {}{}</td><td>{}</td>",
                        p->under_floor ? " class=\"under\"" : "", escaped(p->rung.method),
                        escaped(p->rung.setting), p->under_floor ? " (under the floor)" : "",
                        seconds_text(p->seconds()));
    for (const RegionError& region : p->regions)
      rows += region.pixels == 0 ? "<td>-</td>"
                                 : fmt::format("<td>{} ({:.0f} %)</td>", error_text(region.rmse),
                                               100.0 * region.share);
    rows += "</tr>\n";
  }
  return fmt::format(
      "<h3>Error by what a pixel shows</h3>\n<p class=\"note\">RMSE within each region and, in "
      "brackets, the region's share of the picture's squared error; one setting of each method, "
      "those most alike in time.</p>\n<div class=\"scroll\"><table>\n<thead><tr>"
      "<th class=\"t\">Setting</th><th>Time</th>{}</tr></thead>\n<tbody>\n<tr><td class=\"t\">"
      "<em>share of the pixels</em></td><td></td>{}</tr>\n{}</tbody></table></div>\n",
      head, sizes, rows);
}

}  // namespace

std::string html_scene(const SceneReport& scene, const SceneFigures& figures, std::size_t number,
                       Embedder& embed) {
  return fmt::format("<h2 id=\"scene{}\">{}</h2>\n", number, escaped(scene.study.scene)) +
         facts_text(scene) + plots_text(figures, embed) + comparisons_text(scene.study) +
         while_rendering_table(scene.study) + slopes_table(scene.study) + regions_table(scene) +
         html_pictures(scene, figures.pictures, number, embed) + points_table(scene.study);
}

}  // namespace asos
