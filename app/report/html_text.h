#pragma once

#include "renderer/result.h"
#include "renderer/study/analysis.h"

#include <optional>
#include <string>

// Formats HTML and numbers for reports.

namespace asos {

/// Escapes the characters that HTML reserves.
[[nodiscard]] std::string escaped(const std::string& text);

/// "0.0123 s" to three figures, "12.3 s", "4 min 10 s".
[[nodiscard]] std::string seconds_text(double seconds);
/// "1.23e-3": three figures.
[[nodiscard]] std::string error_text(double error);
/// The RMSE of a point, or a note that it is below the noise floor.
[[nodiscard]] std::string shown_error(const StudyPoint& point);
/// "3.10", "0.45", "120": a factor to two or three figures.
[[nodiscard]] std::string factor_text(double factor);
/// "1 234 567", with narrow no-break spaces.
[[nodiscard]] std::string count_text(std::uint64_t count);
/// "asos, sobol and uniform".
[[nodiscard]] std::string list_text(const std::vector<std::string>& words);

/// Which side a factor favours; differences below 5 % are even.
enum class Outcome { win, even, loss };
[[nodiscard]] Outcome outcome_of(double factor);

/// The start of a page, up to its body.
[[nodiscard]] std::string page_head(const std::string& title, const char* style);

/// Converts files to data URIs. Keeps the first error; results after it are unusable.
class Embedder {
 public:
  /// The data URI of a .png or .svg file.
  [[nodiscard]] std::string uri(const std::string& path);
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  std::optional<Error> error_;
};

}  // namespace asos
