#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace asos {

/// The panels' widgets: a label at the left, the widget beside it, a tooltip that says what it
/// means. Remembers where each was drawn, so that tests can aim at it, and which have a tooltip.
/// Values stay within the given ranges, typed ones too. Between ImGui::NewFrame and Render only.
class Controls {
 public:
  struct Placed {
    glm::vec2 lo, hi;  ///< window coordinates, y down
    bool has_tooltip = false;
    [[nodiscard]] glm::vec2 centre() const { return 0.5f * (lo + hi); }
  };

  void begin_frame(double now_seconds);

  /// Sliders show their value as text over a bar that is filled up to it, from 0 where the range
  /// holds it. `words` writes the value; Ctrl+click types it.
  bool slider(const char* name, const char* tooltip, float& value, float lo, float hi,
              const std::function<std::string(float)>& words);
  bool slider(const char* name, const char* tooltip, int& value, int lo, int hi,
              const std::function<std::string(int)>& words);
  /// From 0 to `hi` on a logarithmic scale that begins at 1/10000, for values with four decimals.
  bool log_slider(const char* name, const char* tooltip, double& value, double hi,
                  const std::function<std::string(double)>& words);
  bool checkbox(const char* name, const char* tooltip, bool& value);
  bool button(const char* name, const char* tooltip, float width = 0.0f);

  /// One of a few, as buttons side by side. Each option is remembered as "name/option".
  struct Option {
    const char* name;
    const char* tooltip;
  };
  /// Without a label they have the whole width, in two rows where one is too short for them.
  bool options(const char* name, std::span<const Option> options, int& chosen,
               bool labelled = true);
  /// One of many, as a list that drops down.
  bool list(const char* name, const char* tooltip, std::span<const std::string> items, int& chosen);

  /// A row of text: a dim label and a value.
  void row(const char* label, const std::string& value, const char* tooltip = nullptr);
  /// A headline that folds what follows; open at first.
  bool section(const char* name, bool open_at_first = true);

  /// Remembers the item just drawn, and shows its tooltip once the pointer has rested on it.
  void placed(const std::string& name, const char* tooltip);

  [[nodiscard]] const std::map<std::string, Placed>& all() const { return placed_; }
  /// When a tooltip is due, in seconds from the frame's time.
  [[nodiscard]] std::optional<double> seconds_to_tooltip() const;

 private:
  void label(const char* name);
  bool option_row(const char* name, std::span<const Option> options, int first, int& chosen);

  std::map<std::string, Placed> placed_;
  double now_seconds_ = 0.0;
  std::string hovered_, hovered_before_;
  double hovered_since_seconds_ = 0.0;
};

}  // namespace asos
