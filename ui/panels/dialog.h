#pragma once

#include "ui/panels/controls.h"

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

 private:
  bool open_ = false;
  bool appearing_ = false;  // Enter may have opened it
};

}  // namespace asos::ui
