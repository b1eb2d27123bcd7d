#include "renderer/comparison/method.h"
#include "renderer/film/split_map.h"
#include "ui/panels/panels.h"
#include "ui/resampled.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace asos {

namespace {

constexpr std::array comparisons{
    Controls::Option{"Off", "Only the current picture."},
    Controls::Option{"Wipe", "Current picture on the left, snapshot on the right."},
    Controls::Option{"Flip", "Switch between picture and snapshot (X)."},
    Controls::Option{"Difference",
                     "Difference of display intensity, largest channel, on an absolute scale."},
};

std::string summary_of(const Previewer& previewer) {
  const RenderSettings& s = previewer.render().settings();
  const Progress progress = previewer.render().progress();
  std::string text = row_of(s.method).name;
  text += in_object_space(s.method) || row_of(s.method).samples_by_eps
              ? fmt::format(", EPS {:.4g}, MAX {}", s.asos.eps, s.asos.max_level)
              : fmt::format(", {} samples", s.sampling.spp);
  return text + fmt::format(", {} x {}, {:.0f} % in {:.2f} s", s.width, s.height,
                            100.0 * progress.fraction, progress.seconds);
}

std::string scale_words(float stops) {
  return stops >= 0.0f ? std::string("1") : fmt::format("1/{:.3g}", std::exp2(-stops));
}

void difference_legend(Controls& controls, const std::string& most) {
  const float em = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  constexpr int steps = 64;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (int i = 0; i < steps; ++i) {
    const glm::u8vec3 c = heat_colour((static_cast<float>(i) + 0.5f) / steps);
    draw.AddRectFilled({corner.x + width * static_cast<float>(i) / steps, corner.y},
                       {corner.x + width * static_cast<float>(i + 1) / steps, corner.y + 0.9f * em},
                       IM_COL32(c.x, c.y, c.z, 255));
  }
  const float right = corner.x + width - ImGui::CalcTextSize(most.c_str()).x;
  draw.AddText({corner.x, corner.y + em}, theme::packed(theme::dim_text), "0");
  draw.AddText({right, corner.y + em}, theme::packed(theme::dim_text), most.c_str());
  ImGui::Dummy({width, 2.2f * em});
  controls.placed("Difference legend", "Black: no difference. White: the scale's maximum or more.");
}

/// Of that part of the picture which the frame shows, too; `sized`: the frame at its size.
double common_rmse(const Film& film, const Film& frame, const Film& sized) {
  const PixelRect area = resampled_area(frame, {film.width, film.height});
  double sum = 0.0;
  for (int y = area.y; y < area.y + area.height; ++y) {
    for (int x = area.x; x < area.x + area.width; ++x) {
      const glm::dvec3 d(film.radiance[film.index(x, y)] - sized.radiance[sized.index(x, y)]);
      sum += glm::dot(d, d) / 3.0;
    }
  }
  return std::sqrt(sum / std::max(1.0, static_cast<double>(area.width) * area.height));
}

/// Told anew when the picture is finished or another frame is chosen.
void error_row(Controls& controls, const Previewer& previewer, Frames& frames) {
  const StoredFrame& frame = frames.stored[static_cast<std::size_t>(frames.chosen)];
  const PreviewRender& render = previewer.render();
  const Film& film = render.film();
  const bool same = frame.film.width == film.width && frame.film.height == film.height;
  std::string words = "(when finished)";
  if (render.progress().finished && film.width > 0) {
    const Frames::Measured now{render.restarts(), frames.revision, frames.chosen};
    if (!(now == frames.measured)) {
      frames.measured = now;
      frames.rmse =
          common_rmse(film, frame.film, frames.at_size(frames.chosen, {film.width, film.height}));
    }
    words = fmt::format("{:.3g}", frames.rmse);
  }
  controls.row("RMSE", words, "RMS difference between picture and snapshot, linear values.");
  if (same) return;
  controls.row("Resampled",
               fmt::format("{} x {} to {} x {}", frame.film.width, frame.film.height, film.width,
                           film.height),
               "The snapshot has another size and is resampled. Edges differ for that reason. For "
               "exact differences keep a snapshot of this size.");
}

void comparison_controls(Controls& controls, Frames& frames) {
  int mode = static_cast<int>(frames.comparison);
  if (controls.options("Compare", comparisons, mode, {true, 0})) {
    frames.comparison = static_cast<Comparison>(mode);
    frames.flipped = frames.comparison == Comparison::flip;
  }
  switch (frames.comparison) {
    case Comparison::none:
      break;
    case Comparison::wipe:
      controls.slider("Wipe", "Position of the divider in percent of the width.", frames.wipe,
                      {0.0f, 1.0f, 0.5f},
                      [](float share) { return fmt::format("{:.0f} %", 100.0f * share); });
      break;
    case Comparison::flip:
      controls.checkbox("Show snapshot", "Show the snapshot instead of the picture (X).",
                        frames.flipped, false);
      break;
    case Comparison::difference:
      controls.slider("Scale", "Difference shown as white, 0 to 1. 1/256 is one 8-bit step.",
                      frames.scale_stops, {-10.0f, 0.0f, -4.0f}, scale_words);
      difference_legend(controls, scale_words(frames.scale_stops));
      break;
  }
}

}  // namespace

void compare_panel(Controls& controls, const Previewer& previewer, Frames& frames) {
  if (!previewer.scene() || !controls.section("Compare", false)) return;
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  const bool full = frames.stored.size() >= Frames::most;
  if (controls.button("Keep snapshot",
                      full ? "Eight snapshots at most: delete one first."
                           : "Keep the picture to compare with (S).",
                      width))
    store_frame(frames, previewer);
  ImGui::SameLine();
  if (controls.button("Delete snapshot", "Delete the chosen snapshot.", width))
    frames.remove(frames.chosen);
  if (frames.stored.empty()) return;

  std::vector<Controls::Option> options;
  for (const StoredFrame& frame : frames.stored)
    options.push_back({frame.name.c_str(), frame.summary.c_str()});
  controls.options("Snapshot", options, frames.chosen);
  controls.row("Settings", frames.stored[static_cast<std::size_t>(frames.chosen)].summary,
               "Settings of the chosen snapshot.");
  error_row(controls, previewer, frames);
  comparison_controls(controls, frames);
}

bool store_frame(Frames& frames, const Previewer& previewer) {
  return frames.store(previewer.render().film(), summary_of(previewer));
}

}  // namespace asos
