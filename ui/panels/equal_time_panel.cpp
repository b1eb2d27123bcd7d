#include "ui/panels/equal_time_panel.h"

#include "ui/panels/time_words.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace asos::ui {

namespace {

// Offers the methods that can render in a given time.
void rival_choice(Controls& controls, Method& method) {
  std::vector<Method> offered;
  std::vector<Controls::Option> options;
  for (const MethodRow& row : method_table()) {
    if (!can_be_timed(row)) continue;
    offered.push_back(row.value);
    options.push_back({row.title, row.about});
  }
  const auto place_of = [&](Method wanted) {
    return static_cast<int>(std::find(offered.begin(), offered.end(), wanted) - offered.begin());
  };
  int chosen = place_of(method);
  if (controls.options("Other method", options, chosen,
                       {false, place_of(EqualTimeChoice{}.method)}))
    method = offered[static_cast<std::size_t>(chosen)];
}

std::string news_words(const EqualTimeNews& news) {
  if (news.doing.empty()) return "starting";
  return fmt::format("{}: {:.0f} %", news.doing, std::floor(100.0 * news.fraction));
}

}  // namespace

// A frame that was rendered for another picture is discarded.
void update_equal_time(const Previewer& previewer, EqualTimeChoice& choice, EqualTimeJob& job,
                       Frames& frames) {
  const bool current = choice.restarts == previewer.render().restarts();
  if (!current && job.busy()) job.stop();
  auto outcome = job.take_outcome();
  if (!outcome || !current) return;
  if (!outcome->frame) {
    choice.news = std::move(*outcome);
    return;
  }
  if (!frames.store(outcome->frame->film, outcome->frame->name, outcome->frame->summary)) return;
  frames.with = CompareWith::method;
  frames.comparison = Comparison::wipe;
}

bool start_equal_time(const Previewer& previewer, EqualTimeChoice& choice, EqualTimeJob& job,
                      const Frames& frames) {
  const PreviewRender& render = previewer.render();
  if (!previewer.scene() || job.busy() || !render.progress().finished ||
      frames.stored.size() >= Frames::most)
    return false;
  choice.restarts = render.restarts();
  choice.news = {};
  Snapshot snapshot{previewer.scene().shared(), previewer.viewpoint().camera().camera(),
                    render.settings(), false};
  snapshot.settings.judged_tone = previewer.shown_tone();
  job.start([snapshot, method = choice.method, seconds = processor_seconds(render.film())](
                const std::stop_token& stop, const auto& tell) {
    auto frame = render_in_time(
        snapshot, method, seconds, [&] { return stop.stop_requested(); }, tell);
    if (frame) tell({std::move(frame), {}, 1.0});
  });
  return true;
}

void equal_time_progress(Controls& controls, const EqualTimeChoice& choice) {
  const std::string words = news_words(choice.news);
  ImGui::ProgressBar(static_cast<float>(choice.news.fraction), {-1.0f, 0.0f}, words.c_str());
  controls.placed_words("Comparison progress", words,
                        "Short renders first find the quality that takes the same CPU time.");
}

void equal_time_controls(Controls& controls, const Previewer& previewer, EqualTimeChoice& choice,
                         EqualTimeJob& job, const Frames& frames) {
  const PreviewRender& render = previewer.render();
  rival_choice(controls, choice.method);
  if (job.busy()) {
    if (controls.button("Cancel comparison", "Stop rendering the other method.", -1.0f)) job.stop();
  } else if (controls.button("Render and compare",
                             "Render this view by another method in the same CPU time. The result "
                             "is kept as a snapshot and shown behind a divider.",
                             -1.0f)) {
    start_equal_time(previewer, choice, job, frames);
  }
  std::string words = "(when finished)";
  if (render.progress().finished) words = processor_words(processor_seconds(render.film()));
  if (frames.stored.size() >= Frames::most) words = "delete a snapshot first";
  if (job.busy()) words = news_words(choice.news);
  controls.row("CPU time", words,
               "CPU time of the finished picture, all threads. The other method gets the same.");
}

}  // namespace asos::ui
