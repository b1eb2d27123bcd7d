#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>

namespace asos::ui {

/// Four digits, and powers of ten only where a person would write them, too: "14050", "0.000123",
/// "1.5e+09".
[[nodiscard]] std::string number_words(double value);

/// The panels' widgets: a label at the left, the widget beside it, a tooltip that says what it
/// means. Remembers where each was drawn, so that tests can aim at it, and which have a tooltip.
/// Values stay within the given ranges, typed ones too. A double click on a control's name, or on a
/// slider or number itself, resets it. Between ImGui::NewFrame and Render only.
class Controls {
 public:
  /// Whether an item changes something, or only shows it.
  enum class Use { shows, edits };

  struct Placed {
    glm::vec2 lo, hi;  ///< window coordinates, y down
    bool has_tooltip = false;
    bool edits = false;
    glm::vec2 window{0.0f};  ///< where the ImGui window begins that it is in
    std::string words;       ///< the value of a row; of a section "open" or "folded"
    [[nodiscard]] glm::vec2 centre() const { return 0.5f * (lo + hi); }
  };

  void begin_frame(double now_seconds);

  /// Sliders show their value as text over a bar that is filled up to it, from 0 where the range
  /// holds it. `words` writes the value; Ctrl+click types it.
  template <typename T>
  struct Range {
    T lo, hi;
    std::optional<T> reset;
  };
  bool slider(const char* name, const char* tooltip, float& value, const Range<float>& range,
              const std::function<std::string(float)>& words);
  bool slider(const char* name, const char* tooltip, int& value, const Range<int>& range,
              const std::function<std::string(int)>& words);
  /// From 0 on a logarithmic scale that begins at 1/10000, for values with four decimals.
  bool log_slider(const char* name, const char* tooltip, double& value, const Range<double>& range,
                  const std::function<std::string(double)>& words);

  /// A number that is dragged: a pixel changes it by `step`, or by a hundredth of itself where that
  /// is more and it is a size.
  struct Drag {
    Range<double> range;
    double step = 0.01;
    bool is_size = false;
  };
  bool number(const char* name, const char* tooltip, double& value, const Drag& drag,
              const std::function<std::string(double)>& words);
  /// Three of them in a row, remembered as "name/x", "name/y" and "name/z".
  bool vector(const char* name, const char* tooltip, glm::dvec3& value, double step,
              const glm::dvec3& reset);
  /// A linear colour of 0 to 1 by red, green and blue as sRGB bytes, remembered as "name/r" and so
  /// on, and a picker that opens from the patch beside them.
  bool colour(const char* name, const char* tooltip, glm::vec3& linear, const glm::vec3& reset);

  bool checkbox(const char* name, const char* tooltip, bool& value,
                std::optional<bool> reset = std::nullopt);
  bool button(const char* name, const char* tooltip, float width = 0.0f);

  /// A place to take hold of, around `at` in window coordinates; what it looks like is the
  /// caller's.
  struct Handle {
    bool lit = false;                ///< held, or under the pointer
    bool reset = false;              ///< double-clicked
    std::optional<glm::vec2> moved;  ///< where it is dragged to
  };
  Handle handle(const char* name, const char* tooltip, glm::vec2 at);

  /// One of a few, as buttons side by side. Each option is remembered as "name/option".
  struct Option {
    const char* name;
    const char* tooltip;
  };
  /// Without a label they have the whole width, in two rows where one is too short for them.
  struct OptionsStyle {
    bool labelled = true;
    std::optional<int> reset;
  };
  bool options(const char* name, std::span<const Option> options, int& chosen,
               const OptionsStyle& style = {true, std::nullopt});
  /// One of many, as a list that drops down.
  bool list(const char* name, const char* tooltip, std::span<const std::string> items, int& chosen,
            std::optional<int> reset = std::nullopt);

  /// Where a row's value stands: right of long labels, or in line with the widgets around; and of
  /// how many lines it has the room at least, so that what changes moves nothing.
  struct RowStyle {
    bool beside_widgets = false;
    int lines = 1;
  };
  /// A row of text: a dim label and a value.
  void row(const char* label, const std::string& value, const char* tooltip = nullptr) {
    row(label, value, tooltip, RowStyle{});
  }
  void row(const char* label, const std::string& value, const char* tooltip, const RowStyle& style);
  /// A headline that folds what follows; open at first. Its "?" says what the section is for.
  bool section(const char* name, bool open_at_first = true);
  /// The sections that were opened or folded, by name.
  [[nodiscard]] const std::map<std::string, bool>& sections() const { return folds_; }
  void set_sections(std::map<std::string, bool> sections) { folds_ = std::move(sections); }
  /// While `words` is not empty, only sections are shown that have them in their name or in that of
  /// one of their controls, open; and those names are marked.
  void search(std::string words) {
    searched_ = std::move(words);
    found_any_ = false;
  }
  /// Whether the search has shown a section.
  [[nodiscard]] bool found_any() const { return found_any_; }

  /// Remembers the item just drawn, and shows its tooltip once the pointer has rested on it.
  void placed(const std::string& name, const char* tooltip, Use use = Use::shows);
  /// The same of words that are shown.
  void placed_words(const std::string& name, const std::string& words, const char* tooltip);

  /// Remembers the ImGui window that is being drawn.
  void placed_window(const std::string& name);

  [[nodiscard]] const std::map<std::string, Placed>& all() const { return placed_; }
  /// Whether this frame has a tooltip that the one before had not, or the other way round: it has
  /// to be drawn again, because a tooltip finds its size in its first frame.
  [[nodiscard]] bool tooltip_changed() const { return tooltip_now_ != tooltip_before_; }
  /// When a tooltip is due, in seconds from the frame's time.
  [[nodiscard]] std::optional<double> seconds_to_tooltip() const;

  /// While it lives, widgets have no labels and take the whole width.
  class Unlabelled {
   public:
    explicit Unlabelled(Controls& controls) : controls_(controls) { controls_.labelled_ = false; }
    ~Unlabelled() { controls_.labelled_ = true; }
    Unlabelled(const Unlabelled&) = delete;
    Unlabelled& operator=(const Unlabelled&) = delete;

   private:
    Controls& controls_;
  };

  /// Where on a logarithmic slider from 0 to `most` a value lies, 0 to 1.
  [[nodiscard]] static float log_share(double value, double most);

  /// Where widgets begin, beside their names.
  static constexpr float label_width_em = 6.4f;

 private:
  void help_button(const char* section);
  void label(const char* name, const char* tooltip);
  void name_text(const char* name);
  void explain(const std::string& name, const char* tooltip);
  void note_double_click(const char* name);
  template <typename T>
  bool reset(const char* name, T& value, const std::optional<T>& to);
  bool drag(const std::string& id, double& value, const Drag& drag);
  void option_row(const char* name, std::span<const Option> options, int first, int& chosen);

  std::map<std::string, Placed> placed_;
  std::string resetting_;  // double-clicked; stays reset until the button is let go
  double now_seconds_ = 0.0;
  void note_in_section(const std::string& name);
  [[nodiscard]] bool found(const std::string& name) const;

  bool labelled_ = true;
  std::map<std::string, bool> folds_;
  std::string searched_;
  bool found_any_ = false;
  std::set<std::string> opened_;                              // sections that were open once
  std::string section_;                                       // that is being drawn
  std::map<std::string, std::set<std::string>> in_sections_;  // names of controls
  std::string hovered_, hovered_before_;
  double hovered_since_seconds_ = 0.0;
  bool tooltip_now_ = false, tooltip_before_ = false;
};

}  // namespace asos::ui
