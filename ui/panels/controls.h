#pragma once

#include "ui/theme.h"

#include <glm/glm.hpp>

#include <concepts>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

namespace asos::ui {

/// Writes four significant digits, or whole numbers from 10,000 to 10 million, with an exponent
/// only for extreme values: "14050", "0.000123", "1.5e+09".
[[nodiscard]] std::string number_words(double value);
/// Writes an angle in degrees with a decimal: "30.5°".
[[nodiscard]] std::string degree_words(float angle_deg);
/// Writes a fraction in whole percent: "25 %".
[[nodiscard]] std::string percent_words(float fraction);

/// The panels' widgets: a label on the left, the widget to its right, and a tooltip. Records the
/// place of each widget, so that tests can click it, and whether it has a tooltip. Values stay
/// within the given ranges, also typed ones. A double click on a control's name, on a slider or on
/// a number resets it. Use only between ImGui::NewFrame and Render.
class Controls {
 public:
  /// Whether an item edits something or only shows it.
  enum class Use { shows, edits };

  struct Placed {
    glm::vec2 lo, hi;  ///< window coordinates, y down
    bool has_tooltip = false;
    bool edits = false;
    glm::vec2 window{0.0f};  ///< top left of the ImGui window that contains it
    std::string words;       ///< the value of a row; of a section "open" or "folded"
    [[nodiscard]] glm::vec2 centre() const { return 0.5f * (lo + hi); }
  };

  void begin_frame(double now_seconds);

  /// Sliders show their value as text over a bar that is filled up to it, starting at 0 if the
  /// range contains 0. `words` formats the value; Ctrl+click types it.
  template <typename T>
  struct Range {
    T lo, hi;
    std::optional<T> reset;
  };
  bool slider(const char* name, const char* tooltip, float& value, const Range<float>& range,
              const std::function<std::string(float)>& words);
  bool slider(const char* name, const char* tooltip, int& value, const Range<int>& range,
              const std::function<std::string(int)>& words);
  bool slider(const char* name, const char* tooltip, double& value, const Range<double>& range,
              const std::function<std::string(float)>& words);
  /// A slider in degrees for an angle in radians.
  bool angle_slider(const char* name, const char* tooltip, double& angle_rad,
                    const Range<double>& range_deg,
                    const std::function<std::string(float)>& words = degree_words);
  /// A logarithmic slider from 0; the scale starts at 1/10000, for values with four decimals.
  bool log_slider(const char* name, const char* tooltip, double& value, const Range<double>& range,
                  const std::function<std::string(double)>& words);

  /// A number to drag. One pixel changes it by `step`, or for a size by a hundredth of its value if
  /// that is more.
  struct Drag {
    Range<double> range;
    double step = 0.01;
    bool is_size = false;
  };
  bool number(const char* name, const char* tooltip, double& value, const Drag& drag,
              const std::function<std::string(double)>& words);
  /// Three numbers in a row, recorded as "name/x", "name/y" and "name/z".
  bool vector(const char* name, const char* tooltip, glm::dvec3& value, double step,
              const glm::dvec3& reset);
  /// A linear colour of 0 to 1, edited as sRGB bytes, recorded as "name/r" and so on, with a picker
  /// that opens from the colour patch to the right.
  bool colour(const char* name, const char* tooltip, glm::vec3& linear, const glm::vec3& reset);

  bool checkbox(const char* name, const char* tooltip, bool& value,
                std::optional<bool> reset = std::nullopt);
  bool button(const char* name, const char* tooltip, float width = 0.0f);
  /// The width of each of `count` buttons in a row.
  [[nodiscard]] static float button_width(int count);

  /// A draggable point at `at` in window coordinates; the caller draws it.
  struct Handle {
    bool lit = false;                ///< being dragged or hovered
    bool reset = false;              ///< double-clicked
    std::optional<glm::vec2> moved;  ///< where it is dragged to
  };
  Handle handle(const char* name, const char* tooltip, glm::vec2 at);

  /// A choice of few options as buttons in a row. Each is recorded as "name/option".
  struct Option {
    const char* name;
    const char* tooltip;
  };
  /// Without a label, options take the whole width. They take several rows if one is too short.
  struct OptionsStyle {
    bool labelled = true;
    std::optional<int> reset;
  };
  /// The least width of one row of such buttons.
  [[nodiscard]] static float least_width(std::span<const Option> options);
  bool options(const char* name, std::span<const Option> options, int& chosen,
               const OptionsStyle& style = {true, std::nullopt});
  /// The same for an enumeration in the order of the options, or for off and on.
  template <typename T>
  requires(!std::same_as<T, int>) bool options(const char* name, std::span<const Option> options,
                                               T& chosen,
                                               const OptionsStyle& style = {true, std::nullopt}) {
    int index = static_cast<int>(chosen);
    if (!this->options(name, options, index, style)) return false;
    chosen = static_cast<T>(index);
    return true;
  }
  template <typename T>
  requires(!std::same_as<T, int>) bool options(const char* name, std::span<const Option> options,
                                               T& chosen, std::type_identity_t<T> reset) {
    return this->options(name, options, chosen, {true, static_cast<int>(reset)});
  }
  /// Draws buttons of equal width in a row. Returns the index of the pressed one; -1: none.
  [[nodiscard]] int buttons(std::initializer_list<Option> buttons);
  /// A choice of many options as a drop-down list.
  bool list(const char* name, const char* tooltip, std::span<const std::string> items, int& chosen,
            std::optional<int> reset = std::nullopt);
  /// The same with the first sentence of each option's tooltip next to its name.
  bool described_list(const char* name, std::span<const Option> options, int& chosen);

  /// Position of a row's value: after a long label, or aligned with the widgets around. `lines`:
  /// minimum height, so that changing values do not move other controls.
  struct RowStyle {
    bool beside_widgets = false;
    int lines = 1;
  };
  /// A row of text: a dim label and a value.
  void row(const char* label, const std::string& value, const char* tooltip = nullptr) {
    row(label, value, tooltip, RowStyle{});
  }
  void row(const char* label, const std::string& value, const char* tooltip, const RowStyle& style);
  /// A header that folds the controls below it. Its "?" button explains the section.
  bool section(const char* name, bool open_at_first = true);
  /// The sections that the user opened or folded, by name.
  [[nodiscard]] const std::map<std::string, bool>& sections() const { return folds_; }
  void set_sections(std::map<std::string, bool> sections) { folds_ = std::move(sections); }
  /// If `words` is not empty, shows only sections whose name, or a control's name, contains them.
  /// Opens these sections and highlights the names.
  void search(std::string words) {
    searched_ = std::move(words);
    found_any_ = false;
  }
  [[nodiscard]] bool searches() const { return !searched_.empty(); }
  /// Whether the search has shown a section.
  [[nodiscard]] bool found_any() const { return found_any_; }

  /// Records the item that was just drawn, and shows its tooltip once it has been hovered long
  /// enough.
  void placed(const std::string& name, const char* tooltip, Use use = Use::shows);
  /// The same for displayed text.
  void placed_words(const std::string& name, const std::string& words, const char* tooltip);
  /// Draws text and records it with `placed_words`.
  void text(const std::string& name, const std::string& words, const char* tooltip = nullptr);
  void dim_text(const std::string& name, const std::string& words, const char* tooltip = nullptr);
  /// Draws wrapped text in a warning's colour and records it; nothing if it is empty.
  void warning(const char* name, const std::string& words, theme::Colour = theme::warning);
  /// A text field over the whole width, with `hint` while it is empty. Returns whether Enter was
  /// pressed.
  bool text_field(const char* name, const char* tooltip, const char* hint, std::string& text);

  /// Records the current ImGui window.
  void placed_window(const std::string& name);

  /// Shows a text next to the item that was just drawn, like its tooltip, without delay.
  void tell(const std::string& name, const char* text);
  /// The control whose tooltip is shown, and its text; empty: none.
  struct Told {
    std::string name, text;
  };
  [[nodiscard]] const Told& told() const { return told_; }

  [[nodiscard]] const std::map<std::string, Placed>& all() const { return placed_; }
  /// Whether a tooltip has appeared or disappeared in this frame. The frame must be drawn again,
  /// because a tooltip gets its size in its first frame.
  [[nodiscard]] bool tooltip_changed() const { return tooltip_now_ != tooltip_before_; }
  /// Seconds from the frame's time until a tooltip is due.
  [[nodiscard]] std::optional<double> seconds_to_tooltip() const;

  /// During its lifetime, widgets have no labels and take the whole width.
  class Unlabelled {
   public:
    explicit Unlabelled(Controls& controls) : controls_(controls) { controls_.labelled_ = false; }
    ~Unlabelled() { controls_.labelled_ = true; }
    Unlabelled(const Unlabelled&) = delete;
    Unlabelled& operator=(const Unlabelled&) = delete;

   private:
    Controls& controls_;
  };

  /// Position of a value on a logarithmic slider from 0 to `most`: 0 to 1.
  [[nodiscard]] static float log_share(double value, double most);

  /// Left edge of widgets that have a label.
  static constexpr float label_width_em = 6.4f;

 private:
  void help_button(const char* section);
  void label(const char* name, const char* tooltip);
  void name_text(const char* name);
  void explain(const std::string& name, const char* tooltip);
  [[nodiscard]] double tooltip_wait(const std::string& name) const;
  void note_double_click(const char* name);
  template <typename T, typename Draw, typename Paint>
  bool edited(const char* name, const char* tooltip, T& value, const std::optional<T>& to,
              const Draw& draw, const Paint& paint);
  template <typename T>
  bool reset(const char* name, T& value, const std::optional<T>& to);
  bool drag(const std::string& id, double& value, const Drag& drag);
  void option_row(const char* name, std::span<const Option> options, int first, int& chosen);

  std::map<std::string, Placed> placed_;
  std::string resetting_;  // double-clicked; is reset until the button is released
  double now_seconds_ = 0.0;
  void note_in_section(const std::string& name);
  [[nodiscard]] bool found(const std::string& name) const;

  bool labelled_ = true;
  std::map<std::string, bool> folds_;
  std::string searched_;
  bool found_any_ = false;
  std::set<std::string> opened_;  // sections that were open at least once
  std::string section_;           // that is being drawn
  std::map<std::string, std::set<std::string>> in_sections_;  // names of controls
  std::string hovered_, hovered_before_;
  double hovered_since_seconds_ = 0.0;
  Told told_;
  bool tooltip_now_ = false, tooltip_before_ = false;
};

}  // namespace asos::ui
