#pragma once

#include "renderer/result.h"
#include "renderer/study/analysis.h"

#include <optional>
#include <string>

// Pieces of HTML and numbers as a report writes them.

namespace asos {

/// Text with what HTML reserves replaced.
[[nodiscard]] std::string escaped(const std::string& text);

/// "0.0123 s" to three figures, "12.3 s", "4 min 10 s".
[[nodiscard]] std::string seconds_text(double seconds);
/// "1.23e-3": three figures.
[[nodiscard]] std::string error_text(double error);
/// The RMSE of a point, or that it is under the floor.
[[nodiscard]] std::string shown_error(const StudyPoint& point);
/// "3.1", "0.45", "120": a factor to two or three figures.
[[nodiscard]] std::string factor_text(double factor);
/// "1 234 567", with narrow spaces that do not break.
[[nodiscard]] std::string count_text(std::uint64_t count);
/// "asos, sobol and uniform".
[[nodiscard]] std::string list_text(const std::vector<std::string>& words);

/// Whom a factor favours, in a word; differences below 5 % are even.
enum class Outcome { win, even, loss };
[[nodiscard]] Outcome outcome_of(double factor);

/// Turns files into data URIs. The first failure is kept, and what follows is of no use.
class Embedder {
 public:
  /// The data URI of a .png or .svg file.
  [[nodiscard]] std::string uri(const std::string& path);
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  std::optional<Error> error_;
};

}  // namespace asos
