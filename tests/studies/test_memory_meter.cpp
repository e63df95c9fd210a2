#include "reference/memory_meter.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

constexpr std::size_t megabyte = 1'000'000;

TEST(MemoryMeter, SeesWhatWasHeldForAMomentAndNotWhatWasThereBefore) {
  const std::vector<char> before(200 * megabyte, 'x');
  const reference::MemoryMeter meter;
  const std::size_t nothing = meter.bytes();
  { const std::vector<char> held(100 * megabyte, 'x'); }
  // The allocator rounds and the kernel counts pages in batches: a tenth is close enough to tell a method's size.
  EXPECT_LT(nothing, 10 * megabyte);
  EXPECT_NEAR(static_cast<double>(meter.bytes()), 100e6, 10e6);
  EXPECT_EQ(before.back(), 'x');
}

} // namespace
