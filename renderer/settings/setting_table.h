#pragma once

#include "renderer/settings/settings.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asos {

enum class SettingKind { flag, whole, number, choice };

/// Whether saved pictures hold a setting. Older pictures do not have the newer ones.
enum class Saved { always, unless_usual, never };

/// A row of the table of all settings that have one value each. Command line, saved pictures,
/// library and `validated` read it.
struct SettingRow {
  const char* key = "";     ///< in saved pictures and in the library: "filter_width"
  const char* option = "";  ///< on the command line, without dashes, and in errors
  SettingKind kind = SettingKind::number;
  double lo = 0.0, hi = 1.0;       ///< the values' range, both ends included
  std::vector<const char*> names;  ///< of a choice's values, from 0 on
  Saved saved = Saved::always;
  const char* about = "";                ///< for the user
  double (*get)(const RenderSettings&);  ///< a flag's 0 or 1, or the index of a name
  void (*set)(RenderSettings&, double);  ///< a value of the range

  [[nodiscard]] double usual() const { return get(RenderSettings{}); }
  /// Returns the value as `parse` reads it: "0.5", "on", "exact".
  [[nodiscard]] std::string text_of(double value) const;
  /// Reads "on" or "off", a number of the range, or one of the names. The error's subject is the
  /// text.
  [[nodiscard]] Result<double> parse(std::string_view text) const;
};

/// The rows, in the order of a saved picture's settings.
[[nodiscard]] std::span<const SettingRow> setting_table();
/// Returns the row of this key; null: none.
[[nodiscard]] const SettingRow* find_setting(std::string_view key);
/// Returns the row of an option that the program itself names. Throws std::logic_error for others.
[[nodiscard]] const SettingRow& setting_of_option(std::string_view option);

}  // namespace asos
