#include "ui/panels/background_panel.h"

#include <array>

namespace asos::ui {

namespace {

constexpr std::array background_kinds{
    Controls::Option{"Environment", "The sky."},
    Controls::Option{"Blurred", "The sky out of focus. Mirrors, glass and lighting keep it sharp."},
    Controls::Option{"Colours", "A vertical gradient. Mirrors, glass and lighting keep the sky."},
    Controls::Option{"Transparent",
                     "Transparent, with exact coverage in saved pictures. Mirrors, glass and "
                     "lighting keep the sky."},
};

constexpr std::array grounds{
    Controls::Option{"Off", "No ground."},
    Controls::Option{"On", "A ground plane that catches shadows. Not part of the file."},
    Controls::Option{"Mirror",
                     "A reflecting ground plane: sharp along the surface, blurred from above."},
};

}  // namespace

void background_controls(Controls& controls, RenderSettings& settings) {
  controls.options("Ground", grounds, settings.ground, {true, 0});
  Background& background = settings.background;
  const Background usual;
  controls.options("Background", background_kinds, background.kind, {true, 0});
  if (background.kind != BackgroundKind::colours) return;
  controls.colour("Upper", "Colour at the upper border, red, green, blue, 0 to 255.",
                  background.top, usual.top);
  controls.colour("Lower", "Colour at the lower border, red, green, blue, 0 to 255.",
                  background.bottom, usual.bottom);
}

}  // namespace asos::ui
