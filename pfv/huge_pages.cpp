#include "pfv/huge_pages.hpp"

#if defined(__linux__) && defined(__GLIBC__)
#include <cstdint>
#include <cstdlib>
#include <malloc.h>
#include <sys/mman.h>

namespace pfv {

void prefer_huge_pages(std::size_t bytes) {
  constexpr std::size_t page = std::size_t(2) << 20;
  if (bytes < 4 * page)
    return;
  // All in the one heap, which keeps what it has: only so do later arrays reuse the pages of earlier ones.
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1); // never
  void* memory = std::malloc(bytes);
  if (!memory)
    return;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const auto first = (begin + page - 1) / page * page, last = (begin + bytes) / page * page;
  madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
  std::free(memory); // untouched: nothing but addresses was taken
}

} // namespace pfv
#else
namespace pfv {
void prefer_huge_pages(std::size_t) {}
} // namespace pfv
#endif
