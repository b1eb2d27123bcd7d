#pragma once

#include <memory>

namespace asos {

/// Keeps one object per thread for reuse, since every block of pixels would allocate large arrays
/// anew. The object's previous contents are undefined.
template <typename T>
class ThreadLocalCache {
 public:
  void operator()(T* object) const { spare().reset(object); }

  [[nodiscard]] static std::unique_ptr<T, ThreadLocalCache> make() {
    if (std::unique_ptr<T>& kept = spare()) return {kept.release(), ThreadLocalCache()};
    return {std::make_unique<T>().release(), ThreadLocalCache()};
  }

 private:
  static std::unique_ptr<T>& spare() {
    thread_local std::unique_ptr<T> kept;
    return kept;
  }
};

template <typename T>
using CachedPtr = std::unique_ptr<T, ThreadLocalCache<T>>;

}  // namespace asos
