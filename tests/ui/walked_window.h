#pragma once

#include "tests/ui/osmesa_context.h"
#include "ui/host_window.h"

#include <glm/glm.hpp>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace asos::test {
using namespace ui;

/// A window in memory that a script uses: each time that the loop hears what has happened, one step
/// of the script happens. Counts what the loop does between two of these times.
class WalkedWindow final : public HostWindow {
 public:
  /// A step, and the action that it belongs to, for messages.
  struct Step {
    std::string action;
    std::function<void(WalkedWindow&)> run;
  };

  explicit WalkedWindow(glm::ivec2 size);

  void wait(std::optional<double> seconds) override;
  void present() override;
  void set_title(const std::string& title) override { title_ = title; }
  [[nodiscard]] bool visible() const override { return size_.x > 0 && size_.y > 0; }
  [[nodiscard]] glm::ivec2 size() const override { return size_; }
  [[nodiscard]] glm::ivec2 plain_size() const override { return size_; }
  [[nodiscard]] glm::ivec2 framebuffer_size() const override { return size_; }
  [[nodiscard]] float content_scale() const override { return 1.0f; }
  [[nodiscard]] Happened take_happened() override { return std::exchange(happened_, {}); }

  void add(InputEvent event) { happened_.input.push_back(std::move(event)); }
  Happened& happened() { return happened_; }
  /// 0: minimised.
  void resize(glm::ivec2 size);
  /// Done by the next waits, one each; later ones do nothing.
  std::deque<Step> steps;
  /// Called once no step is left, by each wait.
  std::function<void(WalkedWindow&)> idle;
  /// Called when frames follow each other without end though nothing was heard in between.
  std::function<void()> give_up;

  /// The loop's clock: that of the wall, and as slow as `seconds_per_frame` makes every frame.
  [[nodiscard]] double now_seconds() const;
  double seconds_per_frame = 0.0;

  /// What happened between two waits, at most.
  struct Between {
    int frames = 0;
    double processor_ms = 0.0;  ///< of the main thread
    double wall_ms = 0.0;
    std::string processor_action, wall_action;  ///< of the step before
  };
  [[nodiscard]] const Between& most() const { return most_; }
  [[nodiscard]] int frames() const { return frames_; }
  [[nodiscard]] const std::string& action() const { return action_; }

 private:
  void note_heard();

  std::unique_ptr<OsmesaContext> context_;
  glm::ivec2 size_;
  Happened happened_;
  std::string title_, action_ = "the first frame";
  int frames_ = 0, frames_since_ = 0;
  double processor_since_ = 0.0, wall_since_ = 0.0;
  Between most_;
};

}  // namespace asos::test
