#pragma once

#include <memory>

namespace asos {

/// Keeps one object a thread for the next who needs one: large arrays that every block of pixels
/// would ask the system for again. What they held is of no meaning.
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
