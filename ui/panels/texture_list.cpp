#include "ui/panels/texture_list.h"

#include "renderer/files/printable.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <string>

namespace asos::ui {

namespace {

struct Use {
  const char* name;
  const char* channels;
};
/// In the order of texture_uses.
constexpr std::array<Use, 19> uses{{{"Base color", "RGB, opacity A"},
                                    {"Metallic", "B, roughness G"},
                                    {"Normal", "RGB"},
                                    {"Emission", "RGB"},
                                    {"Specular", "A"},
                                    {"Specular color", "RGB"},
                                    {"Transmission", "R"},
                                    {"Clearcoat", "R"},
                                    {"Clearcoat roughness", "G"},
                                    {"Clearcoat normal", "RGB"},
                                    {"Sheen color", "RGB"},
                                    {"Sheen roughness", "A"},
                                    {"Iridescence", "R"},
                                    {"Iridescence thickness", "G"},
                                    {"Occlusion", "R"},
                                    {"Thickness", "G"},
                                    {"Diffuse transmission", "A"},
                                    {"Diffuse transmission color", "RGB"},
                                    {"Anisotropy", "RG, strength B"}}};

constexpr std::size_t texels_a_side = 16;  // of a thumbnail, per side

void draw_thumbnail(const Image& image, ImVec2 lo, float side) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto width = static_cast<std::size_t>(image.width);
  const auto height = static_cast<std::size_t>(image.height);
  const bool known = width > 0 && height > 0 && image.rgba.size() >= 4 * width * height;
  draw.AddRectFilled(lo, {lo.x + side, lo.y + side}, theme::packed(theme::field));
  if (!known) return;
  const auto edge = [&](std::size_t k) {
    return std::round(side * static_cast<float>(k) / static_cast<float>(texels_a_side));
  };
  for (std::size_t y = 0; y < texels_a_side; ++y) {
    for (std::size_t x = 0; x < texels_a_side; ++x) {
      const std::size_t texel = (2 * y + 1) * height / (2 * texels_a_side) * width +
                                (2 * x + 1) * width / (2 * texels_a_side);
      const std::uint8_t* rgb = image.rgba.data() + 4 * texel;
      draw.AddRectFilled({lo.x + edge(x), lo.y + edge(y)}, {lo.x + edge(x + 1), lo.y + edge(y + 1)},
                         IM_COL32(rgb[0], rgb[1], rgb[2], 255));
    }
  }
}

}  // namespace

void texture_list(Controls& controls, const World& world, const Material& material) {
  const auto all = texture_uses(material);
  const float em = ImGui::GetFontSize(), side = std::round(3.0f * em);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i]->used()) continue;
    const Texture& texture = world.textures[static_cast<std::size_t>(all[i]->texture)];
    if (texture.image < 0) continue;
    const Image& image = world.images[static_cast<std::size_t>(texture.image)];
    ImGui::BeginGroup();
    draw_thumbnail(image, ImGui::GetCursorScreenPos(), side);
    ImGui::Dummy({side, side});
    ImGui::SameLine();
    const std::string use = fmt::format("{}: {}", uses[i].name, uses[i].channels);
    const std::string words =
        fmt::format("{} x {}{}", image.width, image.height,
                    all[i]->texcoord > 0 ? fmt::format(", UV set {}", all[i]->texcoord) : "");
    ImGui::BeginGroup();
    ImGui::TextUnformatted(use.c_str());
    ImGui::TextUnformatted(printable(image.name.empty() ? texture.name : image.name).c_str());
    ImGui::TextDisabled("%s", words.c_str());
    ImGui::EndGroup();
    ImGui::EndGroup();
    controls.placed_words(std::string("Texture/") + uses[i].name, use + ", " + words,
                          "Texture of the chosen object's material, as stored in the file.");
  }
}

}  // namespace asos::ui
