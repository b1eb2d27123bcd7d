#pragma once

#include <vector>

namespace asos {

/// Empties a vector and frees its memory, which assigning {} keeps.
template <typename T>
void release(std::vector<T>& v) {
  std::vector<T>().swap(v);
}

}  // namespace asos
