#include "ui/unsaved_work.h"

#include "ui/frames.h"
#include "ui/picture_job.h"
#include "ui/previewer.h"

#include <fmt/format.h>

#include <filesystem>

namespace asos::ui {

UnsavedWork::Edits UnsavedWork::edits_of(const Previewer& previewer) {
  const SceneEdits::State& state = previewer.edits().state();
  return {previewer.scene().times_opened(), state.look.lights_revision, state.look.dfrs_revision,
          state.settings.sky.get()};
}

std::optional<UnsavedWork::Edits> UnsavedWork::in_picture(const Previewer& previewer) {
  const Snapshot rendered = previewer.render().snapshot();
  const bool newest = !previewer.edits().relighting() &&
                      rendered.scene == previewer.scene().shared() &&
                      rendered.settings.sky == previewer.edits().settings().sky;
  return newest ? std::optional(edits_of(previewer)) : std::nullopt;
}

void UnsavedWork::update(const Previewer& previewer) {
  if (saved_.scene == previewer.scene().times_opened()) return;
  const SceneEdits::Revisions& opened = previewer.edits().opened_revisions();
  saved_ = edits_of(previewer);
  // Edits that a reload has kept are not saved.
  saved_.lights = opened.lights;
  saved_.dfrs = opened.dfrs;
}

void UnsavedWork::note_saved(const Edits& edits) {
  if (edits.scene == saved_.scene) saved_ = edits;
}

void UnsavedWork::note_exported(const Edits& edits) {
  if (edits.scene != saved_.scene) return;
  saved_.lights = edits.lights;
  saved_.dfrs = edits.dfrs;
}

std::vector<std::string> UnsavedWork::edits(const Previewer& previewer) const {
  std::vector<std::string> lines;
  const Edits now = edits_of(previewer);
  const SceneEdits::State& state = previewer.edits().state();
  if (state.lights_edited && now.lights != saved_.lights) lines.emplace_back("Edited lights");
  if (state.dfrs_edited && now.dfrs != saved_.dfrs) lines.emplace_back("DFR edits");
  return lines;
}

std::vector<std::string> UnsavedWork::lines(const Previewer& previewer, const Frames& frames,
                                            const PictureJob& saving) const {
  std::vector<std::string> lines = edits(previewer);
  if (edits_of(previewer).sky != saved_.sky) lines.emplace_back("Chosen sky");
  if (const std::size_t count = frames.stored.size(); count > 0)
    lines.push_back(count == 1 ? std::string("1 snapshot") : fmt::format("{} snapshots", count));
  if (const auto state = saving.state())
    lines.push_back(fmt::format("Picture being saved: {}, {:.0f} %",
                                std::filesystem::path(state->path).filename().string(),
                                100.0 * state->fraction));
  return lines;
}

}  // namespace asos::ui
