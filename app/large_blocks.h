#pragma once

#include <malloc.h>

namespace asos {

/// Makes malloc return blocks of a megabyte or more to the system when they are freed. By default
/// glibc keeps all blocks below 32 MB once one of that size was freed, which takes a fifth more
/// memory while a large scene is loaded. Call before threads are started.
inline void give_back_large_blocks() {
#ifdef M_MMAP_THRESHOLD
  constexpr int megabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, megabyte);
#endif
}

}  // namespace asos
