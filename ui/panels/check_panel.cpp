#include "ui/panels/check_panel.h"

#include "renderer/comparison/method.h"
#include "ui/panels/overlays.h"
#include "ui/panels/snapshot_table.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace asos::ui {

namespace {

// The picture under the marks is so dark that none of its pixels can have the marks' colours.
constexpr std::uint32_t missed_rgb = 0xff00ff;
constexpr std::uint32_t wasted_rgb = 0x00ffff;
constexpr float dimming = 0.65f;
constexpr std::size_t most_runs = 12'000;  // that are drawn

std::string alarm_words(double alarm) {
  return alarm > 0.0 ? fmt::format("{:.4f}  =  {:.1f} / 255", alarm, 255.0 * alarm)
                     : std::string("0 (any)");
}

std::string share_of(std::size_t part, std::size_t whole) {
  if (whole == 0) return "none";
  return fmt::format("{} ({:.1f} %)", part,
                     100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

// The rows are always shown, so that nothing moves once the values are known.
void finding_rows(Controls& controls, const SplitFindings* found, const Film& film) {
  std::string missed = "not known yet", wasted = missed, rmse = missed;
  if (found) {
    const std::size_t whole =
        film.radiance.size() - std::min(found->split_pixels, film.radiance.size());
    missed = share_of(found->missed_pixels, whole);
    wasted = share_of(found->wasted_pixels, found->split_pixels);
    rmse = fmt::format("{:.2g} ({}), noise {:.2g}", found->rmse, psnr_words(found->rmse),
                       found->noise);
  }
  controls.row("Missed splits", missed,
               "Unsplit pixels with an error above the threshold and the reference's noise. "
               "Percentage of unsplit pixels.");
  controls.row(
      "Unneeded splits", wasted,
      "Split pixels that one sample would have shown equally well. Percentage of split pixels.");
  controls.row("RMSE", rmse,
               "RMSE against the reference, clipped linear values, and the reference's own noise.");
}

}  // namespace

void draw_runs(const std::vector<PixelRun>& runs, std::uint32_t rgb, const PictureView& view,
               const PictureArea& area) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const bool large = view.scale() / area.scale >= 5.0f;
  std::size_t drawn = 0;
  for (const PixelRun& run : runs) {
    const auto x = static_cast<float>(run.x), y = static_cast<float>(run.y);
    const ImVec2 lo = place_of({x, y}, view, area);
    const ImVec2 hi = place_of({x + static_cast<float>(run.count), y + 1.0f}, view, area);
    const glm::vec2 end = area.rect.lo + area.rect.size;
    if (hi.x < area.rect.lo.x || hi.y < area.rect.lo.y || lo.x > end.x || lo.y > end.y) continue;
    if (++drawn > most_runs) return;
    draw.AddRectFilled(lo, hi, theme::packed(rgb, large ? 0.35f : 1.0f));
    if (large) draw.AddRect(lo, hi, theme::packed(rgb));
  }
}

void check_controls(Controls& controls, const Previewer& previewer, CheckChoice& choice,
                    const SplitCheck& check, int samples) {
  controls.row("Reference",
               samples > 0
                   ? fmt::format("{} samples{}", samples, check.busy() ? ", continuing" : "")
               : check.busy() ? std::string("sampling")
                              : std::string("(when finished)"),
               "Samples per pixel of the reference.");
  if (!in_object_space(previewer.edits().settings().method)) return;
  const CheckChoice usual;
  controls.checkbox("Check splits", "Mark pixels that are split too little or for nothing.",
                    choice.check, usual.check);
  if (!choice.check) return;
  controls.log_slider(
      "Threshold",
      "Error above which an unsplit pixel is marked, 0 to 1. Ctrl+click to type a value.",
      choice.alarm, {0.0, 1.0, usual.alarm}, alarm_words);
  controls.checkbox("Show missed", "Magenta: not split, but visibly different from the reference.",
                    choice.mark_missed, usual.mark_missed);
  controls.checkbox("Show unneeded", "Cyan: split, but one sample would suffice.",
                    choice.mark_wasted, usual.mark_wasted);
  finding_rows(controls, check.findings(), previewer.render().film());
}

void check_marks(const SplitFindings* findings, const CheckChoice& choice, const PictureView& view,
                 const PictureArea& area) {
  if (!findings || !choice.check || view.scale() <= 0.0f) return;
  if (!choice.mark_missed && !choice.mark_wasted) return;
  const glm::vec2 end = area.rect.lo + area.rect.size;
  ImGui::GetWindowDrawList()->AddRectFilled({area.rect.lo.x, area.rect.lo.y}, {end.x, end.y},
                                            theme::packed(0x000000, dimming));
  if (choice.mark_wasted) draw_runs(findings->wasted, wasted_rgb, view, area);
  if (choice.mark_missed) draw_runs(findings->missed, missed_rgb, view, area);
}

}  // namespace asos::ui
