#pragma once

#include "renderer/files/printable.h"

#include <tl/expected.hpp>

#include <string>

namespace asos {

/// The reason why a request of the user failed. `subject` is the file or option, and `reason`
/// describes the problem, both in words for the user.
struct Error {
  std::string subject;
  std::string reason;

  /// Returns both in one printable line: names from files and from the user are escaped.
  [[nodiscard]] std::string message() const {
    return printable(subject) + ": " + printable(reason);
  }
};

/// A value, or the error that prevented it.
template <typename T>
using Result = tl::expected<T, Error>;

using tl::unexpected;

}  // namespace asos
