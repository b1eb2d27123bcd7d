#include "app/report/html_page.h"
#include "app/report/method_faults.h"
#include "app/report/report_data.h"
#include "app/report/subdivision_tables.h"
#include "renderer/study/primitive_costs.h"

#include <fmt/format.h>

namespace asos {
namespace {

/// A table cell with a factor, and a word if ASOS does not win.
std::string ratio_cell(double ratio, const char* before = "", const char* after = "") {
  if (!(ratio > 0.0)) return "<td>-</td>";
  const std::string number = fmt::format("{}{}\u00d7{}", before, factor_text(ratio), after);
  switch (outcome_of(ratio)) {
    case Outcome::win:
      return fmt::format("<td class=\"win\">{}</td>", number);
    case Outcome::even:
      return fmt::format("<td>{} even</td>", number);
    case Outcome::loss:
      break;
  }
  return fmt::format("<td class=\"loss\">{} slower</td>", number);
}

std::string equal_error_cell(const PaperRow& row) {
  if (row.under_floor) return "<td class=\"under\">under the floor</td>";
  if (!row.equal_error) return "<td>-</td>";
  const Reading reading = row.equal_error->reading;
  if (reading == Reading::unreached) return "<td>not reached</td>";
  if (reading == Reading::levelled) return "<td class=\"win\">levels off above it</td>";
  return ratio_cell(row.equal_error->speedup, reading == Reading::extrapolated ? "~" : "",
                    reading == Reading::cheapest ? "\u2020" : "");
}

std::string published_minutes(const PaperCase& published) {
  const std::string rival =
      published.rival_minutes > 0.0 ? fmt::format("{:.2f}", published.rival_minutes) : "-";
  return fmt::format("{:.2f} / {}", published.asos_minutes, rival);
}

std::string case_row(const PaperRow& row) {
  const PaperCase& published = *row.published;
  const bool compared = row.ratio() > 0.0;
  const bool first = row.method == "asos";
  return fmt::format(
             "<tr{}><td>{}</td><td class=\"t\">{}</td><td "
             "class=\"t\">{}</td><td>{}</td><td>{}</td>",
             first ? " class=\"first\"" : "", first ? published.figure : "",
             first ? escaped(published.image) : "", first ? escaped(published.settings) : "",
             first ? published_minutes(published) : "",
             first && published.rival_minutes > 0.0 ? factor_text(row.published_ratio()) + "\u00d7"
                                                    : "") +
         fmt::format("<td class=\"t\">{}</td>", escaped(row.method)) + ratio_cell(row.ratio()) +
         equal_error_cell(row) +
         fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"t\">{}</td></tr>\n",
                     seconds_text(row.asos_seconds), error_text(row.asos_rmse),
                     compared ? seconds_text(row.rival_seconds) : "-",
                     compared ? error_text(row.rival_rmse) : "-", escaped(row.scene));
}

/// Counts the published cases that ASOS wins here, and those won by the published ratio or
/// more.
std::string cases_sentence(const std::vector<PaperRow>& rows) {
  int compared = 0;
  int won = 0;
  int as_published = 0;
  for (const PaperRow& row : rows) {
    if (row.method != "asos" || !(row.published_ratio() > 0.0) || !(row.ratio() > 0.0)) continue;
    ++compared;
    won += outcome_of(row.ratio()) == Outcome::win ? 1 : 0;
    as_published += row.ratio() >= row.published_ratio() ? 1 : 0;
  }
  if (compared == 0) return "";
  return fmt::format(
      "<p>Of the {} cases with a published time of stochastic sampling, <em>asos</em> with the "
      "paper's settings is faster here in <strong>{}</strong>, and by the published ratio or more "
      "in <strong>{}</strong>.</p>\n",
      compared, won, as_published);
}

std::string cases_table(const std::vector<PaperRow>& all) {
  std::string rows;
  for (const PaperRow& row : all) rows += case_row(row);
  return fmt::format(
      "<div class=\"scroll\"><table class=\"wide\">\n<thead><tr><th>Figure</th>"
      "<th class=\"t\">Image</th><th class=\"t\">ASOS</th>"
      "<th>Published minutes, ASOS / stochastic</th><th>Published ratio</th>"
      "<th class=\"t\">Method here</th><th>Ratio here, same samples</th>"
      "<th>Ratio here, same error</th><th>ASOS time</th><th>RMSE</th><th>Stochastic time</th>"
      "<th>RMSE</th><th class=\"t\">Scene here</th></tr></thead>\n<tbody>\n{}</tbody></table></div>"
      "\n",
      rows);
}

std::string rows_text(const std::vector<SubdivisionRow>& rows) {
  std::string text;
  for (const SubdivisionRow& row : rows)
    text += fmt::format("{}K {}: M {}, in {}, out {}, {:.4f}", text.empty() ? "" : "<br>",
                        row.level, row.marginal, row.in, row.out, row.change);
  return text;
}

bool same_counts(const SubdivisionTable& table) {
  if (table.published.size() != table.measured.size()) return false;
  for (std::size_t i = 0; i < table.published.size(); ++i) {
    const SubdivisionRow& a = table.published[i];
    const SubdivisionRow& b = table.measured[i];
    if (a.level != b.level || a.marginal != b.marginal || a.in != b.in || a.out != b.out)
      return false;
  }
  return true;
}

std::string subdivision_text() {
  const auto tables = subdivision_tables();
  if (!tables) return "<p>" + escaped(tables.error().message()) + "</p>\n";
  std::string rows;
  for (const SubdivisionTable& table : *tables)
    rows += fmt::format(
        "<tr><td class=\"t\">{}</td><td class=\"t\">{}</td><td class=\"t\">{}</td>"
        "<td class=\"t\">{}</td></tr>\n",
        table.title, rows_text(table.published), rows_text(table.measured),
        same_counts(table) ? "the same" : "different");
  return fmt::format(
      "<h3>Tables 1 and 2 of GI'93: how a pixel is subdivided</h3>\n<p class=\"note\">One pixel "
      "with EPS 1/16: marginal pyrays M at each level, how many of their axes hit (in) and "
      "miss (out), and the change that is still possible. The paper's drawings have no "
      "coordinates; the polygons here were chosen to give the same counts, so this shows that the "
      "rule counts as published, not that a picture is the same.</p>\n<div class=\"scroll\"><table>"
      "\n<thead><tr><th class=\"t\">Table</th><th class=\"t\">Published</th><th class=\"t\">Here"
      "</th><th class=\"t\">Counts</th></tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
      rows);
}

std::string primitives_text() {
  constexpr int rounds = 5;
  std::string rows;
  for (const PrimitiveCost& cost : primitive_costs(rounds))
    rows += fmt::format(
        "<tr><td class=\"t\">{}</td><td>{:.2f}</td><td>{:.2f}</td><td>{:.0f} ns</td>"
        "<td>{:.0f} ns</td><td>{}</td></tr>\n",
        cost.name, cost.published, cost.factor(), cost.ray_ns, cost.cone_ns,
        cost.square_ns > 0.0 ? fmt::format("{:.0f} ns", cost.square_ns) : "-");
  return fmt::format(
      "<h3>Table 3 of GI'93: a cone's test over a ray's</h3>\n<p class=\"note\">How much longer "
      "the "
      "in-out test of a pyray's cone takes than that of a ray, primitive by primitive; measured "
      "when this page was written. The last column is what this program does instead for curved "
      "faces: finding their exact outline in the pyray's square, which the published test does "
      "not.</p>\n<table>\n<thead><tr><th class=\"t\">Primitive</th><th>Published factor</th>"
      "<th>Factor here</th><th>Ray</th><th>Cone</th><th>Outline in the square</th></tr></thead>\n"
      "<tbody>\n{}</tbody></table>\n",
      rows);
}

std::string faults_text() {
  const auto faults = method_faults();
  if (!faults) return "<p>" + escaped(faults.error().message()) + "</p>\n";
  std::string heads, rows;
  for (const MethodFaults& method : *faults) heads += "<th>" + method.method + "</th>";
  for (std::size_t i = 0; i < fault_subjects.size(); ++i) {
    rows += fmt::format("<tr><td class=\"t\">{}</td><td class=\"t\">{}</td>",
                        fault_subjects[i].name, fault_subjects[i].right);
    for (const MethodFaults& method : *faults)
      rows += fmt::format("<td>{:.4f}</td>", method.errors[i]);
    rows += "</tr>\n";
  }
  return fmt::format(
      "<h3>What methods get wrong that know only fractions of a pixel</h3>\n<p class=\"note\">"
      "CGF'98 sections 2.7 and 2.8, on <code>builtin:cards</code> at 160 by 90 pixels. "
      "<em>cone</em> "
      "and <em>covers</em> keep how much of a pixel each surface covers, not where: of two "
      "surfaces "
      "that each cover half they cannot tell whether one hides the other or both fill the pixel. "
      "<em>mask</em> keeps where, by 64 points, and misses what is thinner than their distance. "
      "Numbers are root mean square errors of linear radiance (white is 1) in the part of the "
      "picture; in the last row over eight pictures. "
      "<em>sobol</em> takes 16 samples. Indirect light is the same for all: "
      "none, or one bounce of diffuse light.</p>\n"
      "<div class=\"scroll\"><table>\n<thead><tr><th class=\"t\">Subject</th>"
      "<th class=\"t\">Right</th>{}</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
      heads, rows);
}

}  // namespace

std::string html_paper(const StudyReport& report) {
  const std::vector<PaperRow> rows = paper_rows(report);
  return "<h2 id=\"paper\">Beside what was published</h2>\n" + cases_sentence(rows) +
         "<p class=\"note\">CGF'98 table 2 and section 7.4: the time of stochastic sampling over "
         "that of ASOS, for pictures that its authors called comparable, on a machine of their "
         "time. Here the same MAX, EPS, TR and samples run on this program's own scenes, which are "
         "like the paper's in kind only. <em>asos</em> is this program's ASOS, "
         "<em>asos-published</em> the papers' rules. <em>Same samples</em>: as published, "
         "with as many samples as the authors took; the errors beside it show how comparable the "
         "pictures are. <em>Same error</em>: how long stochastic sampling takes here to the very "
         "error of that ASOS picture (\u2020 its quickest setting is that accurate already, ~ "
         "extrapolated). Above 1 ASOS is faster.</p>\n" +
         cases_table(rows) + faults_text() + subdivision_text() + primitives_text();
}

}  // namespace asos
