#pragma once

#include "ui/display_settings.h"
#include "ui/previewer.h"

#include <cstddef>
#include <deque>
#include <optional>

namespace asos::ui {

/// Undo and redo of what a person edits: settings, lights, camera and display. What belongs
/// together, as a drag or turns of the wheel, is one step: a step ends when nothing has changed for
/// a moment and nothing is held. Another scene forgets all steps. One thread.
class EditHistory {
 public:
  static constexpr std::size_t most_steps = 200;

  /// Call once a frame. `holding`: a mouse button is down, so that the step goes on.
  void update(const Previewer& previewer, const DisplaySettings& display, bool holding,
              double now_seconds);
  /// False where there is nothing to take back, or to do again.
  bool undo(Previewer& previewer, DisplaySettings& display);
  bool redo(Previewer& previewer, DisplaySettings& display);

  /// From begin to end all steps count as one, or as none where the end equals the begin. Ends
  /// itself with the scene, and where steps from before it were taken back.
  void begin_group(const Previewer& previewer, const DisplaySettings& display);
  void end_group(const Previewer& previewer, const DisplaySettings& display);
  [[nodiscard]] bool grouped() const { return group_.has_value(); }

  [[nodiscard]] bool can_undo() const { return changed_ || !past_.empty(); }
  [[nodiscard]] bool can_redo() const { return !changed_ && !future_.empty(); }
  /// When `update` should be called though nothing happens, in seconds; none: when it does.
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
  bool step(std::deque<State>& from, std::deque<State>& to, Previewer& previewer,
            DisplaySettings& display);

  std::optional<State> settled_;  // at the end of the last step
  std::optional<State> seen_;     // in the last frame
  bool changed_ = false;          // seen_ differs from settled_
  double changed_seconds_ = 0.0;
  std::uint64_t scene_ = 0;
  std::deque<State> past_, future_;
  std::optional<std::size_t> group_;  // steps that were there when it began
};

}  // namespace asos::ui
