#include "ui/panels/snapshot_table.h"

#include "renderer/study/measures.h"
#include "ui/panels/study_export.h"
#include "ui/resampled.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace asos::ui {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double error_of(Frames& frames, const Film& film) {
  if (film.width <= 0) return unknown;
  if (const Film* reference = frames.reference.film.get())
    return common_rmse(film, *reference, resampled(*reference, {film.width, film.height}));
  const StoredFrame& chosen = frames.stored[static_cast<std::size_t>(frames.chosen)];
  return common_rmse(film, chosen.film, frames.at_size(frames.chosen, {film.width, film.height}));
}

// Whether the other errors are differences from this snapshot.
bool compared_with(const Frames& frames, std::size_t index) {
  return !frames.reference.film && static_cast<int>(index) == frames.chosen;
}

// Measures again when the picture is finished, or when another snapshot is chosen.
void measure_all(const PreviewRender& render, Frames& frames) {
  const Film& film = render.film();
  const bool finished = render.progress().finished && film.width > 0;
  const Frames::Measured now{render.restarts(), frames.reference.revision, frames.revision,
                             frames.chosen, finished};
  if (now == frames.measured) return;
  frames.measured = now;
  frames.rmse = finished ? error_of(frames, film) : unknown;
  frames.stored_rmse.clear();
  for (std::size_t i = 0; i < frames.stored.size(); ++i)
    frames.stored_rmse.push_back(
        compared_with(frames, i) ? 0.0 : error_of(frames, frames.stored[i].film));
}

void cells(double rmse, bool compared) {
  ImGui::TableNextColumn();
  if (compared) {
    ImGui::TextDisabled("compared");
    ImGui::TableNextColumn();
    return;
  }
  const bool known = !std::isnan(rmse);
  ImGui::TextUnformatted(
      known ? (rmse > 0.0 ? fmt::format("{:.1e}", rmse) : std::string("0")).c_str() : "...");
  ImGui::TableNextColumn();
  if (known) ImGui::TextUnformatted(psnr_words(rmse).c_str());
}

std::string csv_row(const std::string& name, const std::string& reference, double rmse) {
  std::string text = csv_cell(name) + "," + csv_cell(reference) + ",";
  if (std::isnan(rmse)) return text + ",\n";
  text += fmt::format("{:.6g},", rmse);
  return text + (rmse > 0.0 ? fmt::format("{:.2f}\n", -20.0 * std::log10(rmse)) : "inf\n");
}

std::string compared_name(const Frames& frames) {
  if (frames.reference.film) return fmt::format("Reference, {} spp", frames.reference.samples);
  return frames.title(frames.stored[static_cast<std::size_t>(frames.chosen)]);
}

bool snapshot_row(Controls& controls, const Frames& frames, std::size_t index) {
  const StoredFrame& frame = frames.stored[index];
  const bool chosen = static_cast<int>(index) == frames.chosen;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(index));
  const bool clicked =
      ImGui::Selectable(fmt::format("{}  {}", index + 1, frames.title(frame)).c_str(), chosen,
                        ImGuiSelectableFlags_SpanAllColumns);
  ImGui::PopID();
  const std::string tooltip =
      fmt::format("{}. Press {} to show it, and again for the picture.", frame.summary, index + 1);
  controls.placed(fmt::format("Snapshot/{}", index + 1), tooltip.c_str(), Controls::Use::edits);
  cells(frames.stored_rmse[index], compared_with(frames, index));
  return clicked;
}

}  // namespace

double common_rmse(const Film& a, const Film& b, const Film& sized) {
  const PixelRect area = resampled_area(b, {a.width, a.height});
  double sum = 0.0;
  for (int y = area.y; y < area.y + area.height; ++y) {
    for (int x = area.x; x < area.x + area.width; ++x) {
      const std::size_t i = a.index(x, y);
      sum += squared_error(a.radiance[i], sized.radiance[i], true);
    }
  }
  return std::sqrt(sum / std::max(1.0, static_cast<double>(area.width) * area.height));
}

std::string scale_words(float stops) {
  return stops >= 0.0f ? std::string("1") : fmt::format("1/{:.3g}", std::exp2(-stops));
}

std::string psnr_words(double rmse) {
  return rmse > 0.0 ? fmt::format("{:.1f} dB", -20.0 * std::log10(rmse)) : "identical";
}

std::string closer_words(const Frames& frames) {
  const auto chosen = static_cast<std::size_t>(frames.chosen);
  if (!frames.reference.film || chosen >= frames.stored_rmse.size()) return "not known yet";
  const double own = frames.rmse, other = frames.stored_rmse[chosen];
  if (std::isnan(own) || std::isnan(other)) return "not known yet";
  if (own == other) return "equally close";
  const std::string who =
      own < other ? std::string("Current picture") : fmt::format("Snapshot {}", chosen + 1);
  const double less = std::min(own, other), more = std::max(own, other);
  return less > 0.0 ? fmt::format("{}, {:.2g} times", who, more / less) : who + ", no error";
}

std::string snapshot_csv(const Frames& frames) {
  std::string text = "picture,compared with,rmse,psnr_db\n";
  if (frames.stored.empty()) return text;
  const std::string reference = compared_name(frames);
  text += csv_row("Current picture", reference, frames.rmse);
  for (std::size_t i = 0; i < frames.stored_rmse.size(); ++i)
    if (!compared_with(frames, i))
      text += csv_row(frames.title(frames.stored[i]), reference, frames.stored_rmse[i]);
  return text;
}

void snapshot_table(Controls& controls, const Previewer& previewer, Frames& frames) {
  measure_all(previewer.render(), frames);
  if (!ImGui::BeginTable("snapshots", 3, ImGuiTableFlags_RowBg)) return;
  const float em = ImGui::GetFontSize();
  ImGui::TableSetupColumn("Snapshot", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("RMSE", ImGuiTableColumnFlags_WidthFixed, 4.0f * em);
  ImGui::TableSetupColumn("PSNR", ImGuiTableColumnFlags_WidthFixed, 4.6f * em);
  ImGui::TableHeadersRow();
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted("Current picture");
  controls.placed(
      "Picture error",
      frames.reference.film
          ? "Error against the reference, linear values from 0 to 1. Known when the "
            "picture is finished."
          : "Difference from the chosen snapshot, linear values from 0 to 1. Known when "
            "the picture is finished.");
  cells(frames.rmse, false);
  for (std::size_t i = 0; i < frames.stored.size(); ++i)
    if (snapshot_row(controls, frames, i)) frames.chosen = static_cast<int>(i);
  ImGui::EndTable();
}

}  // namespace asos::ui
