#include "app/stability_page.h"

#include "app/report/html_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace asos {
namespace {

using stability::Finding;

constexpr const char* stability_style = R"(
:root { color-scheme: light dark; }
body { font: 14px/1.4 system-ui, sans-serif; max-width: 92em; margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.15em; margin-top: 2em; }
.summary { font-size: 1.2em; font-weight: 600; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: .3em .7em .3em 0; }
th { border-bottom: 2px solid; } td { border-bottom: 1px solid #8886; }
p { max-width: 60em; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
th.number { white-space: normal; vertical-align: bottom; } th { vertical-align: bottom; }
.name { min-width: 13em; } .what { min-width: 10em; }
.why { min-width: 20em; font-size: .9em; }
tr.broken td { font-weight: 600; } tr.broken td.why { font-weight: 400; }
)";

constexpr const char* about = R"(<p>Each case measures one quantity against a closed form, an
invariance or a converged value. It is broken if its error is more than its bound, if there is no
figure at all, or if any pixel of its pictures is not a finite number. Bounds follow from the rounding
of 32-bit floats, or from the settings' tolerance, as the last column says; none was fitted to a
result. Samples that are not finite are left out of their pixels and counted here.</p>
<p>Left out, since the program does not have them: the defocusing ratio (DFR, DFRMIN, DFRMAX, N),
reflections and facing mirrors, and the texture levels of TR. Images are of 8 bits, which hold neither
NaN nor infinity, so that these are tried in colours, coordinates and lights instead.</p>
)";

constexpr const char* column_heads = R"(<div class="scroll"><table>
<thead><tr><th>Result</th><th class="name">Case</th><th class="what">Quantity</th><th class="number">Expected</th>
<th class="number">Got</th><th class="number">Error</th><th class="number">Bound</th>
<th class="number">Samples dropped</th><th class="number">Pixels not finite</th>
<th class="why">Why the bound is what it is</th></tr></thead>
<tbody>
)";

/// Quotes a CSV field.
std::string quoted_field(const std::string& text) {
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c;
  }
  return field + '"';
}

/// The last column: why a value is missing, or the reason for its bound.
const std::string& why(const Finding& finding) {
  return finding.fault.empty() ? finding.outcome.reason : finding.fault;
}

std::string row(const Finding& finding) {
  const bool held = stability::holds(finding);
  const stability::Outcome& o = finding.outcome;
  const auto number = [&](double value, const char* format) {
    return fmt::format("<td class=\"number\">{}</td>",
                       finding.fault.empty() ? fmt::format(fmt::runtime(format), value) : "none");
  };
  return fmt::format("<tr{}><td>{}</td><td>{}</td><td>{}</td>", held ? "" : " class=\"broken\"",
                     held ? "holds" : "BROKEN", escaped(finding.name), escaped(o.quantity)) +
         number(o.expected, "{:.7g}") + number(o.got, "{:.7g}") + number(o.error, "{:.2g}") +
         number(o.bound, "{:.2g}") +
         fmt::format(
             "<td class=\"number\">{}</td><td class=\"number\">{}</td><td "
             "class=\"why\">{}</td></tr>\n",
             o.rejected_samples, o.bad_pixels, escaped(why(finding)));
}

template <typename Chosen>
std::string table(const std::vector<Finding>& findings, Chosen chosen) {
  std::string html = column_heads;
  for (const Finding& finding : findings) {
    if (chosen(finding)) html += row(finding);
  }
  return html + "</tbody></table></div>\n";
}

std::vector<std::string> groups_of(const std::vector<Finding>& findings) {
  std::vector<std::string> groups;
  for (const Finding& finding : findings) {
    if (std::find(groups.begin(), groups.end(), finding.group) == groups.end())
      groups.push_back(finding.group);
  }
  return groups;
}

}  // namespace

std::string stability_csv(const std::vector<Finding>& findings) {
  std::string csv =
      "group,case,result,quantity,expected,got,error,bound,rejected_samples,pixels_not_finite,"
      "seconds,reason\n";
  for (const Finding& finding : findings) {
    const stability::Outcome& o = finding.outcome;
    const std::string figures =
        finding.fault.empty()
            ? fmt::format("{:.9g},{:.9g},{:.3g},{:.3g}", o.expected, o.got, o.error, o.bound)
            : ",,,";
    csv += fmt::format("{},{},{},{},{},{},{},{:.3f},{}\n", quoted_field(finding.group),
                       quoted_field(finding.name), stability::holds(finding) ? "holds" : "broken",
                       quoted_field(o.quantity), figures, o.rejected_samples, o.bad_pixels,
                       finding.seconds, quoted_field(why(finding)));
  }
  return csv;
}

std::string stability_page(const std::vector<Finding>& findings, bool quick_only) {
  const auto broken = std::count_if(findings.begin(), findings.end(),
                                    [](const Finding& f) { return !stability::holds(f); });
  std::uint64_t dropped = 0;
  std::uint64_t bad = 0;
  for (const Finding& finding : findings) {
    dropped += finding.outcome.rejected_samples;
    bad += finding.outcome.bad_pixels;
  }
  std::string html = page_head("ASOS: stability on stiff and extreme cases", stability_style) +
                     "<h1>Stability on stiff and extreme cases</h1>\n";
  html += fmt::format(
      "<p class=\"summary\">{} cases{}: {} hold, {} broken. Samples dropped for not being finite: "
      "{}; pixels that are not finite: {}.</p>\n",
      findings.size(), quick_only ? " (the quick part)" : "",
      static_cast<std::int64_t>(findings.size()) - broken, broken, dropped, bad);
  html += about;
  if (broken > 0) {
    html += "<h2>Broken</h2>\n";
    html += table(findings, [](const Finding& f) { return !stability::holds(f); });
  }
  for (const std::string& group : groups_of(findings)) {
    const auto in_group = [&](const Finding& f) { return f.group == group; };
    const auto count = std::count_if(findings.begin(), findings.end(), in_group);
    const auto held = std::count_if(findings.begin(), findings.end(), [&](const Finding& f) {
      return in_group(f) && stability::holds(f);
    });
    html += fmt::format("<h2>{}{}: {} of {} hold</h2>\n",
                        static_cast<char>(std::toupper(static_cast<unsigned char>(group[0]))),
                        escaped(group.substr(1)), held, count);
    html += table(findings, in_group);
  }
  return html + "</body>\n</html>\n";
}

}  // namespace asos
