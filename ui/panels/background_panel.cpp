#include "ui/panels/background_panel.h"

#include <array>

namespace asos {

namespace {

constexpr std::array background_kinds{
    Controls::Option{"Environment", "The sky, as mirrors show it."},
    Controls::Option{"Blurred", "The sky, out of focus; mirrors, glass and light keep it sharp."},
    Controls::Option{"Colours",
                     "A gradient down the picture; mirrors, glass and light keep the sky."},
    Controls::Option{"Transparent",
                     "Nothing: saved pictures have an alpha channel, which tells exactly how much "
                     "of each pixel surfaces cover. Mirrors, glass and light keep the sky."},
};

constexpr std::array grounds{
    Controls::Option{"Off", "The scene stands on nothing."},
    Controls::Option{"On",
                     "A plate at its lowest point that receives its shadows. It is no part of the "
                     "scene: neither counted nor saved with it."},
    Controls::Option{"Mirror",
                     "A plate that mirrors by a defocusing ratio (DFR): sharp where it is looked "
                     "along, blurred from above."},
};

}  // namespace

void background_controls(Controls& controls, RenderSettings& settings) {
  int ground = static_cast<int>(settings.ground);
  if (controls.options("Ground", grounds, ground, {true, 0}))
    settings.ground = static_cast<Ground>(ground);
  Background& background = settings.background;
  const Background usual;
  int kind = static_cast<int>(background.kind);
  if (controls.options("Background", background_kinds, kind, {false, 0}))
    background.kind = static_cast<BackgroundKind>(kind);
  if (background.kind != BackgroundKind::colours) return;
  controls.colour("Upper", "At the picture's upper border: red, green, blue, 0 to 255 as shown.",
                  background.top, usual.top);
  controls.colour("Lower", "At the picture's lower border: red, green, blue, 0 to 255 as shown.",
                  background.bottom, usual.bottom);
}

}  // namespace asos
