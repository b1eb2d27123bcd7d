#include "ui/panels/dfr_editor.h"

#include "renderer/film/film.h"
#include "renderer/shading/dfr.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace asos::ui {

namespace {

constexpr float dfr_plot_height_em = 13.0f;
constexpr float bar_height_em = 4.2f;
constexpr double quarter_turn = 0.5 * std::numbers::pi;
constexpr double deg_per_rad = 180.0 / std::numbers::pi;

constexpr std::array channels{
    Controls::Option{"All", "Edit all channels together."},
    Controls::Option{"Red", "Edit the red curve."},
    Controls::Option{"Green", "Edit the green curve."},
    Controls::Option{"Blue", "Edit the blue curve."},
};
/// Red, green and blue replaced by the palette of the split map, which colour-blind users can
/// distinguish.
constexpr std::array<std::uint32_t, 4> channel_colours{theme::plot_text, 0xd55e00, 0x009e73,
                                                       0x56b4e9};

struct Preset {
  const char* name;
  DfrCurve curve;
};
/// The ratios of CGF'98's figures, and a perfect mirror.
constexpr std::array presets{
    Preset{"Perfect mirror", {1.0, 1.0, 1.0}},
    Preset{"Linear", {0.6, 0.95, 1.0}},
    Preset{"Soft (N = 32)", {0.05, 1.0, 32.0}},
    Preset{"Softer (N = 64)", {0.05, 1.0, 64.0}},
};

/// Placement of the plot: angle of incidence to the right, 0 to 90 degrees, ratio upwards, 0 to 1.
struct DfrPlot {
  glm::vec2 lo, hi;
  double axis = 100.0;  ///< upper end of the axis of the widening, in percent

  [[nodiscard]] float x_at(double incidence_rad) const {
    return lo.x + static_cast<float>(incidence_rad / quarter_turn) * (hi.x - lo.x);
  }
  [[nodiscard]] float y_at(double share) const {
    return hi.y - static_cast<float>(share) * (hi.y - lo.y);
  }
  [[nodiscard]] ImVec2 ratio_point(const DfrCurve& curve, double incidence_rad) const {
    return {x_at(incidence_rad), y_at(dfr_at(curve, std::cos(incidence_rad)))};
  }
  [[nodiscard]] ImVec2 widening_point(const DfrCurve& curve, double incidence_rad) const {
    const double ratio = dfr_at(curve, std::cos(incidence_rad));
    return {x_at(incidence_rad), y_at(percentage_increase(plotted_pyray_rad, ratio) / axis)};
  }
  [[nodiscard]] double angle_deg(float x) const {
    return 90.0 * std::clamp(static_cast<double>((x - lo.x) / (hi.x - lo.x)), 0.0, 1.0);
  }
  [[nodiscard]] double ratio(float y) const {
    return std::clamp(static_cast<double>((hi.y - y) / (hi.y - lo.y)), 0.0, 1.0);
  }
};

void plot_text(glm::vec2 at, float align, const std::string& text, theme::Colour colour) {
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::GetWindowDrawList()->AddText({std::round(at.x - align * width), std::round(at.y)},
                                      theme::packed(colour), text.c_str());
}

void draw_dfr_axes(const DfrPlot& plot) {
  const float em = ImGui::GetFontSize();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({plot.lo.x, plot.lo.y}, {plot.hi.x, plot.hi.y},
                     theme::packed(theme::plot_ground));
  for (int i = 0; i <= 4; ++i) {
    const float y = plot.y_at(0.25 * i);
    draw.AddLine({plot.lo.x, y}, {plot.hi.x, y}, theme::packed(theme::plot_line));
    if (i % 2 == 1) continue;
    plot_text({plot.lo.x - 0.35f * em, y - 0.55f * em}, 1.0f, fmt::format("{:g}", 0.25 * i),
              theme::dim_text);
    plot_text({plot.hi.x + 0.35f * em, y - 0.55f * em}, 0.0f,
              fmt::format("{:g} %", 0.25 * i * plot.axis), theme::dim_text);
  }
  for (int i = 0; i <= 3; ++i) {
    const float x = plot.x_at(quarter_turn * i / 3.0);
    draw.AddLine({x, plot.lo.y}, {x, plot.hi.y}, theme::packed(theme::plot_line));
    plot_text({x, plot.hi.y + 0.25f * em}, 0.5f, fmt::format("{}\u00b0", 30 * i), theme::dim_text);
  }
  plot_text({plot.lo.x, plot.lo.y - 1.35f * em}, 0.0f, "DFR", theme::text);
  plot_text({plot.hi.x, plot.lo.y - 1.35f * em}, 1.0f, "dashed: cone growth (%)", theme::dim_text);
}

/// Draws the ratio as a solid line and the widening as a dashed one.
void draw_dfr_curve(const DfrPlot& plot, const DfrCurve& curve, std::uint32_t rgb, float alpha) {
  constexpr int steps = 180;
  const float em = ImGui::GetFontSize();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  std::vector<ImVec2> line;
  for (int i = 0; i <= steps; ++i)
    line.push_back(plot.ratio_point(curve, quarter_turn * i / steps));
  draw.AddPolyline(line.data(), static_cast<int>(line.size()), theme::packed(rgb, alpha), 0,
                   0.13f * em);
  // Dashes are measured along the curve, so that steep parts have the same dashes as flat ones.
  float gone = 0.0f;
  ImVec2 from = plot.widening_point(curve, 0.0);
  for (int i = 1; i <= steps; ++i) {
    const ImVec2 to = plot.widening_point(curve, quarter_turn * i / steps);
    if (std::fmod(gone, 0.9f * em) < 0.45f * em)
      draw.AddLine(from, to, theme::packed(rgb, 0.7f * alpha), 0.08f * em);
    gone += std::hypot(to.x - from.x, to.y - from.y);
    from = to;
  }
}

/// Draws a white bar as the mirror shows it, below the angles.
void draw_bar(const Dfr& dfr, glm::vec2 lo, glm::vec2 hi) {
  constexpr int columns = 90, rows = 24;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto colour = [&](int column, int row) {
    const double place = mirrored_bar_width * (2.0 * row / rows - 1.0);
    return theme::packed(
        display_bytes(mirrored_bar(dfr, quarter_turn * (column + 0.5) / columns, place), 0.0f));
  };
  for (int i = 0; i < columns; ++i) {
    const float left = glm::mix(lo.x, hi.x, static_cast<float>(i) / columns);
    const float right = glm::mix(lo.x, hi.x, static_cast<float>(i + 1) / columns);
    for (int k = 0; k < rows; ++k) {
      const ImU32 above = colour(i, k), under = colour(i, k + 1);
      draw.AddRectFilledMultiColor({left, glm::mix(lo.y, hi.y, static_cast<float>(k) / rows)},
                                   {right, glm::mix(lo.y, hi.y, static_cast<float>(k + 1) / rows)},
                                   above, above, under, under);
    }
  }
  draw.AddRect({lo.x, lo.y}, {hi.x, hi.y}, theme::packed(theme::line));
}

void draw_knob(glm::vec2 at, std::uint32_t rgb, bool lit) {
  const float r = (lit ? 0.42f : 0.33f) * ImGui::GetFontSize();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddCircleFilled({at.x, at.y}, r + 1.5f, theme::packed(theme::plot_ground));
  draw.AddCircleFilled({at.x, at.y}, r, theme::packed(rgb));
  if (lit) draw.AddCircle({at.x, at.y}, r + 2.5f, theme::packed(0xffffff, 0.6f));
}

/// The three draggable points of the chosen curve.
void knobs(Controls& controls, const DfrPlot& plot, Dfr& dfr, DfrChannel channel,
           const Dfr& usual) {
  const DfrCurve curve = curve_of(dfr, channel);
  const DfrCurve to = curve_of(usual, channel);
  const std::uint32_t rgb = channel_colours[static_cast<std::size_t>(channel)];
  const double halfway = halfway_deg(curve.exponent);
  const glm::vec2 n_at(plot.x_at(halfway / deg_per_rad), plot.y_at(0.5 * (curve.min + curve.max)));
  const glm::vec2 min_at(plot.x_at(0.0), plot.y_at(curve.min));
  const glm::vec2 max_at(plot.x_at(quarter_turn), plot.y_at(curve.max));

  const Controls::Handle n = controls.handle(
      "N point", "Drag to set N: the angle where the ratio is half-way. Double-click to reset.",
      n_at);
  if (n.moved)
    set_curves(dfr, channel, &DfrCurve::exponent, exponent_of_halfway(plot.angle_deg(n.moved->x)));
  if (n.reset) set_curves(dfr, channel, &DfrCurve::exponent, to.exponent);
  const Controls::Handle min =
      controls.handle("DFRMIN point", "Drag to set DFRMIN, the ratio at normal incidence.", min_at);
  if (min.moved) set_curves(dfr, channel, &DfrCurve::min, plot.ratio(min.moved->y));
  if (min.reset) set_curves(dfr, channel, &DfrCurve::min, to.min);
  const Controls::Handle max = controls.handle(
      "DFRMAX point", "Drag to set DFRMAX, the ratio at grazing incidence.", max_at);
  if (max.moved) set_curves(dfr, channel, &DfrCurve::max, plot.ratio(max.moved->y));
  if (max.reset) set_curves(dfr, channel, &DfrCurve::max, to.max);
  draw_knob(n_at, rgb, n.lit);
  draw_knob(min_at, rgb, min.lit);
  draw_knob(max_at, rgb, max.lit);
}

void plot_and_bar(Controls& controls, Dfr& dfr, DfrChannel channel, const Dfr& usual,
                  std::optional<double> incidence_rad) {
  const float em = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const DfrPlot plot{{corner.x + 1.9f * em, corner.y + 1.6f * em},
                     {corner.x + width - 3.6f * em, corner.y + (dfr_plot_height_em - 1.5f) * em},
                     widening_axis(dfr)};
  const glm::vec2 bar_lo(plot.lo.x, corner.y + dfr_plot_height_em * em + 0.1f * em);
  const glm::vec2 bar_hi(plot.hi.x, bar_lo.y + bar_height_em * em);

  ImGui::Dummy({width, dfr_plot_height_em * em});
  controls.placed("DFR curve",
                  "Defocusing ratio (DFR) by angle of incidence. 1 is a perfect mirror. Dashed: "
                  "growth of a 2-degree cone in percent. Drag the three points.");
  draw_dfr_axes(plot);
  const bool one = alike(dfr);
  for (std::size_t k = 0; k < 3; ++k) {
    const bool chosen = channel == DfrChannel::all || static_cast<std::size_t>(channel) == k + 1;
    if (one && k > 0) break;
    draw_dfr_curve(plot, dfr.rgb[k], one ? theme::plot_text : channel_colours[k + 1],
                   chosen || one ? 1.0f : 0.45f);
  }
  draw_bar(dfr, bar_lo, bar_hi);
  if (incidence_rad) {
    const float x = plot.x_at(*incidence_rad);
    ImGui::GetWindowDrawList()->AddLine({x, plot.lo.y}, {x, bar_hi.y},
                                        theme::packed(theme::warning), 1.5f);
  }
  const ImVec2 after = ImGui::GetCursorScreenPos();
  knobs(controls, plot, dfr, channel, usual);
  ImGui::SetCursorScreenPos(after);
  ImGui::Dummy({width, bar_height_em * em + 0.3f * em});
  controls.placed(
      "DFR patch",
      "A white bar as reflected at each angle of incidence. Wider cones blur its edges.");
}

/// Numbers to type, for the values of the points.
void dfr_numbers(Controls& controls, Dfr& dfr, DfrChannel channel, const Dfr& usual) {
  struct Field {
    const char* name;
    const char* tooltip;
    double DfrCurve::*member;
    double most;
    double step;
  };
  constexpr std::array fields{
      Field{"DFRMIN", "Ratio at normal incidence, 0 to 1.", &DfrCurve::min, 1.0, 0.005},
      Field{"DFRMAX", "Ratio at grazing incidence, 0 to 1.", &DfrCurve::max, 1.0, 0.005},
      Field{"N", "Exponent of the curve, 0 to 1000.", &DfrCurve::exponent, most_plotted_exponent,
            0.05},
  };
  for (const Field& field : fields) {
    double value = curve_of(dfr, channel).*field.member;
    const bool size = field.member == &DfrCurve::exponent;
    if (controls.number(
            field.name, field.tooltip, value,
            {{0.0, field.most, curve_of(usual, channel).*field.member}, field.step, size},
            [](double v) { return fmt::format("{:.4g}", v); }))
      set_curves(dfr, channel, field.member, value);
  }
}

void preset_list(Controls& controls, Dfr& dfr) {
  std::vector<std::string> names;
  int chosen = -1;
  for (const Preset& preset : presets) {
    if (alike(dfr) && dfr.rgb[0] == preset.curve) chosen = static_cast<int>(names.size());
    names.emplace_back(preset.name);
  }
  // A curve that is no preset is listed as "custom" while it is in use.
  if (chosen < 0) {
    chosen = static_cast<int>(names.size());
    names.emplace_back("custom");
  }
  if (controls.list("Preset", "Published curves (CGF'98) for all channels.", names, chosen) &&
      chosen < static_cast<int>(presets.size()))
    dfr.rgb.fill(presets[static_cast<std::size_t>(chosen)].curve);
}

}  // namespace

bool dfr_editor(Controls& controls, Dfr& dfr, DfrChannel& channel, const Dfr& usual,
                std::optional<double> incidence_rad) {
  const Dfr before = dfr;
  preset_list(controls, dfr);
  controls.options("DFR of", channels, channel, {true, 0});
  plot_and_bar(controls, dfr, channel, usual, incidence_rad);
  if (incidence_rad) {
    const double ratio = dfr_at(curve_of(dfr, channel), std::cos(*incidence_rad));
    controls.row(
        "Picked pixel",
        fmt::format("{:.1f}\u00b0, {:.2g}, +{:.3g} %", *incidence_rad * deg_per_rad, ratio,
                    percentage_increase(plotted_pyray_rad, ratio)),
        "Angle of incidence at the inspected pixel, its ratio, and growth of a 2-degree cone.");
  }
  dfr_numbers(controls, dfr, channel, usual);
  controls.slider("Variation", "Random variation of the ratio from place to place, 0 to 100 %.",
                  dfr.perturbation, {0.0, 1.0, usual.perturbation}, percent_words);
  return dfr != before;
}

}  // namespace asos::ui
