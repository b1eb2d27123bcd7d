#include "app/report/html_page.h"
#include "app/report/report_data.h"
#include "app/report/subdivision_tables.h"

#include <fmt/format.h>

namespace asos {
namespace {

std::string case_row(const PaperRow& row) {
  const std::string published =
      row.published_ratio > 0.0 ? fmt::format("{:.1f}\u00d7", row.published_ratio) : "-";
  const std::string head =
      fmt::format("<tr><td>{}</td><td class=\"t\">{}</td><td class=\"t\">{}</td><td>{}</td>",
                  row.figure, escaped(row.image), escaped(row.settings), published);
  if (!row.missing.empty())
    return head + fmt::format(
                      "<td class=\"t under\" colspan=\"7\">not in this program yet: {}</td>"
                      "</tr>\n",
                      escaped(row.missing));
  const bool compared = row.ratio() > 0.0;
  const char* outcome = !compared                                  ? ""
                        : outcome_of(row.ratio()) == Outcome::loss ? " slower"
                        : outcome_of(row.ratio()) == Outcome::even ? " even"
                                                                   : "";
  return head +
         fmt::format(
             "<td class=\"{}\">{}{}</td><td class=\"t\">{}</td><td class=\"t\">{}</td><td>{}</td>"
             "<td>{}</td><td>{}</td><td>{}</td></tr>\n",
             *outcome == '\0' ? "" : "loss", compared ? factor_text(row.ratio()) + "\u00d7" : "-",
             outcome, escaped(row.method), escaped(row.scene), seconds_text(row.asos_seconds),
             error_text(row.asos_rmse), compared ? seconds_text(row.rival_seconds) : "-",
             compared ? error_text(row.rival_rmse) : "-");
}

std::string cases_table(const StudyReport& report) {
  std::string rows;
  for (const PaperRow& row : paper_rows(report)) rows += case_row(row);
  return fmt::format(
      "<div class=\"scroll\"><table>\n<thead><tr><th>Figure</th><th class=\"t\">Image</th>"
      "<th class=\"t\">ASOS</th><th>Published ratio</th><th>Ratio here</th><th class=\"t\">Method"
      "</th><th class=\"t\">Scene here</th><th>ASOS time</th><th>RMSE</th><th>Stochastic time</th>"
      "<th>RMSE</th></tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
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
      "<h3>Tables of GI'93</h3>\n<p class=\"note\">Tables 1 and 2 follow the subdivision of one "
      "pixel with EPS 1/16: marginal pyrays M at each level, how many of their axes hit (in) and "
      "miss (out), and the change that is still possible. The papers' drawings have no "
      "coordinates; "
      "the polygons here were chosen to give the same counts, so this shows that the rule counts "
      "as "
      "published, not that a picture is the same.</p>\n<div class=\"scroll\"><table>\n<thead><tr>"
      "<th class=\"t\">Table</th><th class=\"t\">Published</th><th class=\"t\">Here</th>"
      "<th class=\"t\">Counts</th></tr></thead>\n<tbody>\n{}"
      "<tr><td class=\"t\">GI'93 table 3: cone against ray intersection of six primitives</td>"
      "<td class=\"t\">factors of 1.01 to 5.40</td><td class=\"t under\" colspan=\"2\">not in this "
      "program: pyrays are tested against boundaries of triangles, there are no intersections of "
      "cones with primitives</td></tr>\n</tbody></table></div>\n",
      rows);
}

}  // namespace

std::string html_paper(const StudyReport& report) {
  return "<h2 id=\"paper\">Beside what was published</h2>\n<p class=\"note\">CGF'98 table 2 and "
         "section 7.4: the time of stochastic sampling over that of ASOS, for pictures that its "
         "authors called comparable, on a machine of their time. Here the same MAX, EPS and "
         "samples "
         "run on this program's own scenes, which are like the papers' in kind only; the errors "
         "show how comparable the pictures are. <em>asos</em> is this program's ASOS, "
         "<em>asos-published</em> the papers' rules. Above 1 ASOS is faster.</p>\n" +
         cases_table(report) + subdivision_text();
}

}  // namespace asos
