#include "app/report/html_page.h"

#include "app/report/html_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace asos {
namespace {

/// The scene's name, for a file without its folders.
std::string title_of(const StudyScene& scene) {
  StudyScene titled = scene;
  if (!scene.source.starts_with("builtin:"))
    titled.source = std::filesystem::path(scene.source).filename().string();
  return titled.name();
}

/// Replaces the scenes' names by their titles, except titles that several scenes share.
StudyReport with_titles(StudyReport report) {
  std::vector<std::string> titles;
  for (const StudyScene& scene : scenes_of(report.plan)) titles.push_back(title_of(scene));
  for (std::size_t i = 0; i < std::min(titles.size(), report.scenes.size()); ++i)
    if (std::count(titles.begin(), titles.end(), titles[i]) == 1)
      report.scenes[i].study.scene = titles[i];
  return report;
}

}  // namespace

Result<std::string> html_page(const StudyReport& named, const std::vector<SceneFigures>& figures) {
  const StudyReport report = with_titles(named);
  Embedder embed;
  std::string page = page_head("ASOS report: error against run time", report_style);
  page += html_summary(report);
  for (std::size_t i = 0; i < report.scenes.size(); ++i)
    page += html_scene(report.scenes[i], figures[i], i + 1, embed);
  if (report.plan.paper) page += html_paper(named);
  page += html_measurement(report);
  page += fmt::format("<script>{}</script>\n</body>\n</html>\n", report_script);
  if (embed.error()) return tl::unexpected(*embed.error());
  return page;
}

}  // namespace asos
