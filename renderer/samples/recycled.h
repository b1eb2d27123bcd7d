#pragma once

#include <memory>

namespace asos {

/// Keeps one object per thread for reuse, since every block of pixels would allocate large arrays
/// anew. The object's previous contents are undefined.
template <typename T>
class Recycler {
 public:
  void operator()(T* object) const { spare().reset(object); }

  [[nodiscard]] static std::unique_ptr<T, Recycler> make() {
    if (std::unique_ptr<T>& kept = spare()) return {kept.release(), Recycler()};
    return {std::make_unique<T>().release(), Recycler()};
  }

 private:
  static std::unique_ptr<T>& spare() {
    thread_local std::unique_ptr<T> kept;
    return kept;
  }
};

template <typename T>
using Recycled = std::unique_ptr<T, Recycler<T>>;

}  // namespace asos
