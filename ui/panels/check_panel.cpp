#include "ui/panels/check_panel.h"

#include "renderer/comparison/method.h"
#include "ui/panels/overlays.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace asos {

namespace {

constexpr std::uint32_t missed_rgb = 0xff3b2f;
constexpr std::uint32_t wasted_rgb = 0x35a7ff;
constexpr std::size_t most_runs = 12'000;  // that are drawn

std::string alarm_words(double alarm) {
  return alarm > 0.0 ? fmt::format("{:.4f}  =  {:.1f} / 255", alarm, 255.0 * alarm)
                     : std::string("0: any");
}

std::string share_of(std::size_t part, std::size_t whole) {
  if (whole == 0) return "none";
  return fmt::format("{} ({:.1f} %)", part,
                     100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

// There from the start, so that nothing moves when they are known.
void finding_rows(Controls& controls, const SplitFindings* found, const Film& film) {
  std::string missed = "not known yet", wasted = missed, rmse = missed;
  if (found) {
    const std::size_t whole =
        film.radiance.size() - std::min(found->split_pixels, film.radiance.size());
    missed = share_of(found->missed_pixels, whole);
    wasted = share_of(found->wasted_pixels, found->split_pixels);
    rmse = fmt::format("{:.2g}, noise {:.2g}", found->rmse, found->noise);
  }
  controls.row("Missed splits", missed,
               "Pixels that were not split and are off the reference by more than the alarm and "
               "than its noise explains; as a share of those that were not split.");
  controls.row("Wasted splits", wasted,
               "Pixels that were split and came out as a single sample would have shown them, "
               "within a quarter of a step of an 8-bit picture; as a share of the split ones.");
  controls.row("RMSE", rmse,
               "Root mean square error of the picture against the reference, linear values clipped "
               "to 0 to 1, and how much of that is the reference's own.");
}

void draw_runs(const std::vector<PixelRun>& runs, std::uint32_t rgb, const PictureView& view,
               const PictureArea& area) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto window = [&](float x, float y) {
    const glm::vec2 at =
        area.rect.lo + (view.offset() + glm::vec2(x, y) * view.scale()) / area.scale;
    return ImVec2{at.x, at.y};
  };
  const bool large = view.scale() / area.scale >= 5.0f;
  std::size_t drawn = 0;
  for (const PixelRun& run : runs) {
    const auto x = static_cast<float>(run.x), y = static_cast<float>(run.y);
    const ImVec2 lo = window(x, y), hi = window(x + static_cast<float>(run.count), y + 1.0f);
    const glm::vec2 end = area.rect.lo + area.rect.size;
    if (hi.x < area.rect.lo.x || hi.y < area.rect.lo.y || lo.x > end.x || lo.y > end.y) continue;
    if (++drawn > most_runs) return;
    draw.AddRectFilled(lo, hi, theme::packed(rgb, large ? 0.25f : 0.85f));
    if (large) draw.AddRect(lo, hi, theme::packed(rgb));
  }
}

}  // namespace

void check_panel(Controls& controls, const Previewer& previewer, CheckChoice& choice,
                 const SplitCheck& check) {
  if (!previewer.scene() || !in_object_space(previewer.edits().settings().method) ||
      !controls.section("Missed splits", false))
    return;
  const CheckChoice usual;
  controls.checkbox(
      "Find missed",
      "Sample the finished picture's view in the background, with up to 256 samples a "
      "pixel, and mark where splitting was missed or wasted.",
      choice.check, usual.check);
  if (!choice.check) return;
  controls.log_slider("Above",
                      "The error of display intensity, 0 to 1, beyond which a pixel that was not "
                      "split is marked. Ctrl+click to type a value.",
                      choice.alarm, {0.0, 1.0, usual.alarm}, alarm_words);
  controls.checkbox("Missed", "Red: not split, and visibly off the reference.", choice.mark_missed,
                    usual.mark_missed);
  controls.checkbox("Wasted", "Blue: split, and no different from one sample.", choice.mark_wasted,
                    usual.mark_wasted);
  const SplitFindings* found = check.findings();
  std::string words = "when finished";
  if (check.busy()) words = "sampling";
  if (found)
    words = fmt::format("{} samples{}", found->passes * SplitCheck::samples_each,
                        check.busy() ? ", going on" : "");
  controls.row("Reference", words,
               "What the picture is compared with, and how many samples of each pixel.");
  finding_rows(controls, found, previewer.render().film());
}

void check_marks(const SplitFindings* findings, const CheckChoice& choice, const PictureView& view,
                 const PictureArea& area) {
  if (!findings || !choice.check || view.scale() <= 0.0f) return;
  if (choice.mark_wasted) draw_runs(findings->wasted, wasted_rgb, view, area);
  if (choice.mark_missed) draw_runs(findings->missed, missed_rgb, view, area);
}

}  // namespace asos
