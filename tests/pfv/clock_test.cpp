#include "pfv/clock.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

namespace pfv {
namespace {

void burn_cpu(double seconds) {
  for (const double start = process_cpu_seconds(); process_cpu_seconds() - start < seconds;)
    ;
}

TEST(Clock, KeepsStagesInOrderOfFirstAppearance) {
  Clock clock;
  clock.add("solve", 2);
  clock.add("assemble", 1);
  clock.add("solve", 0.5);
  EXPECT_EQ(clock.stages(), (std::vector<Stage>{{"solve", 2.5}, {"assemble", 1}}));
}

TEST(Clock, AStageThatRunsTwiceAccumulates) {
  Clock clock;
  for (int run = 0; run < 2; ++run) {
    const auto timing = clock.stage("work");
    burn_cpu(0.01);
  }
  ASSERT_EQ(clock.stages().size(), 1U);
  EXPECT_GE(clock.stages()[0].cpu_seconds, 0.02);
  EXPECT_LT(clock.stages()[0].cpu_seconds, 0.2);
}

TEST(Clock, AStageWithinAStageIsCountedOnce) {
  Clock clock;
  const double start = process_cpu_seconds();
  {
    const auto outer = clock.stage("outer");
    burn_cpu(0.01);
    for (int i = 0; i < 10; ++i) {
      const auto inner = clock.stage("inner " + std::to_string(i)); // more stages move the list in memory
      burn_cpu(0.001);
    }
  }
  ASSERT_EQ(clock.stages().size(), 11U);
  const double all = process_cpu_seconds() - start;
  EXPECT_EQ(clock.stages()[0].name, "outer");
  EXPECT_GE(clock.stages()[0].cpu_seconds, 0.01);
  double sum = 0;
  for (const Stage& stage : clock.stages())
    sum += stage.cpu_seconds;
  EXPECT_LE(sum, all);
  EXPECT_GE(sum, 0.02);
}

TEST(Clock, SleepingCostsNoCpu) {
  Clock clock;
  {
    const auto timing = clock.stage("sleep");
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  EXPECT_LT(clock.stages()[0].cpu_seconds, 0.02);
}

TEST(Clock, CpuOfAllThreadsCounts) {
  Clock clock;
  {
    const auto timing = clock.stage("threads");
    std::thread([] { burn_cpu(0.02); }).join();
  }
  EXPECT_GE(clock.stages()[0].cpu_seconds, 0.02);
}

TEST(PeakMemory, GrowsWithWhatIsTouchedAndNeverShrinks) {
  const std::size_t before = peak_memory_bytes();
  { const std::vector<char> large(before + (64U << 20), 'x'); }
  EXPECT_GE(peak_memory_bytes(), before + (64U << 20));
}

} // namespace
} // namespace pfv
