#include "renderer/comparison/method.h"
#include "ui/panels/side_panel.h"
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

constexpr std::array sources{
    Controls::Option{"Snapshot", "A picture that you have kept (S)."},
    Controls::Option{"Method", "Another method in the same CPU time."},
    Controls::Option{"Reference", "A reference of 256 samples per pixel of this view."},
};

constexpr std::array comparisons{
    Controls::Option{"Off", "Only the current picture."},
    Controls::Option{"Wipe", "Current picture on the left, the other on the right."},
    Controls::Option{"Flip", "Switch between both pictures (X)."},
    Controls::Option{"Difference",
                     "Difference of display intensity, largest channel, on an absolute scale."},
    Controls::Option{"Error", "Difference in 8-bit display steps, logarithmic."},
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

void size_row(Controls& controls, const Film& film, const Film& other) {
  if (other.width == film.width && other.height == film.height) return;
  controls.row(
      "Resampled",
      fmt::format("{} x {} to {} x {}", other.width, other.height, film.width, film.height),
      "The other picture has another size and is resampled. Edges differ for that reason.");
}

void comparison_controls(Controls& controls, Frames& frames) {
  if (controls.options("Shown as", comparisons, frames.comparison, {true, 0}))
    frames.flipped = frames.comparison == Comparison::flip;
  if (frames.comparison == Comparison::wipe)
    controls.slider("Wipe", "Position of the divider in percent of the width.", frames.wipe,
                    {0.0f, 1.0f, 0.5f}, percent_words);
  if (frames.comparison == Comparison::flip)
    controls.checkbox("Show other", "Show the other picture instead of the current one (X).",
                      frames.flipped, false);
  if (frames.comparison == Comparison::difference)
    controls.slider("Scale", "Difference shown as white, 0 to 1. 1/256 is one 8-bit step.",
                    frames.scale_stops, {-10.0f, 0.0f, -4.0f}, scale_words);
}

void snapshot_buttons(Controls& controls, const Previewer& previewer, Frames& frames) {
  const bool full = frames.stored.size() >= Frames::most;
  const int pressed =
      controls.buttons({{"Keep snapshot", full ? "Nine snapshots at most: delete one first."
                                               : "Keep the picture to compare with (S)."},
                        {"Delete snapshot", "Delete the chosen snapshot."}});
  if (pressed == 0) keep_snapshot(frames, previewer);
  if (pressed == 1) frames.remove(frames.chosen);
}

}  // namespace

void compare_panel(Controls& controls, const Previewer& previewer, UiState& state,
                   const PanelJobs& jobs) {
  if (!previewer.scene() || !controls.section("Compare", false)) return;
  Frames& frames = state.frames;
  // Only a shown comparison samples the reference.
  if (controls.options("With", sources, frames.with, {true, 0}) &&
      frames.with == CompareWith::reference && frames.comparison == Comparison::none)
    frames.comparison = Comparison::error;
  if (frames.with == CompareWith::snapshot) snapshot_buttons(controls, previewer, frames);
  if (frames.with == CompareWith::method)
    equal_time_controls(controls, previewer, state.equal_time, jobs.equal_time, frames);
  if (frames.with == CompareWith::reference)
    check_controls(controls, previewer, state.check, jobs.check, frames.reference.samples);
  comparison_controls(controls, frames);
  if (const std::optional<int> index = frames.compared())
    size_row(controls, previewer.render().film(), frames.film(*index));
  if (frames.stored.empty() && !frames.reference.film) return;
  snapshot_table(controls, previewer, frames);
  controls.row("Errors against",
               frames.reference.film
                   ? fmt::format("a reference of {} samples", frames.reference.samples)
                   : std::string("the chosen snapshot"),
               "Choose the reference above to measure errors against it.");
  if (!frames.stored.empty())
    controls.row("Closer", closer_words(frames),
                 "The one of picture and chosen snapshot with the smaller error.");
  if (controls.button("Copy errors", "Copy the table as CSV to the clipboard.", -1.0f))
    ImGui::SetClipboardText(snapshot_csv(frames).c_str());
}

std::string picture_words(const PreviewRender& render) {
  const Progress progress = render.progress();
  const std::string title = row_of(render.settings().method).title;
  if (progress.finished) return title + ", " + duration_words(progress.seconds);
  return fmt::format("{}, {:.0f} % done", title, std::floor(100.0 * progress.fraction));
}

std::string keep_snapshot(Frames& frames, const Previewer& previewer) {
  const PreviewRender& render = previewer.render();
  std::string name = snapshot_name(render.settings(), processor_seconds(render.film()));
  const Progress progress = render.progress();
  if (!progress.finished)
    name += fmt::format(", {:.0f} % done", std::floor(100.0 * progress.fraction));
  if (!frames.store(render.film(), std::move(name), summary_of(previewer)))
    return "Nine snapshots at most: delete one first";
  return fmt::format("Kept {}: {}", frames.stored.size(), frames.stored.back().name);
}

}  // namespace asos::ui
