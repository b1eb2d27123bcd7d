#include "ui/panels/panels.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

namespace asos::ui {

namespace {

constexpr std::array themes{
    Controls::Option{"Dark", "Light text on dark grey."},
    Controls::Option{"Light", "Dark text on light grey."},
};

struct NamedScale {
  const char* name;
  float scale;
};
constexpr std::array scales{NamedScale{"75 %", 0.75f}, NamedScale{"100 %", 1.0f},
                            NamedScale{"125 %", 1.25f}, NamedScale{"150 %", 1.5f},
                            NamedScale{"200 %", 2.0f}};

void scale_choice(Controls& controls, float& scale) {
  std::array<Controls::Option, scales.size()> options{};
  int chosen = -1, usual = 0;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    options[i] = {scales[i].name, "Size of text and controls, on top of the screen's scale."};
    if (scales[i].scale == scale) chosen = static_cast<int>(i);
    if (scales[i].scale == WindowLook{}.scale) usual = static_cast<int>(i);
  }
  if (controls.options("Text size", options, chosen, {true, usual}) && chosen >= 0)
    scale = scales[static_cast<std::size_t>(chosen)].scale;
}

}  // namespace

void window_panel(Controls& controls, WindowLook& look) {
  if (!controls.section("Window")) return;
  controls.options("Theme", themes, look.theme, {true, 0});
  scale_choice(controls, look.scale);
  controls.checkbox("Picture bar", "Show the controls under the picture.", look.show_bar,
                    WindowLook{}.show_bar);
}

}  // namespace asos::ui
