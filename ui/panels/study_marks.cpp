#include "ui/panels/study_marks.h"

#include "renderer/comparison/method.h"
#include "ui/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asos::ui {

namespace {

/// A regular polygon, rotated and flattened.
struct MarkShape {
  int corners = 3;
  float turned_deg = 0.0f;
  float height = 1.0f;
};

struct MethodMark {
  const char* method;
  std::uint32_t rgb;
  MarkShape shape;
};

/// Colours for the default methods of a study, found by search. Any two differ by at least 28 in
/// CIELAB, for normal sight and for protanopia, deuteranopia and tritanopia (Machado et al. 2009).
/// Their contrast to the plot's background is at least 3. Other methods share the text's colour.
constexpr std::array method_marks{
    MethodMark{"asos", 0xffee85, {16, 0.0f}},
    MethodMark{"asos-published", 0x7affc5, {6, 0.0f}},
    MethodMark{"uniform", 0x99aa66, {4, 45.0f}},
    MethodMark{"stochastic", 0xfd8b00, {3, -90.0f}},
    MethodMark{"sobol", 0xbbddff, {4, 0.0f}},
    MethodMark{"sobol-adaptive", 0x8a00ff, {3, 90.0f}},
    MethodMark{"whitted", 0x007755, {5, -90.0f}},
    MethodMark{"mitchell", 0xaf75a8, {3, 0.0f}},
    MethodMark{"ray-bound", 0xc92800, {3, 180.0f}},
    MethodMark{"average", 0xbb00bb, {4, 45.0f, 0.45f}},
    MethodMark{"beam", theme::plot_text, {4, 0.0f, 0.5f}},
    MethodMark{"cone", theme::plot_text, {5, 90.0f}},
    MethodMark{"covers", theme::plot_text, {6, 90.0f}},
    MethodMark{"mask", theme::plot_text, {8, 22.5f}},
};
constexpr MethodMark other_mark{"", theme::plot_text, {8, 0.0f, 0.6f}};

const MethodMark& mark_of(const std::string& method) {
  const auto* at = std::find_if(method_marks.begin(), method_marks.end(),
                                [&](const MethodMark& m) { return method == m.method; });
  return at == method_marks.end() ? other_mark : *at;
}

}  // namespace

std::uint32_t method_colour(const std::string& method) {
  return mark_of(method).rgb;
}

std::vector<glm::vec2> method_mark(const std::string& method) {
  const MarkShape& shape = mark_of(method).shape;
  std::vector<glm::vec2> corners;
  for (int i = 0; i < shape.corners; ++i) {
    const float angle = glm::radians(shape.turned_deg) + 2.0f * std::numbers::pi_v<float> *
                                                             static_cast<float>(i) /
                                                             static_cast<float>(shape.corners);
    corners.push_back({std::cos(angle), shape.height * std::sin(angle)});
  }
  return corners;
}

std::string method_title(const std::string& method) {
  for (const MethodRow& row : method_table())
    if (method == row.name) return row.title;
  return method;
}

std::string curve_title(const std::string& curve, const std::string& method) {
  return curve.starts_with(method) ? method_title(method) + curve.substr(method.size()) : curve;
}

}  // namespace asos::ui
