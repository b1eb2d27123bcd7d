#pragma once

#include "renderer/files/printable.h"

#include <tl/expected.hpp>

#include <string>

namespace asos {

/// Why something that the user asked for could not be done. `subject` names the file (or option)
/// and `reason` says what is wrong with it, both in words for a person.
struct Error {
  std::string subject;
  std::string reason;

  /// Both in one line that may be shown: names that come from outside are escaped.
  [[nodiscard]] std::string message() const {
    return printable(subject) + ": " + printable(reason);
  }
};

/// A value, or the error in its place.
template <typename T>
using Result = tl::expected<T, Error>;

using tl::unexpected;

}  // namespace asos
