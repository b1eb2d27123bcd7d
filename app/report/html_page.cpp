#include "app/report/html_page.h"

#include "app/report/html_style.h"

#include <fmt/format.h>

namespace asos {

Result<std::string> html_page(const StudyReport& report, const std::vector<SceneFigures>& figures) {
  Embedder embed;
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>ASOS report: error against run time</title>\n<style>{}</style>\n</head>\n<body>\n",
      report_style);
  page += html_summary(report);
  for (std::size_t i = 0; i < report.scenes.size(); ++i)
    page += html_scene(report.scenes[i], figures[i], i + 1, embed);
  if (report.plan.paper) page += html_paper(report);
  page += html_measurement(report);
  page += fmt::format("<script>{}</script>\n</body>\n</html>\n", report_script);
  if (embed.error()) return tl::unexpected(*embed.error());
  return page;
}

}  // namespace asos
