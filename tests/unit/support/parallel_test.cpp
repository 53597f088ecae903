#include "support/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace fogcomp {
namespace {

TEST(Parallel, EachIndexOnce) {
  for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
    std::vector<int> calls(count, 0);
    for_each_index(count, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(count, 1)) << count;
  }
}

TEST(Parallel, TellsTheFractionDoneOneCallAtATime) {
  std::vector<double> told;
  for_each_index(
      4, [](std::size_t) {}, [&](double done) { told.push_back(done); });
  EXPECT_EQ(told, (std::vector<double>{0.25, 0.5, 0.75, 1}));
  for_each_index(
      0, [](std::size_t) {}, [](double) { ADD_FAILURE() << "nothing was done"; });
  EXPECT_THROW(for_each_index(
                   4, [](std::size_t) {}, [](double) { throw std::runtime_error("enough"); }),
               std::runtime_error);
}

TEST(Parallel, ACallWithinABodyIsServedToo) {
  std::atomic<int> sum{0};
  for_each_index(5, [&](std::size_t i) {
    for_each_index(4, [&](std::size_t j) { sum += static_cast<int>(10 * i + j); });
  });
  EXPECT_EQ(sum, 10 * 10 * 4 + 6 * 5);
}

// A thread that has nothing left of the outer loop takes part in an inner one: two indices of that
// meet, which one thread alone would wait for in vain.
TEST(Parallel, AnIdleThreadHelpsALoopWithinABody) {
  set_max_threads(2);
  std::mutex mutex;
  std::condition_variable changed;
  int here = 0;
  bool met = true;
  for_each_index(2, [&](std::size_t i) {
    if (i == 0) return;
    for_each_index(2, [&](std::size_t) {
      std::unique_lock<std::mutex> lock(mutex);
      ++here;
      changed.notify_all();
      met &= changed.wait_for(lock, std::chrono::seconds(20), [&] { return here == 2; });
    });
  });
  EXPECT_TRUE(met);
}

// Which of several failures a caller sees does not depend on which thread was first.
TEST(Parallel, TheFailureOfTheSmallestIndexIsThrown) {
  for (int repeat = 0; repeat < 100; ++repeat) {
    std::string said;
    try {
      for_each_index(64, [](std::size_t i) {
        if (i % 3 == 2) throw std::runtime_error(std::to_string(i));
      });
    } catch (const std::runtime_error& error) {
      said = error.what();
    }
    ASSERT_EQ(said, "2");
  }
}

TEST(Parallel, AFailureDoesNotSpoilLaterCalls) {
  EXPECT_THROW(for_each_index(8, [](std::size_t) { throw std::runtime_error("no"); }),
               std::runtime_error);
  std::atomic<int> calls{0};
  for_each_index(8, [&](std::size_t) { ++calls; });
  EXPECT_EQ(calls, 8);
}

}  // namespace
}  // namespace fogcomp
