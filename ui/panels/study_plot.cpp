#include "ui/panels/study_plot.h"

#include "ui/panels/study_marks.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos::ui {

namespace {

void draw_mark(ImDrawList& draw, const std::string& method, ImVec2 at, float radius, bool hollow) {
  std::vector<ImVec2> corners;
  for (const glm::vec2 corner : method_mark(method))
    corners.push_back({at.x + radius * corner.x, at.y + radius * corner.y});
  const std::uint32_t colour = theme::packed(method_colour(method));
  const auto count = static_cast<int>(corners.size());
  if (hollow)
    draw.AddPolyline(corners.data(), count, colour, ImDrawFlags_Closed, 0.2f * radius);
  else
    draw.AddConvexPolyFilled(corners.data(), count, colour);
}

/// Placement of the plot's square in the window, and functions to draw into it.
class Canvas {
 public:
  Canvas(const StudyPlot& plot, glm::vec2 lo, glm::vec2 hi) : plot_(plot), lo_(lo), hi_(hi) {}

  void axes() const {
    draw_->AddRectFilled({lo_.x, lo_.y}, {hi_.x, hi_.y}, theme::packed(theme::plot_ground));
    for (int d = 0; d <= plot_.seconds.decades; ++d) {
      const double value = std::pow(10.0, plot_.seconds.first_decade + d);
      const float x = x_of(value);
      draw_->AddLine({x, lo_.y}, {x, hi_.y}, theme::packed(theme::plot_line));
      if (d % step(plot_.seconds) != 0) continue;
      const std::string text = seconds_label(plot_.seconds.first_decade + d);
      centred({x, hi_.y + 0.4f * em_}, text);
    }
    for (int d = 0; d <= plot_.rmse.decades; ++d) {
      const float y = y_of(std::pow(10.0, plot_.rmse.first_decade + d));
      draw_->AddLine({lo_.x, y}, {hi_.x, y}, theme::packed(theme::plot_line));
      if (d % step(plot_.rmse) != 0) continue;
      const std::string text = fmt::format("1e{}", plot_.rmse.first_decade + d);
      const float width = ImGui::CalcTextSize(text.c_str()).x;
      words({lo_.x - width - 0.3f * em_, y - 0.5f * em_}, text);
    }
    words({lo_.x, lo_.y - 1.3f * em_}, "RMSE, linear radiance 0 to 1");
    centred({0.5f * (lo_.x + hi_.x), hi_.y + 1.5f * em_}, "CPU seconds, all threads");
  }

  void floor() const {
    if (!(plot_.floor > 0.0)) return;
    const float y = y_of(plot_.floor);
    const float dash = 0.4f * em_;
    for (float x = lo_.x; x < hi_.x; x += 2.0f * dash)
      draw_->AddLine({x, y}, {std::min(x + dash, hi_.x), y}, theme::packed(theme::plot_text, 0.6f));
    draw_->AddText({std::round(hi_.x - ImGui::CalcTextSize("noise floor").x - 0.3f * em_),
                    std::round(y - 1.1f * em_)},
                   theme::packed(theme::plot_text, 0.6f), "noise floor");
  }

  void line(const StudyPlot::Line& line) const {
    const std::uint32_t colour = theme::packed(method_colour(line.method));
    const float radius = 0.3f * em_;
    for (std::size_t i = 0; i < line.marks.size(); ++i) {
      const StudyPlot::Mark& mark = line.marks[i];
      const ImVec2 at{x_of(mark.seconds), y_of(mark.rmse)};
      if (i > 0)
        stroke({x_of(line.marks[i - 1].seconds), y_of(line.marks[i - 1].rmse)}, {at.x, at.y},
               colour, line.dashed);
      draw_mark(*draw_, line.method, at, radius, mark.under_floor);
    }
  }

 private:
  void stroke(glm::vec2 from, glm::vec2 to, std::uint32_t colour, bool dashed) const {
    const float length = glm::distance(from, to);
    const float dash = dashed ? 0.5f * em_ : std::max(1.0f, length);
    for (float at = 0.0f; at < length; at += 2.0f * dash) {
      const glm::vec2 a = glm::mix(from, to, at / length);
      const glm::vec2 b = glm::mix(from, to, std::min(1.0f, (at + dash) / length));
      draw_->AddLine({a.x, a.y}, {b.x, b.y}, colour, 0.12f * em_);
    }
  }
  [[nodiscard]] float x_of(double seconds) const {
    return lo_.x + static_cast<float>(plot_.seconds.share(seconds)) * (hi_.x - lo_.x);
  }
  [[nodiscard]] float y_of(double rmse) const {
    return hi_.y - static_cast<float>(plot_.rmse.share(rmse)) * (hi_.y - lo_.y);
  }
  // Number of decades between labels, so that labels do not overlap.
  static int step(const LogAxis& axis) { return (axis.decades + 4) / 5; }
  static std::string seconds_label(int decade) {
    const int thousands = static_cast<int>(std::floor(decade / 3.0));
    const double number = std::pow(10.0, decade - 3 * thousands);
    if (thousands == 0) return fmt::format("{:g} s", number);
    if (thousands == -1) return fmt::format("{:g} ms", number);
    if (thousands == -2) return fmt::format("{:g} \u00b5s", number);
    return fmt::format("1e{} s", decade);
  }
  void words(glm::vec2 at, const std::string& text) const {
    draw_->AddText({std::round(at.x), std::round(at.y)}, theme::packed(theme::dim_text),
                   text.c_str());
  }
  void centred(glm::vec2 at, const std::string& text) const {
    words({at.x - 0.5f * ImGui::CalcTextSize(text.c_str()).x, at.y}, text);
  }

  const StudyPlot& plot_;
  glm::vec2 lo_, hi_;
  float em_ = ImGui::GetFontSize();
  ImDrawList* draw_ = ImGui::GetWindowDrawList();
};

constexpr float mark_em = 0.9f, gap_em = 0.8f;  // in the legend

/// Returns whether each line begins a new row of the legend.
std::vector<bool> row_starts(const StudyPlot& plot) {
  const float em = ImGui::GetFontSize(), room = ImGui::GetContentRegionAvail().x;
  std::vector<bool> starts;
  float used = room;
  for (const StudyPlot::Line& line : plot.lines) {
    const float width = mark_em * em + ImGui::CalcTextSize(legend_words(line).c_str()).x;
    starts.push_back(!(used + gap_em * em + width < room));
    used = starts.back() ? width : used + gap_em * em + width;
  }
  return starts;
}

void draw_legend(const StudyPlot& plot) {
  const float em = ImGui::GetFontSize();
  const std::vector<bool> starts = row_starts(plot);
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const StudyPlot::Line& line = plot.lines[i];
    const std::string title = legend_words(line);
    if (!starts[i]) ImGui::SameLine(0.0f, gap_em * em);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_mark(*ImGui::GetWindowDrawList(), line.method,
              {at.x + 0.4f * em, at.y + 0.5f * ImGui::GetTextLineHeight()}, 0.3f * em, false);
    ImGui::BeginGroup();
    ImGui::Dummy({mark_em * em, ImGui::GetTextLineHeight()});
    ImGui::SameLine(0.0f, 0.0f);
    ImGui::TextUnformatted(title.c_str());
    ImGui::EndGroup();
  }
}

}  // namespace

std::string legend_words(const StudyPlot::Line& line) {
  return curve_title(line.curve, line.method) + (line.dashed ? " (dashed)" : "");
}

int legend_rows(const StudyPlot& plot) {
  const std::vector<bool> starts = row_starts(plot);
  return static_cast<int>(std::count(starts.begin(), starts.end(), true));
}

double LogAxis::share(double value) const {
  return (std::log10(value) - first_decade) / decades;
}

LogAxis axis_over(const std::vector<double>& values) {
  double lo = std::numeric_limits<double>::infinity();
  double hi = 0.0;
  for (const double v : values) {
    if (!(v > 0.0) || !std::isfinite(v)) continue;
    lo = std::min(lo, v);
    hi = std::max(hi, v);
  }
  if (!(hi > 0.0)) return {};
  const int first = static_cast<int>(std::floor(std::log10(lo)));
  const int last = static_cast<int>(std::ceil(std::log10(hi)));
  return {first, std::max(1, last - first)};
}

StudyPlot plot_of(const SceneStudy& study, StudyCurves curves) {
  StudyPlot plot;
  plot.floor = study.floor;
  std::vector<double> seconds;
  std::vector<double> errors{study.floor};
  const auto add = [&](const std::string& curve, const std::string& method, StudyPlot::Mark mark) {
    if (!(mark.seconds > 0.0 && mark.rmse > 0.0) || !std::isfinite(mark.rmse)) return;
    auto line = std::find_if(plot.lines.begin(), plot.lines.end(),
                             [&](const auto& l) { return l.curve == curve; });
    if (line == plot.lines.end()) {
      const bool again = std::any_of(plot.lines.begin(), plot.lines.end(),
                                     [&](const auto& l) { return l.method == method; });
      line = plot.lines.insert(line, {curve, method, again, {}});
    }
    line->marks.push_back(mark);
    seconds.push_back(mark.seconds);
    errors.push_back(mark.rmse);
  };
  if (curves == StudyCurves::finished) {
    for (const StudyPoint& point : study.points)
      add(point.rung.curve, point.rung.method,
          {point.seconds(), point.measures.rmse, point.under_floor});
  } else {
    for (const RenderCurve& render : study.while_rendering)
      for (const CurvePoint& point : render.points)
        add(render.method + " " + render.setting, render.method,
            {point.seconds, point.error, point.error < study.floor});
  }
  plot.seconds = axis_over(seconds);
  plot.rmse = axis_over(errors);
  return plot;
}

void draw_plot(const StudyPlot& plot, float height_em) {
  const float em = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::Dummy({width, height_em * em});
  const glm::vec2 lo(corner.x + 2.6f * em, corner.y + 1.5f * em);
  const glm::vec2 hi(corner.x + width - 1.2f * em, corner.y + (height_em - 2.8f) * em);
  if (hi.x - lo.x < em) return;
  const Canvas canvas(plot, lo, hi);
  canvas.axes();
  canvas.floor();
  for (const StudyPlot::Line& line : plot.lines) canvas.line(line);
  draw_legend(plot);
}

}  // namespace asos::ui
