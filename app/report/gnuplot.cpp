#include "app/report/gnuplot.h"

#include "renderer/film/image_io.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace asos {
namespace {

/// Colour-blind safe palette of Okabe and Ito (2008); marks and dashes differ, too.
constexpr std::array colours{"#D55E00", "#0072B2", "#009E73", "#CC79A7",
                             "#E69F00", "#56B4E9", "#000000", "#8A6D00"};
/// The numbers of marks and colours have no common factor, so combinations repeat late.
constexpr std::array marks{7, 5, 9, 13, 11, 15, 4, 6, 8, 12, 10, 14, 1};

/// Runs gnuplot with one argument; its error output goes to `log`.
int run_gnuplot(const std::string& argument, const std::string& log) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0666);
  std::string program = "gnuplot";
  std::string word = argument;
  std::array<char*, 3> words{program.data(), word.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed != 0 || waitpid(child, &status, 0) != child) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// gnuplot's error message, as the end of a sentence.
std::string reason_in(const std::string& log) {
  const std::string said = text_of(log);
  return said.empty() ? " and does not say why; the disk may be full" : ": " + said;
}

/// Whether gnuplot wrote both plots completely: on a full disk it reports no error.
bool are_whole(const std::string& path) {
  return text_of(path + ".svg").rfind("</svg>") != std::string::npos && read_png(path + ".png");
}

/// Quotes a string for gnuplot; the enhanced mode, which would interpret _ and ^, is off.
std::string gnuplot_text(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c != '\n') result += c;
  }
  return result + "\"";
}

bool is_drawn(const PlotPoint& p) {
  return p.value > 0.0 && p.seconds > 0.0;
}

/// Lines of time, value, minimum and maximum time, for the points of a curve above the noise floor
/// or for those below.
std::string data_block(const PlotCurve& curve, bool under_floor) {
  std::string rows;
  for (const PlotPoint& p : curve.points)
    if (p.under_floor == under_floor && is_drawn(p))
      rows += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g}\n", p.seconds, p.value, p.least_seconds,
                          p.most_seconds);
  return rows;
}

std::string script_of(const CurvePlot& picture, const std::string& path) {
  std::string script =
      "set encoding utf8\nset logscale xy\nset format x \"10^{%T}\"\nset format y \"10^{%T}\"\n"
      "set grid xtics ytics mxtics mytics lc rgb \"#c4c4c4\", lc rgb \"#e6e6e6\"\n"
      "set border 3 lc rgb \"#606060\"\nset tics nomirror\nset key outside right top Left reverse "
      "noenhanced samplen 2\nset xlabel \"Processor seconds (all threads)\"\n";
  script += fmt::format("set ylabel {} noenhanced\nset title {} noenhanced\n",
                        gnuplot_text(picture.value_title), gnuplot_text(picture.title));
  const std::vector<PlotCurve>& curves = picture.curves;
  std::string plot;
  const auto add = [&plot](const std::string& part) {
    plot += (plot.empty() ? "" : ", \\\n") + part;
  };
  bool any_under = false;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string above = data_block(curves[i], false);
    const std::string under = data_block(curves[i], true);
    const char* colour = colours[i % colours.size()];
    const int mark = marks[i % marks.size()];
    if (!above.empty()) {
      script += fmt::format("$above{} << EOD\n{}EOD\n", i, above);
      add(fmt::format(
          "$above{} using 1:2 with linespoints lw {} pt {} ps 0.9 dt {} lc rgb \"{}\" "
          "title {}",
          i, curves[i].strong ? 2.6 : 1.4, mark, 1 + i % 4, colour, gnuplot_text(curves[i].name)));
      add(fmt::format("$above{} using 1:2:3:4 with xerrorbars pt 0 lw 1 lc rgb \"{}\" notitle", i,
                      colour));
    }
    if (!under.empty()) {
      script += fmt::format("$under{} << EOD\n{}EOD\n", i, under);
      add(fmt::format("$under{} using 1:2 with points pt 2 ps 0.8 lc rgb \"{}\" notitle", i,
                      colour));
      any_under = true;
    }
  }
  if (any_under)
    add("keyentry with points pt 2 ps 0.8 lc rgb \"#707070\" title \"x: under the floor\"");
  if (picture.floor > 0.0)
    add(fmt::format("{:.9g} with lines dt 2 lw 1.2 lc rgb \"#606060\" title \"floor\"",
                    picture.floor));
  if (picture.bias > 0.0)
    add(fmt::format("{:.9g} with lines dt 4 lw 1.2 lc rgb \"#202020\" title {}", picture.bias,
                    gnuplot_text(picture.bias_title)));
  const std::string pictures = fmt::format(
      "set terminal svg size 860,480 font \"DejaVu Sans,13\" background \"#ffffff\"\n"
      "set output {0}\nreplot\n"
      "set terminal pngcairo size 1290,720 font \"DejaVu Sans,13\" fontscale 1.2 background "
      "\"#ffffff\"\nset output {1}\nreplot\nset output\n",
      gnuplot_text(path + ".svg"), gnuplot_text(path + ".png"));
  return script + "set terminal dumb\nset output \"/dev/null\"\nplot " + plot + "\n" + pictures;
}

}  // namespace

bool CurvePlot::empty() const {
  return std::none_of(curves.begin(), curves.end(), [](const PlotCurve& curve) {
    return std::any_of(curve.points.begin(), curve.points.end(), is_drawn);
  });
}

void CurvePlot::add(const LadderStep& step, const PlotPoint& point) {
  auto curve = std::find_if(curves.begin(), curves.end(),
                            [&](const PlotCurve& c) { return c.name == step.curve; });
  if (curve == curves.end())
    curve = curves.insert(curve, {step.curve, {}, step.curve.starts_with("asos ")});
  curve->points.push_back(point);
}

Result<void> check_gnuplot() {
  if (run_gnuplot("--version", "/dev/null") == 0) return {};
  return tl::unexpected(
      Error{"gnuplot",
            "is not installed, and the report's plots are drawn with it: on Debian, install "
            "gnuplot-nox"});
}

Result<void> draw_plot(const CurvePlot& plot, const std::string& path) {
  const std::string script = script_of(plot, path);
  if (auto written = write_file_atomically(path + ".gp", {script.begin(), script.end()}); !written)
    return written;
  const std::string log = path + ".log";
  if (run_gnuplot(path + ".gp", log) != 0)
    return tl::unexpected(Error{path + ".gp", "gnuplot failed" + reason_in(log)});
  if (!are_whole(path))
    return tl::unexpected(
        Error{path, "gnuplot did not write the plot to its end" + reason_in(log)});
  std::filesystem::remove(log);
  return {};
}

}  // namespace asos
