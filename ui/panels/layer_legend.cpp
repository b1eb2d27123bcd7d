#include "ui/panels/legend_window.h"
#include "ui/panels/overlays.h"
#include "ui/panels/scale_strip.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <string>

namespace asos::ui {

namespace {

constexpr float layer_legend_width_em = 24.0f;

// The range of each channel: "X: 0 to 2 m".
std::string channel_ranges(Layer layer, const LayerScale& scale) {
  const std::string letters = row_of(layer).channels;
  std::string words;
  for (std::size_t c = 0; c < letters.size(); ++c) {
    const int k = static_cast<int>(c);
    words += fmt::format("{}{}: {:.3g} to {}", words.empty() ? "" : "\n", letters[c], scale.lo[k],
                         with_unit(scale.hi[k], layer));
  }
  return words;
}

std::string layer_key_words(const LayerFacts& facts) {
  const LayerRow& row = row_of(facts.layer);
  if (!facts.rendered) return "This method does not render it.";
  if (row.holds_ids()) return "A colour for each. Edges mix by coverage.";
  if (facts.layer == Layer::albedo || LayerSet{facts.layer}.of_light()) return row.about;
  return channel_ranges(facts.layer, facts.scale);
}

}  // namespace

void layer_legend(Controls& controls, const LayerFacts& facts, const WindowRect& area) {
  const LegendWindow window(controls, "Layer legend", area, layer_legend_width_em);
  if (!window.has_room()) return;
  const LayerRow& row = row_of(facts.layer);
  ImGui::TextUnformatted(row.title);
  if (facts.rendered && is_scalar(facts.layer)) {
    const float lo = facts.scale.lo.x, hi = facts.scale.hi.x;
    const std::array ticks{ScaleTick{0.0f, fmt::format("{:.3g}", lo)},
                           ScaleTick{0.5f, fmt::format("{:.3g}", 0.5f * (lo + hi))},
                           ScaleTick{1.0f, with_unit(hi, facts.layer)}};
    scale_strip(controls, "Layer scale", row.about, ticks);
  } else {
    controls.dim_text("Layer scale", layer_key_words(facts), row.about);
  }
}

}  // namespace asos::ui
