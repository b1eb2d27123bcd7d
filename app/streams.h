#pragma once

#include <iosfwd>

namespace asos {

/// The output streams of a command: results go to `out`, errors and progress to `err`.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  bool err_is_terminal = false;  ///< then progress may be redrawn in place
};

}  // namespace asos
