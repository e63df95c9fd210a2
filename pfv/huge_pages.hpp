#pragma once

#include <cstddef>

namespace pfv {

/// Lets the next `bytes` of heap come in pages of 2 MB, and all of it stay with the process once touched. For what is
/// reached all over the place, as the cells of a triangulation are; arrays that are gone along gain nothing, and a
/// virtual machine may hand out small pages in half the time. A wish, granted on Linux with glibc; nothing happens
/// elsewhere.
void prefer_huge_pages(std::size_t bytes);

} // namespace pfv
