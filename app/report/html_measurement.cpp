#include "app/report/html_page.h"

#include <fmt/format.h>

namespace asos {
std::string machine_text(const Machine& machine) {
  return fmt::format("<li>{}, {} cores, {:.1f} GB; {}; asos {}, commit {}, built by {}</li>\n",
                     escaped(machine.processor), machine.cores, machine.memory_gb,
                     escaped(machine.system), escaped(machine.version), escaped(machine.commit),
                     escaped(machine.compiler));
}

namespace {

std::string references_table(const StudyReport& report) {
  std::string rows;
  for (const SceneReport& scene : report.scenes) {
    std::size_t under = 0;
    for (const StudyPoint& p : scene.study.points) under += p.under_floor ? 1 : 0;
    rows += fmt::format(
        "<tr><td class=\"t\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{} of {}</td>"
        "<td class=\"t\">{}</td></tr>\n",
        escaped(scene.study.scene), count_text(static_cast<std::uint64_t>(scene.samples)),
        scene.passes, error_text(scene.study.noise), error_text(scene.study.floor), under,
        scene.study.points.size(),
        scene.quiet                        ? "noise a quarter of the smallest error"
        : scene.passes == reference_passes ? "no more passes"
                                           : "the budget ended");
  }
  return fmt::format(
      "<div class=\"scroll\"><table>\n<thead><tr><th class=\"t\">Reference of</th>"
      "<th>Samples a pixel</th><th>Passes</th><th>Noise (RMSE)</th><th>Floor</th>"
      "<th>Under the floor</th><th class=\"t\">Ended because</th></tr></thead>\n<tbody>\n{}</tbody>"
      "</table></div>\n",
      rows);
}

std::string pictures_that_differ(const StudyReport& report) {
  std::vector<std::string> words;
  for (const SceneReport& scene : report.scenes)
    for (const StudyPoint& p : scene.study.points)
      if (!p.same_picture)
        words.push_back(escaped(scene.study.scene + " " + p.rung.method + " " + p.rung.setting));
  if (words.empty()) return "All repetitions of a setting made the same picture, bit for bit.";
  return "Repetitions made pictures that differ in bits, for " + list_text(words) +
         "; errors are of the first.";
}

constexpr const char* definitions = R"html(<ul>
<li><strong>RMSE</strong>: root mean square over pixels and channels of the difference of linear
radiance, both pictures clipped to 0..1, which is what a display at exposure 0 can show.
<strong>Mean abs.</strong>: the mean of the absolute differences. <strong>99 %, 99.9 %,
max.</strong>: of pixels sorted by their own error, the root mean square over their channels.
<strong>RMSE, sRGB</strong>: after the display transform.
<strong>&Delta;E<sub>00</sub></strong>: the perceptual one, the mean over pixels of CIEDE2000
(Sharma, Wu and Dalal 2005) of the displayed colours; about 1 is just noticeable between patches side
by side.</li>
<li><strong>Time</strong>: processor seconds of all threads of the render, which a busy machine
changes least; the median of the repetitions, and &plusmn; half of their range. Loading the scene and
building what every method shares is not in it. Wall time is beside it.</li>
<li><strong>Memory</strong>: the largest resident set of the process during the render, scene
included, in 10<sup>6</sup> bytes, median. One process may still hold what an earlier render
freed.</li>
<li><strong>Reference</strong>: Owen-scrambled Sobol samples with seeds of their own, textures looked
up as points, in two independent halves; each pass doubles the samples. Its noise is the standard
error of the mean, half of the halves' RMSE against each other. An error below twice the noise, the
floor, would be more than 12 % noise: such points are marked and enter no comparison and no slope.</li>
<li><strong>While rendering</strong>: one more render of each method, which refines the whole picture
step by step as the window does: ASOS at the default EPS and MAX, others at their last setting. Its
picture is kept each time its processor time has grown by half.</li>
<li><strong>Order</strong>: all settings of all methods once, the methods taking turns, then all of
them again, so that what else the machine does meets all alike.</li>
<li><strong>Best settings</strong>: those that no other setting of the same method beats in both time
and error. Rivals are always taken at their best; for ASOS every setting is listed.</li>
<li><strong>Regions</strong>: found with ASOS at MAX 4 and EPS 1/256, the first that holds. Outlines:
pixels split for an outline, a crease, an intersection, a cut-out, or that were never resolved.
Penumbrae: split at a shadow's edge, or a light of some size is partly hidden from what the pixel's
centre shows. Reflections: split at an edge that a mirror shows, or the centre shows a surface that
mirrors (metals before penumbrae, others after). Textures: textured surfaces.</li>
</ul>
)html";

}  // namespace

std::string html_measurement(const StudyReport& report) {
  std::string text = "<h2 id=\"measurement\">How it was measured</h2>\n";
  text += definitions;
  text += references_table(report);
  text += fmt::format("<p>{} Budget for each reference: {}.</p>\n", pictures_that_differ(report),
                      seconds_text(report.plan.budget_seconds));
  text += "<h3>Machine and build</h3>\n<ul>\n";
  for (const Machine& machine : report.machines) text += machine_text(machine);
  return text +
         "</ul>\n<p class=\"note\">The numbers are in points.csv, progress.csv and report.json, "
         "the plots "
         "with their gnuplot scripts in plots/, the pictures in pictures/, all in this "
         "folder.</p>\n";
}

}  // namespace asos
