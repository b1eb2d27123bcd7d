#pragma once

#include "ui/panels/controls.h"

#include <string>
#include <vector>

namespace asos::ui {

/// A modal dialog in the window's middle, drawn during its lifetime. Enter confirms it, Escape
/// cancels it.
class Dialog {
 public:
  /// `wanted`: open it if it is closed. `across_em`: its width. `middle`: height of its middle, as
  /// a fraction of the window's.
  Dialog(const char* title, bool wanted, float across_em, float middle = 0.4f);
  ~Dialog();
  Dialog(const Dialog&) = delete;
  Dialog& operator=(const Dialog&) = delete;

  [[nodiscard]] bool open() const { return open_; }
  /// Draws the confirming button. Returns whether it or Enter was pressed.
  [[nodiscard]] bool confirmed(Controls& controls, const char* name, const char* tooltip) const;
  /// Draws *Cancel* at the end of the line. Returns whether it or Escape was pressed.
  [[nodiscard]] bool cancelled(Controls& controls, const char* tooltip) const;
  void close() const;
  /// Lists changes that would be lost.
  void losses(const std::vector<std::string>& lines) const;
  /// Warns of `fault`, or else if there is a file of this path. Always takes a line, so that
  /// nothing moves.
  void path_words(const std::string& path, const char* fault = nullptr) const;
  /// Draws the buttons of a dialog that saves, and notes in `choice` whether to save. Saves only
  /// what is `valid`.
  template <typename Choice>
  void end_saving(Controls& controls, const char* name, const char* tooltip, bool valid,
                  Choice& choice) const {
    choice.asked = confirmed(controls, name, tooltip) && valid;
    const bool cancel = cancelled(controls, "Close without saving (Esc).");
    if (!choice.asked && !cancel) return;
    choice.show = false;
    close();
  }

 private:
  bool open_ = false;
  bool appearing_ = false;  // Enter may have opened it
};

}  // namespace asos::ui
