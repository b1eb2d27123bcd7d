#include "ui/panels/surface_panel.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace asos::ui {

namespace {

constexpr std::array<const char*, surface_properties> titles{
    "Base color", "Normal",     "Roughness",         "Metallic",     "Occlusion",
    "Emission",   "UV checker", "UV checker, set 2", "Vertex colors"};

}  // namespace

void surface_panel(Controls& controls, SurfaceChoice& choice) {
  if (!controls.section("Surfaces", false)) return;
  std::vector<std::string> items{"Shaded picture"};
  for (int i = 0; i < surface_properties; ++i) items.push_back(surface_entry(i));
  int shown = choice.property ? 1 + static_cast<int>(*choice.property) : 0;
  if (controls.list("Show",
                    "Property of the nearest surfaces, in place of the picture. Press its key "
                    "again for the picture.",
                    items, shown, 0)) {
    choice.property =
        shown > 0 ? std::optional(static_cast<SurfaceProperty>(shown - 1)) : std::nullopt;
  }
  controls.checkbox("Wireframe", "Draw the edges of triangles over the picture (Y).",
                    choice.wireframe, false);
}

std::string surface_entry(int property) {
  const auto i = static_cast<std::size_t>(property);
  return *surface_keys[i] ? fmt::format("{} ({})", titles[i], surface_keys[i])
                          : std::string(titles[i]);
}

const char* surface_title(const SurfaceChoice& choice) {
  return choice.property ? titles[static_cast<std::size_t>(*choice.property)] : nullptr;
}

void toggle(SurfaceChoice& choice, SurfaceProperty property) {
  if (choice.property == property)
    choice.property.reset();
  else
    choice.property = property;
}

}  // namespace asos::ui
