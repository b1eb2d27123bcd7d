#pragma once

#include <iosfwd>

namespace asos {

/// Where a command writes: answers to `out`, errors and progress to `err`.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  bool err_is_terminal = false;  ///< then progress may be drawn and redrawn there
};

}  // namespace asos
