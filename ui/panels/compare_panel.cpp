#include "renderer/comparison/method.h"
#include "ui/equal_time.h"
#include "ui/panels/panels.h"
#include "ui/panels/snapshot_table.h"
#include "ui/panels/time_words.h"
#include "ui/snapshot_name.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace asos::ui {

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
  std::string text = row_of(s.method).title;
  text += in_object_space(s.method) || row_of(s.method).samples_by_eps
              ? fmt::format(", EPS {:.2g}, MAX {}", s.asos.eps, s.asos.max_level)
              : fmt::format(", {} samples", s.sampling.spp);
  return text + fmt::format(", {} x {}, {:.0f} % in {}", s.width, s.height,
                            100.0 * progress.fraction, duration_words(progress.seconds));
}

void size_row(Controls& controls, const Film& film, const Film& frame) {
  if (frame.width == film.width && frame.height == film.height) return;
  controls.row(
      "Resampled",
      fmt::format("{} x {} to {} x {}", frame.width, frame.height, film.width, film.height),
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
      break;
  }
}

}  // namespace

void compare_panel(Controls& controls, const Previewer& previewer, Frames& frames) {
  if (!previewer.scene() || !controls.section("Compare", false)) return;
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  const bool full = frames.stored.size() >= Frames::most;
  if (controls.button("Keep snapshot",
                      full ? "Nine snapshots at most: delete one first."
                           : "Keep the picture to compare with (S).",
                      width))
    store_frame(frames, previewer);
  ImGui::SameLine();
  if (controls.button("Delete snapshot", "Delete the chosen snapshot.", width))
    frames.remove(frames.chosen);
  if (frames.stored.empty()) return;

  snapshot_table(controls, previewer, frames);
  const int samples = frames.reference.film ? frames.reference.samples : 0;
  controls.row("Errors against",
               samples > 0 ? fmt::format("a reference of {} samples", samples)
                           : std::string("the chosen snapshot"),
               "Check splits and the layer Error sample a reference of the view.");
  controls.row("Closer", closer_words(frames),
               "The one of picture and chosen snapshot with the smaller error.");
  if (controls.button("Copy errors", "Copy the table as CSV to the clipboard.", -1.0f))
    ImGui::SetClipboardText(snapshot_csv(frames).c_str());
  const StoredFrame& chosen = frames.stored[static_cast<std::size_t>(frames.chosen)];
  controls.row("Settings", chosen.summary, "Settings of the chosen snapshot.");
  size_row(controls, previewer.render().film(), chosen.film);
  comparison_controls(controls, frames);
}

std::string picture_words(const PreviewRender& render) {
  const Progress progress = render.progress();
  const std::string title = row_of(render.settings().method).title;
  if (progress.finished) return title + ", " + duration_words(progress.seconds);
  return fmt::format("{}, {:.0f} % done", title, std::floor(100.0 * progress.fraction));
}

std::string kept_words(const Frames& frames) {
  return fmt::format("Kept {}: {}", frames.stored.size(), frames.stored.back().name);
}

bool store_frame(Frames& frames, const Previewer& previewer) {
  const PreviewRender& render = previewer.render();
  std::string name = snapshot_name(render.settings(), processor_seconds(render.film()));
  const Progress progress = render.progress();
  if (!progress.finished)
    name += fmt::format(", {:.0f} % done", std::floor(100.0 * progress.fraction));
  return frames.store(render.film(), std::move(name), summary_of(previewer));
}

}  // namespace asos::ui
