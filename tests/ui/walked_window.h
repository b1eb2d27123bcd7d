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

/// A window in memory that runs a script: each time the loop processes events, one step of the
/// script runs. Counts the loop's work between two steps.
class WalkedWindow final : public HostWindow {
 public:
  /// A step, and the name of its action for messages.
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
  [[nodiscard]] WindowEvents take_happened() override { return std::exchange(happened_, {}); }

  void add(InputEvent event) { happened_.input.push_back(std::move(event)); }
  WindowEvents& happened() { return happened_; }
  /// 0: minimised.
  void resize(glm::ivec2 size);
  /// The next steps, one per wait; later waits do nothing.
  std::deque<Step> steps;
  /// Called by each wait without steps.
  std::function<void(WalkedWindow&)> idle;
  /// Called if frames are drawn without end although there were no events.
  std::function<void()> give_up;

  /// The loop's clock: wall-clock time, plus `seconds_per_frame` for every frame.
  [[nodiscard]] double now_seconds() const;
  double seconds_per_frame = 0.0;

  /// Maxima between two waits.
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
  WindowEvents happened_;
  std::string title_, action_ = "the first frame";
  int frames_ = 0, frames_since_ = 0;
  double processor_since_ = 0.0, wall_since_ = 0.0;
  Between most_;
};

}  // namespace asos::test
