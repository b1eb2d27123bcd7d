#pragma once

#include "ui/display_settings.h"
#include "ui/previewer.h"

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// Undo and redo of edits: settings, lights, camera, exposure and tone curve. Maps, layers and
/// other views of the picture are no edits. A drag, or a series of wheel
/// turns, is one step: a step ends when nothing has changed for a moment and no button is held.
/// Opening another scene clears the history. Hiding objects loads the scene again, so only earlier
/// changes of what is hidden can be undone after it. Not thread-safe.
class EditHistory {
 public:
  static constexpr std::size_t most_steps = 200;

  /// Call once a frame. `holding`: a mouse button is down, which keeps the step open.
  void update(const Previewer& previewer, const DisplaySettings& display, bool holding,
              double now_seconds);
  /// Return what has changed, such as "EPS" or "lights, camera"; none: there is no step to undo or
  /// redo.
  std::optional<std::string> undo(Previewer& previewer, DisplaySettings& display);
  std::optional<std::string> redo(Previewer& previewer, DisplaySettings& display);

  /// All steps between begin and end count as one, or as none if the state is the same at both. The
  /// group ends early when another scene is opened, or when an undo goes back before its begin.
  void begin_group(const Previewer& previewer, const DisplaySettings& display);
  void end_group(const Previewer& previewer, const DisplaySettings& display);
  [[nodiscard]] bool grouped() const { return group_.has_value(); }

  [[nodiscard]] bool can_undo() const { return changed_ || !past_.empty(); }
  [[nodiscard]] bool can_redo() const { return !changed_ && !future_.empty(); }
  /// Seconds until `update` is due without any input; none: no such time.
  [[nodiscard]] std::optional<double> seconds_to_update(double now_seconds) const;

 private:
  struct State {
    SceneEdits::State edits;
    Viewpoint::State viewpoint;
    DisplaySettings display;
  };
  [[nodiscard]] static State state_of(const Previewer& previewer, const DisplaySettings& display);
  [[nodiscard]] static bool is(const Previewer& previewer, const DisplaySettings& display,
                               const State& state);
  void end_step();
  void note_hidden(const OpenScene& scene);
  std::optional<std::string> show_earlier(std::deque<std::vector<ObjectId>>& from,
                                          std::deque<std::vector<ObjectId>>& to, OpenScene& scene);
  std::optional<std::string> step(std::deque<State>& from, std::deque<State>& to,
                                  Previewer& previewer, DisplaySettings& display);
  [[nodiscard]] static std::string changed_words(const Previewer& previewer,
                                                 const DisplaySettings& display,
                                                 const State& wanted);

  std::optional<State> settled_;  // at the end of the last step
  std::optional<State> seen_;     // in the last frame
  bool changed_ = false;          // seen_ differs from settled_
  double changed_seconds_ = 0.0;
  std::uint64_t scene_ = 0;
  std::deque<State> past_, future_;
  std::optional<std::size_t> group_;  // number of steps when the group began
  std::string source_;
  std::vector<ObjectId> hidden_;  // now
  std::deque<std::vector<ObjectId>> hidden_past_, hidden_future_;
};

}  // namespace asos::ui
