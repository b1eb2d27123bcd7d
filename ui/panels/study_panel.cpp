#include "ui/panels/study_panel.h"

#include "renderer/study/floor_bound.h"
#include "ui/input.h"
#include "ui/panels/study_export.h"
#include "ui/panels/study_marks.h"
#include "ui/screenshot.h"
#include "ui/theme.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace asos::ui {

namespace {

constexpr const char* subject = "asos";

constexpr std::array reductions{
    Controls::Option{"Full", "The window's resolution."},
    Controls::Option{"1/2", "Half the width and height, a quarter of the time."},
    Controls::Option{"1/4", "A quarter of the width and height."},
};

constexpr std::array budgets{
    Controls::Option{"60 s", "About a minute: the resolution follows from the scene's cost."},
    Controls::Option{"Custom", "Choose resolution, reference time and repetitions."},
};

constexpr std::array curve_options{
    Controls::Option{"Finished", "Finished pictures, one point per setting."},
    Controls::Option{"While rendering",
                     "Pictures of one render per method, from the first to the finished one. "
                     "Measured after all settings."},
};

void rival_boxes(Controls& controls, StudyChoice& choice) {
  ImGui::TextDisabled("Compare with");
  const float column = 0.5f * ImGui::GetContentRegionAvail().x;
  int place = 0;
  for (const std::string& method : ladder_methods()) {
    if (method == subject) continue;
    if (place++ % 2 == 1) ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + column);
    bool chosen = choice.rivals.contains(method);
    if (ImGui::Checkbox(method_title(method).c_str(), &chosen)) {
      if (chosen)
        choice.rivals.insert(method);
      else
        choice.rivals.erase(method);
    }
    controls.placed("Study/" + method, "Measure this method at several settings.",
                    Controls::Use::edits);
  }
}

void choice_controls(Controls& controls, StudyChoice& choice) {
  const StudyChoice usual;
  rival_boxes(controls, choice);
  bool custom = !choice.automatic;
  if (controls.options("Budget", budgets, custom, {true, 0})) choice.automatic = !custom;
  if (choice.automatic) return;
  int chosen = choice.reduction == 1 ? 0 : choice.reduction == 2 ? 1 : 2;
  if (controls.options("Resolution", reductions, chosen, {true, 1})) choice.reduction = 1 << chosen;
  controls.slider("Reference time",
                  "Seconds for the reference of all errors. Its first pass always finishes. "
                  "Ctrl+click to type a value.",
                  choice.budget_seconds, {1, 600, usual.budget_seconds},
                  [](int s) { return fmt::format("{} s", s); });
  controls.slider(
      "Repetitions", "Renders per setting; times are medians. Ctrl+click to type a value.",
      choice.repetitions, {1, 9, usual.repetitions}, [](int n) { return fmt::format("{}", n); });
}

void start(StudyChoice& choice, ViewStudy& study, const Previewer& previewer) {
  const RenderSettings& shown = previewer.render().settings();
  const auto scene = previewer.scene().shared();
  const StudyPlan plan = plan_of(choice, screenshot_stem(scene->geometry->source), shown);
  const auto started = study.start(
      {scene, previewer.viewpoint().camera().camera(), plan,
       choice.automatic ? std::optional(StudyChoice::automatic_seconds) : std::nullopt});
  choice.error = started ? "" : started.error().message();
}

void buttons(Controls& controls, StudyChoice& choice, ViewStudy& study,
             const Previewer& previewer) {
  if (study.busy()) {
    if (controls.button("Stop measuring", "Stop measuring. Results stay.", -1.0f)) study.stop();
  } else if (controls.button("Measure",
                             "Measure this view. Uses the settings of \"asos report\", not those "
                             "above. Pauses while you move the camera.",
                             -1.0f)) {
    start(choice, study, previewer);
  }
  controls.warning("Study error", choice.error, theme::alarm);
}

std::string words(const ViewStudy::State& state, bool automatic) {
  switch (state.phase) {
    case ViewStudy::Phase::none:
      return "";
    case ViewStudy::Phase::running:
      if (state.resting) return "Paused while other work uses the CPU";
      if (state.doing.empty()) return "Finding edges";
      return state.points_run < state.points ? "Now: " + state.doing
                                             : "Refining the reference: " + state.doing;
    case ViewStudy::Phase::stopped:
      return fmt::format("Stopped after {} of {} renders", state.points_run, state.points);
    case ViewStudy::Phase::finished:
      break;
  }
  if (state.quiet) return "Finished";
  return automatic ? "Finished. Hollow points are below the noise floor."
                   : "Finished. The reference is noisy; increase the reference time.";
}

void progress(Controls& controls, const ViewStudy::State& state, bool automatic) {
  const float share = static_cast<float>(state.points_run) /
                      static_cast<float>(std::max<std::size_t>(1, state.points));
  const std::string text = fmt::format("{} of {} renders", state.points_run, state.points);
  ImGui::ProgressBar(share, {-1.0f, 0.0f}, text.c_str());
  ImGui::TextWrapped("%s", words(state, automatic).c_str());
  controls.placed("Study progress", nullptr);
}

void curves_choice(Controls& controls, StudyChoice& choice) {
  controls.options("Curves", curve_options, choice.curves, {false, 0});
}

std::string median_text(const MethodComparison& verdict) {
  if (verdict.measured() == 0 && verdict.extrapolated > 0)
    return fmt::format("~{:.2f}", verdict.beyond_median);
  if (verdict.measured() == 0) return "not reached";
  return fmt::format("{:.2f}", verdict.median);
}

std::string range_text(const MethodComparison& verdict) {
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

// A bound below 1 does not tell which method is faster.
bool says_faster(const std::optional<FloorBound>& bound) {
  return bound && bound->factor > 1.0;
}

bool any_bound(const SceneStudy& study) {
  return std::any_of(study.points.begin(), study.points.end(), [&](const StudyPoint& p) {
    return p.rung.method != subject && says_faster(bound_at_floor(study, p.rung.method));
  });
}

void speed_row(Controls& controls, const std::string& method, const std::string& median,
               const std::string& range) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(method_title(method).c_str());
  controls.placed_words("Slower/" + method, median.empty() ? range : median, nullptr);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(median.c_str());
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", range.c_str());
}

// The measured methods except ASOS, in their order.
std::vector<std::string> rivals_of(const SceneStudy& study) {
  std::vector<std::string> methods;
  for (const StudyPoint& point : study.points)
    if (point.rung.method != subject &&
        std::find(methods.begin(), methods.end(), point.rung.method) == methods.end())
      methods.push_back(point.rung.method);
  return methods;
}

void speed_table(Controls& controls, const SceneStudy& study) {
  const std::vector<MethodComparison> rows = verdicts(study.equal_error);
  ImGui::Spacing();
  ImGui::TextWrapped("Time over ASOS at equal error (below 1: faster)");
  if (!ImGui::BeginTable("slower", 3, ImGuiTableFlags_RowBg)) return;
  const float em = ImGui::GetFontSize();
  ImGui::TableSetupColumn("Method", ImGuiTableColumnFlags_WidthFixed, 7.5f * em);
  ImGui::TableSetupColumn("Median", ImGuiTableColumnFlags_WidthFixed, 4.0f * em);
  ImGui::TableSetupColumn("Range", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableHeadersRow();
  for (const std::string& rival : rivals_of(study)) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const MethodComparison& verdict) {
      return verdict.method == rival;
    });
    if (row != rows.end())
      speed_row(controls, rival, median_text(*row), range_text(*row));
    else if (const auto bound = bound_at_floor(study, rival); says_faster(bound))
      speed_row(controls, rival, over_words(bound->factor), "ASOS below the noise floor");
    else
      speed_row(controls, rival, "", "below the noise floor");
  }
  ImGui::EndTable();
  controls.placed("Slower",
                  "Time ratios over ASOS's best settings above the noise floor: median, minimum "
                  "and maximum. Not reached: the method did not reach that error. Over: lower "
                  "bound, from the time to reach the noise floor.");
}

void enlarged_plot(Controls& controls, StudyChoice& choice, const StudyPlot& plot) {
  constexpr const char* title = "Error vs. CPU time";
  if (choice.enlarged && !ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({0.94f * window.x, 0.94f * window.y});
  if (!ImGui::BeginPopupModal(
          title, nullptr,
          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings))
    return;
  const float legend =
      static_cast<float>(legend_rows(plot)) * ImGui::GetTextLineHeightWithSpacing();
  const float others = legend + ImGui::GetFrameHeight() + 2.0f * ImGui::GetStyle().ItemSpacing.y;
  draw_plot(plot, std::max(10.0f, (ImGui::GetContentRegionAvail().y - others) / em));
  const bool closed = controls.button("Close plot", "Back to the panel (Esc).") ||
                      ImGui::IsKeyPressed(static_cast<int>(Key::escape), false);
  if (closed) {
    choice.enlarged = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void save_text(StudyChoice& choice, const std::string& source, const char* extension,
               const std::string& text) {
  const auto saved =
      save_study_text(screenshot_folder().string(), screenshot_stem(source), extension, text);
  choice.said = saved ? "Saved " + *saved : "Not saved: " + saved.error().message();
}

void plot_buttons(Controls& controls, StudyChoice& choice, const SceneStudy& study,
                  const StudyPlot& plot, const std::string& source) {
  if (controls.button("Enlarge plot", "Show the plot over the whole window.", -1.0f))
    choice.enlarged = true;
  const int copied = controls.buttons({{"Copy plot", "Copy the plot as SVG text to the clipboard."},
                                       {"Copy table", "Copy all points as CSV to the clipboard."}});
  const int saved = controls.buttons(
      {{"Save plot", "Save the plot as SVG."}, {"Save table", "Save all points as CSV."}});
  const auto text = [&](int which) {
    return which == 0 ? plot_svg(plot, screenshot_stem(source)) : study_csv(study);
  };
  if (copied >= 0) {
    ImGui::SetClipboardText(text(copied).c_str());
    choice.said = copied == 0 ? "Copied the plot as SVG" : "Copied the study as CSV";
  }
  if (saved >= 0) save_text(choice, source, saved == 0 ? "svg" : "csv", text(saved));
  enlarged_plot(controls, choice, plot);
}

}  // namespace

std::string over_words(double factor) {
  const double shown = factor < 10.0 ? std::floor(10.0 * factor) / 10.0 : std::floor(factor);
  return fmt::format("over {:g}", shown);
}

StudyPlan plan_of(const StudyChoice& choice, const std::string& scene_name,
                  const RenderSettings& shown) {
  StudyPlan plan;
  plan.scenes = {scene_name};
  // In the order of the ladders, as in a report.
  for (const std::string& method : ladder_methods())
    if (method == subject || choice.rivals.contains(method)) plan.methods.push_back(method);
  plan.look = look_of(shown);
  plan.texture_resolution = shown.texture.resolution;
  const int reduction = choice.automatic ? 1 : choice.reduction;
  plan.width = std::max(1, shown.width / reduction);
  plan.height = std::max(1, shown.height / reduction);
  plan.repetitions = choice.repetitions;
  plan.budget_seconds = choice.budget_seconds;
  plan.threads = worker_count(shown.threads, true);
  return plan;
}

void update_study(ViewStudy& study, const Previewer& previewer, bool other_work) {
  if (study.scene() && study.scene() != previewer.scene().get()) study.clear();
  const OpenScene& scene = previewer.scene();
  study.update(other_work || previewer.render().progress().running || scene.loading().has_value() ||
               (scene && scene->geometry->boundaries.running()));
}

void study_panel(Controls& controls, StudyChoice& choice, ViewStudy& study,
                 const Previewer& previewer) {
  if (!controls.section("Error vs. time", false) || !previewer.scene()) return;
  // The controls stay visible, but disabled, during a study: hiding them would move the rest.
  ImGui::BeginDisabled(study.busy());
  choice_controls(controls, choice);
  ImGui::EndDisabled();
  buttons(controls, choice, study, previewer);
  const ViewStudy::State state = study.state();
  if (state.phase == ViewStudy::Phase::none) return;
  progress(controls, state, choice.automatic);
  if (state.study.points.empty()) return;
  curves_choice(controls, choice);
  const StudyPlot plot = plot_of(state.study, choice.curves);
  ImGui::BeginGroup();
  draw_plot(plot);
  ImGui::EndGroup();
  controls.placed("Study plot",
                  "RMSE vs. CPU time (log-log); lower left is better. Hollow points are below the "
                  "reference's noise and are not compared.");
  plot_buttons(controls, choice, state.study, plot, previewer.scene()->geometry->source);
  const bool running = state.phase == ViewStudy::Phase::running;
  if (!state.study.equal_error.empty() || (!running && any_bound(state.study))) {
    speed_table(controls, state.study);
  } else if (!running) {
    ImGui::TextWrapped(
        "Nothing to compare above the noise floor. Increase the reference time or choose another "
        "method.");
    controls.placed("Nothing to compare", nullptr);
  }
}

}  // namespace asos::ui
