#include "app/report/flicker_files.h"
#include "app/report/html_page.h"
#include "app/report/html_style.h"
#include "app/report/pictures.h"

#include <fmt/format.h>

#include <algorithm>

namespace asos {
namespace {

std::string flicker_frames_text(const FlickerStudy& study) {
  const std::string name = study.animation.empty() ? fmt::format("{}", study.animation_number)
                                                   : "\u201c" + study.animation + "\u201d";
  return fmt::format("frames {} to {} of its animation {} at {} a second, {}\u00d7{} pixels",
                     study.first_frame, study.first_frame + study.frames - 1, escaped(name),
                     study.fps, study.width, study.height);
}

/// Compares the anchor with each rival in one sentence.
std::string flicker_verdict(const FlickerStudy& study) {
  const FlickerPoint* anchor = anchor_of(study.points);
  if (!anchor) return "<p>Nothing could be measured.</p>\n";
  std::vector<std::string> words;
  for (const FlickerAtEqualTime& row : study.equal_time)
    if (row.setting == anchor->rung.setting)
      words.push_back(fmt::format("{} with {} ({}{}\u00d7{})", error_text(row.rival_flicker),
                                  escaped(row.method), row.at_least ? "at least " : "",
                                  factor_text(row.ratio()),
                                  row.reading == Reading::measured       ? ""
                                  : row.reading == Reading::extrapolated ? ", extrapolated"
                                                                         : ", which takes longer"));
  return fmt::format(
      "<p>{} {} takes {} of processor time a frame; its flicker is {}, its RMSE {}. In the same "
      "time flicker is {}</p>\n",
      escaped(anchor->rung.method), escaped(anchor->rung.setting), seconds_text(anchor->seconds()),
      anchor->under_floor ? "under the floor of " + error_text(study.floor)
                          : error_text(anchor->meter.flicker()),
      error_text(anchor->meter.rmse()),
      words.empty() ? "known of no other." : list_text(words) + ".");
}

std::string flicker_table(const FlickerStudy& study) {
  std::string rows, method;
  for (const FlickerPoint& p : study.points) {
    const bool first = p.rung.method != method;
    method = p.rung.method;
    rows += fmt::format(
        "<tr class=\"{}{}\"><td class=\"t\">{}</td><td class=\"t\">{}</td><td>{}</td><td>{}</td>"
        "<td>{}</td><td>{}</td><td>{}</td></tr>\n",
        first ? "first" : "", p.under_floor ? " under" : "", escaped(method),
        escaped(p.rung.setting), seconds_text(p.seconds()), error_text(p.meter.rmse()),
        error_text(p.meter.flicker()), error_text(p.meter.steady()), error_text(p.meter.step()));
  }
  return fmt::format(
      "<div class=\"scroll\"><table>\n<caption>Grey: under the floor of {}, hardly known.</caption>"
      "\n<thead><tr><th class=\"t\">Method</th><th class=\"t\">Setting</th><th>Processor time a "
      "frame</th><th>RMSE</th><th>Flicker</th><th>Steady error</th><th>From frame to frame</th>"
      "</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
      error_text(study.floor), rows);
}

std::string equal_time_rows(const FlickerStudy& study) {
  std::string rows;
  for (const FlickerAtEqualTime& row : study.equal_time) {
    const Outcome outcome = outcome_of(row.ratio());
    rows += fmt::format(
        "<tr><td class=\"t\">{}</td><td class=\"t\">{}</td><td>{}</td><td>{}</td><td>{}</td>"
        "<td class=\"{}\">{}{}</td><td class=\"t\">{}</td></tr>\n",
        escaped(row.setting), escaped(row.method), seconds_text(row.seconds),
        error_text(row.asos_flicker), error_text(row.rival_flicker),
        outcome == Outcome::win    ? "win"
        : outcome == Outcome::loss ? "loss"
                                   : "",
        row.at_least ? "at least " : "", factor_text(row.ratio()),
        row.reading == Reading::measured       ? ""
        : row.reading == Reading::extrapolated ? "extrapolated"
                                               : "its quickest setting, which takes longer");
  }
  return fmt::format(
      "<div class=\"scroll\"><table>\n<thead><tr><th class=\"t\">ASOS</th><th class=\"t\">beside"
      "</th><th>Time a frame</th><th>Flicker of ASOS</th><th>of the other</th><th>Ratio</th>"
      "<th class=\"t\"></th></tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
      rows);
}

std::string figure(const std::string& label, const std::string& uri, const char* style) {
  return fmt::format(
      "<figure><img class=\"{2}\" alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>\n",
      escaped(label), uri, style);
}

std::string strips_text(const FlickerStudy& study, const FlickerFigures& figures, Embedder& embed) {
  std::string strips, maps;
  for (const ShownStrip& strip : figures.strips) {
    const std::string label =
        strip.point
            ? fmt::format("{} ({}, flicker {})", strip.label, seconds_text(strip.point->seconds()),
                          error_text(strip.point->meter.flicker()))
            : fmt::format("reference ({} samples a pixel)", study.samples);
    strips += figure(label, embed.uri(strip.frames), "strip");
    if (!strip.point) continue;
    strips += figure("errors of " + strip.label, embed.uri(strip.errors), "strip");
    maps += figure("flicker of " + strip.label, embed.uri(strip.flicker), "");
  }
  return fmt::format(
      "<h3>Film strip</h3>\n<p class=\"note\">Frames {} to {}, the part of {}\u00d7{} pixels from "
      "{}, {} in which they differ most; of each method the setting that takes most nearly as long "
      "as ASOS's. Errors and flicker of a pixel, all on one scale: 0<span class=\"ramp\"></span>{} "
      "and more.</p>\n{}<h3>Flicker of the whole picture</h3>\n<div class=\"grid\">\n{}</div>\n",
      study.first_frame + study.strip_first,
      study.first_frame + study.strip_first + static_cast<int>(study.strip.size()) - 1,
      study.strip_part.width, study.strip_part.height, study.strip_part.x, study.strip_part.y,
      error_text(figures.error_scale), strips, maps);
}

std::string flicker_section(const FlickerStudy& study, const FlickerFigures& figures,
                            Embedder& embed) {
  std::string text =
      fmt::format("<h2>{}</h2>\n<p>{}.</p>\n<div class=\"short\">{}</div>\n", escaped(study.scene),
                  flicker_frames_text(study), flicker_verdict(study));
  text += "<h3>In the time of ASOS</h3>\n" + equal_time_rows(study);
  for (const std::string& plot : figures.plots)
    text += fmt::format(
        "<figure class=\"plot\"><img alt=\"over processor seconds of a frame\" src=\"{}\">"
        "<figcaption>Over the processor time of a frame; lower left is better. Bars reach from the "
        "quickest frame to the slowest.</figcaption></figure>\n",
        embed.uri(plot + ".svg"));
  text += strips_text(study, figures, embed);
  text += "<h3>All settings</h3>\n" + flicker_table(study);
  if (!study.timed_out.empty())
    text += "<p class=\"note\">Given up, for they take too long: " +
            escaped(list_text(study.timed_out)) + ".</p>\n";
  return text + fmt::format(
                    "<p class=\"note\">References: {} samples a pixel in every frame, with the "
                    "same points, so that their noise stays where nothing moves; noise {} RMSE. "
                    "Measured {} on:</p>\n<ul class=\"note\">\n{}</ul>\n",
                    study.samples, error_text(study.noise), escaped(study.when),
                    machine_text(study.machine));
}

constexpr const char* flicker_definitions = R"html(<h2>What was measured</h2>
<ul>
<li><strong>Error</strong> of a pixel in a frame: the difference of linear radiance from the frame's
own reference, channel by channel, both clipped to 0..1.</li>
<li><strong>Flicker</strong>: the root mean square, over frames, pixels and channels, of the error
less the mean over all frames of the same pixel's and channel's error. An error that stays as it is
does not flicker, whatever its size.</li>
<li><strong>Steady error</strong>: the root mean square of those means.
RMSE<sup>2</sup> = flicker<sup>2</sup> + steady<sup>2</sup>.</li>
<li><strong>From frame to frame</strong>: the root mean square of the change of the error from a frame
to the next. Errors as independent as new samples change by &radic;2 times their flicker.</li>
<li><strong>References</strong> are two halves with noise of their own. Squares of errors are estimated
by the product of the errors against the two, in which the noise cancels. <strong>Floor</strong>: what
is left of it makes flicker below this hardly known; where ASOS's is, the floor is compared in its place,
and the ratio is "at least".</li>
<li><strong>In the time of ASOS</strong>: between a rival's settings, both axes logarithmic; those
that another one of the same method beats in both are left out. A ratio above 1: ASOS flickers
less.</li>
<li><strong>Settings</strong>: of each curve of a method those that take less time for the first
frame than ASOS at MAX 3, EPS 1/256, and the next one.</li>
</ul>
)html";

}  // namespace

Result<std::string> flicker_page(const std::vector<FlickerStudy>& studies,
                                 const std::vector<FlickerFigures>& figures) {
  Embedder embed;
  std::string page =
      page_head("ASOS report: flicker of animations", report_style) +
      "<h1>Flicker of animations</h1>\n<p class=\"sub\">How errors vary from frame to frame, ASOS "
      "beside other methods in the same time.</p>\n";
  for (std::size_t i = 0; i < studies.size(); ++i)
    page += flicker_section(studies[i], figures[i], embed);
  page += flicker_definitions;
  page += "</body>\n</html>\n";
  if (embed.error()) return tl::unexpected(*embed.error());
  return page;
}

}  // namespace asos
