#include "base/freed_memory.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace boomwatch {

void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int mebibyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * mebibyte);  // the most that glibc takes
  mallopt(M_TRIM_THRESHOLD, 512 * mebibyte);
#endif
}

}  // namespace boomwatch
