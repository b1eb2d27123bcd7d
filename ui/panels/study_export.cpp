#include "ui/panels/study_export.h"

#include "ui/panels/study_marks.h"
#include "ui/screenshot.h"
#include "ui/theme.h"

#include <fmt/format.h>

#include <fstream>

namespace asos::ui {

namespace {

constexpr glm::dvec2 svg_size{800.0, 560.0};
constexpr glm::dvec2 svg_lo{80.0, 50.0}, svg_hi{580.0, 490.0};  // of the axes
constexpr double svg_mark = 5.0;

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '&')
      safe += "&amp;";
    else
      safe += c;
  }
  return safe;
}

std::string svg_text(glm::dvec2 at, const std::string& text, const char* anchor = "start") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", at.x, at.y,
                     anchor, escaped(text));
}

std::string svg_line(glm::dvec2 a, glm::dvec2 b, std::uint32_t rgb, const char* more = "") {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#{:06x}\"{}/>\n", a.x,
      a.y, b.x, b.y, rgb, more);
}

std::string svg_polygon(const std::string& method, glm::dvec2 at, bool hollow) {
  std::string points;
  for (const glm::vec2 corner : method_mark(method))
    points += fmt::format("{:.1f},{:.1f} ", at.x + svg_mark * static_cast<double>(corner.x),
                          at.y + svg_mark * static_cast<double>(corner.y));
  const std::uint32_t rgb = method_colour(method);
  return fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"#{:06x}\"/>\n", points,
                     hollow ? std::string("none") : fmt::format("#{:06x}", rgb), rgb);
}

glm::dvec2 svg_place(const StudyPlot& plot, const StudyPlot::Mark& mark) {
  return {glm::mix(svg_lo.x, svg_hi.x, plot.seconds.share(mark.seconds)),
          glm::mix(svg_hi.y, svg_lo.y, plot.rmse.share(mark.rmse))};
}

std::string svg_axes(const StudyPlot& plot) {
  std::string svg;
  for (int d = 0; d <= plot.seconds.decades; ++d) {
    const double x = glm::mix(svg_lo.x, svg_hi.x, static_cast<double>(d) / plot.seconds.decades);
    svg += svg_line({x, svg_lo.y}, {x, svg_hi.y}, theme::plot_line);
    svg += svg_text({x, svg_hi.y + 20.0}, fmt::format("1e{}", plot.seconds.first_decade + d),
                    "middle");
  }
  for (int d = 0; d <= plot.rmse.decades; ++d) {
    const double y = glm::mix(svg_hi.y, svg_lo.y, static_cast<double>(d) / plot.rmse.decades);
    svg += svg_line({svg_lo.x, y}, {svg_hi.x, y}, theme::plot_line);
    svg +=
        svg_text({svg_lo.x - 8.0, y + 4.0}, fmt::format("1e{}", plot.rmse.first_decade + d), "end");
  }
  svg += svg_text({svg_lo.x, svg_lo.y - 10.0}, "RMSE, linear radiance 0 to 1");
  svg += svg_text({0.5 * (svg_lo.x + svg_hi.x), svg_hi.y + 44.0}, "CPU seconds, all threads",
                  "middle");
  if (plot.floor > 0.0) {
    const double y = glm::mix(svg_hi.y, svg_lo.y, plot.rmse.share(plot.floor));
    svg += svg_line({svg_lo.x, y}, {svg_hi.x, y}, theme::plot_text, " stroke-dasharray=\"6 6\"");
    svg += svg_text({svg_hi.x - 4.0, y - 5.0}, "noise floor", "end");
  }
  return svg;
}

}  // namespace

std::string plot_svg(const StudyPlot& plot, const std::string& title) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"13\" "
      "fill=\"#{2:06x}\">\n<rect width=\"100%\" height=\"100%\" fill=\"#{3:06x}\"/>\n",
      svg_size.x, svg_size.y, theme::plot_text, theme::plot_ground);
  svg += svg_text({0.5 * svg_size.x, 24.0}, title, "middle");
  svg += svg_axes(plot);
  double legend = svg_lo.y + 10.0;
  for (const StudyPlot::Line& line : plot.lines) {
    for (std::size_t i = 1; i < line.marks.size(); ++i)
      svg += svg_line(
          svg_place(plot, line.marks[i - 1]), svg_place(plot, line.marks[i]),
          method_colour(line.method),
          line.dashed ? " stroke-width=\"2\" stroke-dasharray=\"7 5\"" : " stroke-width=\"2\"");
    for (const StudyPlot::Mark& mark : line.marks)
      svg += svg_polygon(line.method, svg_place(plot, mark), mark.under_floor);
    svg += svg_polygon(line.method, {svg_hi.x + 20.0, legend - 4.0}, false);
    svg += svg_text({svg_hi.x + 34.0, legend}, legend_words(line));
    legend += 22.0;
  }
  return svg + "</svg>\n";
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string safe = "\"";
  for (const char c : text) safe += c == '"' ? std::string("\"\"") : std::string(1, c);
  return safe + '"';
}

std::string study_csv(const SceneStudy& study) {
  std::string csv =
      "scene,picture,method,setting,cpu_seconds,rmse,below_noise_floor,noise_floor,rays\n";
  const std::string scene = csv_cell(study.scene);
  for (const StudyPoint& point : study.points)
    csv += fmt::format("{},finished,{},{},{},{},{},{},{}\n", scene,
                       csv_cell(method_title(point.rung.method)), csv_cell(point.rung.setting),
                       point.seconds(), point.measures.rmse, point.under_floor ? 1 : 0, study.floor,
                       point.rays);
  for (const RenderCurve& curve : study.while_rendering)
    for (const CurvePoint& point : curve.points)
      csv +=
          fmt::format("{},while rendering,{},{},{},{},{},{},\n", scene,
                      csv_cell(method_title(curve.method)), csv_cell(curve.setting), point.seconds,
                      point.error, point.error < study.floor ? 1 : 0, study.floor);
  return csv;
}

Result<std::string> save_study_text(const std::string& folder, const std::string& stem,
                                    const std::string& extension, const std::string& text) {
  const std::string ending = "." + extension;
  const std::string path = free_stem(folder, stem + "-study", {ending.c_str()}) + ending;
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) return unexpected(Error{path, "cannot be written"});
  return path;
}

}  // namespace asos::ui
