#include "ui/panels/study_panel.h"

#include "ui/panels/study_plot.h"
#include "ui/screenshot.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace asos {

namespace {

constexpr const char* subject = "asos";

constexpr std::array reductions{
    Controls::Option{"Whole", "Pictures as large as the one in the window."},
    Controls::Option{"Half", "Pictures of half the width and height: a quarter of the time."},
    Controls::Option{"Quarter", "Pictures of a quarter of the width and height."},
};

void rival_boxes(Controls& controls, StudyChoice& choice) {
  ImGui::TextDisabled("ASOS beside");
  const float column = 0.5f * ImGui::GetContentRegionAvail().x;
  int place = 0;
  for (const std::string& method : ladder_methods()) {
    if (method == subject) continue;
    if (place++ % 2 == 1) ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + column);
    bool chosen = choice.rivals.contains(method);
    if (ImGui::Checkbox(method.c_str(), &chosen)) {
      if (chosen)
        choice.rivals.insert(method);
      else
        choice.rivals.erase(method);
    }
    controls.placed("Study/" + method, "Measure this method, over a ladder of its own settings.",
                    Controls::Use::edits);
  }
}

void choice_controls(Controls& controls, StudyChoice& choice) {
  const StudyChoice usual;
  rival_boxes(controls, choice);
  int chosen = choice.reduction == 1 ? 0 : choice.reduction == 2 ? 1 : 2;
  if (controls.options("Size", reductions, chosen, {true, 1})) choice.reduction = 1 << chosen;
  controls.slider("Budget",
                  "Seconds for the reference that errors are told against. Its first pass always "
                  "runs to the end; the methods take what they take. Ctrl+click to type a value.",
                  choice.budget_seconds, {1, 600, usual.budget_seconds},
                  [](int s) { return fmt::format("{} s", s); });
  controls.slider("Repetitions",
                  "How often each setting is rendered; times are the median. Ctrl+click to type a "
                  "value.",
                  choice.repetitions, {1, 9, usual.repetitions},
                  [](int n) { return fmt::format("{}", n); });
}

void start(StudyChoice& choice, ViewStudy& study, const Previewer& previewer) {
  const RenderSettings& shown = previewer.render().settings();
  const auto scene = previewer.scene().shared();
  const StudyPlan plan = plan_of(choice, screenshot_stem(scene->geometry->source), shown);
  const auto started = study.start({scene, previewer.viewpoint().camera().camera(), plan});
  choice.error = started ? "" : started.error().message();
}

void buttons(Controls& controls, StudyChoice& choice, ViewStudy& study,
             const Previewer& previewer) {
  if (study.busy()) {
    if (controls.button("Stop study", "End the study. What it found out stays.", -1.0f))
      study.stop();
  } else if (controls.button("Start study",
                             "Measure error against run time on the view as it is now, with the "
                             "sky, reflections and TR that it has, and else the settings of "
                             "\"asos report\" and not those above. Moving the camera "
                             "lets the study rest; it goes on with the view that it began with.",
                             -1.0f)) {
    start(choice, study, previewer);
  }
  if (choice.error.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, theme::packed(theme::alarm));
  ImGui::TextWrapped("%s", choice.error.c_str());
  ImGui::PopStyleColor();
  controls.placed("Study error", nullptr);
}

std::string words(const ViewStudy::State& state) {
  switch (state.phase) {
    case ViewStudy::Phase::none:
      return "";
    case ViewStudy::Phase::running:
      if (state.resting) return "Rests while other work takes the processors";
      return state.points_run < state.points ? "Now: " + state.doing
                                             : "Refining the reference: " + state.doing;
    case ViewStudy::Phase::stopped:
      return fmt::format("Stopped after {} of {} renders", state.points_run, state.points);
    case ViewStudy::Phase::finished:
      break;
  }
  return state.quiet ? "Finished"
                     : "Finished; the reference is noisy: a larger budget lowers the "
                       "floor";
}

void progress(Controls& controls, const ViewStudy::State& state) {
  if (state.phase == ViewStudy::Phase::running) {
    const float share = static_cast<float>(state.points_run) /
                        static_cast<float>(std::max<std::size_t>(1, state.points));
    const std::string text = fmt::format("{} of {} renders", state.points_run, state.points);
    ImGui::ProgressBar(share, {-1.0f, 0.0f}, text.c_str());
  }
  ImGui::TextWrapped("%s", words(state).c_str());
  controls.placed("Study progress", nullptr);
}

std::string median_text(const Verdict& verdict) {
  if (verdict.measured() == 0 && verdict.extrapolated > 0)
    return fmt::format("~{:.2f}", verdict.beyond_median);
  if (verdict.measured() == 0) return "n/a";
  return fmt::format("{:.2f}", verdict.median);
}

std::string range_text(const Verdict& verdict) {
  std::string text;
  if (verdict.measured() > 0) text = fmt::format("{:.2f} to {:.2f}", verdict.least, verdict.most);
  const auto add = [&](int count, const char* words) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, words);
  };
  add(verdict.extrapolated, "extrapolated (~)");
  add(verdict.unreached, "not reached");
  add(verdict.levelled, "never reached");
  return text;
}

void speed_table(Controls& controls, const SceneStudy& study) {
  const std::vector<Verdict> rows = verdicts(study.equal_error);
  ImGui::Spacing();
  ImGui::TextWrapped("Times slower than ASOS at equal error (below 1: faster)");
  if (!ImGui::BeginTable("slower", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp))
    return;
  for (const char* head : {"method", "median", "range"}) ImGui::TableSetupColumn(head);
  ImGui::TableHeadersRow();
  for (const Verdict& row : rows) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.method.c_str());
    controls.placed("Slower/" + row.method, nullptr);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(median_text(row).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(range_text(row).c_str());
  }
  ImGui::EndTable();
  controls.placed(
      "Slower",
      "Over the settings of ASOS that no other one of its settings beats, above the "
      "floor: the median, the least and the most. Not reached: settings whose error the "
      "method did not reach as far as it was measured.");
}

}  // namespace

StudyPlan plan_of(const StudyChoice& choice, const std::string& scene_name,
                  const RenderSettings& shown) {
  StudyPlan plan;
  plan.scenes = {scene_name};
  // In the order of the ladders, as in a report
  for (const std::string& method : ladder_methods())
    if (method == subject || choice.rivals.contains(method)) plan.methods.push_back(method);
  plan.look = look_of(shown);
  plan.texture_resolution = shown.texture.resolution;
  plan.width = std::max(1, shown.width / choice.reduction);
  plan.height = std::max(1, shown.height / choice.reduction);
  plan.repetitions = choice.repetitions;
  plan.budget_seconds = choice.budget_seconds;
  plan.threads = worker_count(shown.threads, true);
  return plan;
}

void update_study(ViewStudy& study, const Previewer& previewer, bool other_work) {
  if (study.scene() && study.scene() != previewer.scene().get()) study.clear();
  const OpenScene& scene = previewer.scene();
  study.update(other_work || previewer.render().progress().running || scene.loading().has_value() ||
               (scene && !scene->geometry->boundaries.known()));
}

void study_panel(Controls& controls, StudyChoice& choice, ViewStudy& study,
                 const Previewer& previewer) {
  if (!controls.section("Error against run time", false) || !previewer.scene()) return;
  // Shown while a study runs, too: what would come back at its end would move the rest.
  ImGui::BeginDisabled(study.busy());
  choice_controls(controls, choice);
  ImGui::EndDisabled();
  buttons(controls, choice, study, previewer);
  const ViewStudy::State state = study.state();
  if (state.phase == ViewStudy::Phase::none) return;
  progress(controls, state);
  const StudyPlot plot = plot_of(state.study);
  if (plot.lines.empty()) return;
  ImGui::BeginGroup();
  draw_plot(plot);
  ImGui::EndGroup();
  controls.placed("Study plot",
                  "Root mean square error over run time, both logarithmic: lower and further left "
                  "is better. Hollow points lie under the floor, where the reference's own noise "
                  "would be more than 12 % of the error; they are compared with nothing.");
  if (!state.study.equal_error.empty()) {
    speed_table(controls, state.study);
  } else if (state.phase != ViewStudy::Phase::running) {
    ImGui::TextWrapped(
        "Nothing to compare: no setting of ASOS is above the floor, or no other method was "
        "measured. A larger budget lowers the floor.");
    controls.placed("Nothing to compare", nullptr);
  }
}

}  // namespace asos
