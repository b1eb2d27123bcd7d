#pragma once

#include <malloc.h>

namespace asos {

/// Lets blocks of a megabyte or more go back to the system as soon as they are freed. Else glibc
/// keeps all below 32 MB for later once it has seen one of that size, which is a fifth more memory
/// while a large scene is loaded. Call before there are threads.
inline void give_back_large_blocks() {
#ifdef M_MMAP_THRESHOLD
  constexpr int megabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, megabyte);
#endif
}

}  // namespace asos
