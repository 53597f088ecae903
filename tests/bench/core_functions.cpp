// core_functions [NAME]: every function of the core with one argument of 32 bits at all 2^32
// arguments, against long double; and those of two or more at their edges and on 10^9 draws. Prints
// each worst error, where it is and the time on all processors. Exits 1 where one is above the
// documented error.
#include "sweep/core_functions.hpp"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <thread>
#include <vector>

#include "sweep/core_products.hpp"

namespace {

using fog::test::Worst;

// Calls part(0) ... part(parts - 1) on all processors.
template <class Part>
void in_parallel(std::int64_t parts, Part part) {
  std::atomic<std::int64_t> next{0};
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) {
    threads.emplace_back([&] {
      for (std::int64_t at = next++; at < parts; at = next++) part(at);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

Worst sweep_all(const fog::test::CoreFunction& function) {
  constexpr std::int64_t kChunk = std::int64_t{1} << 24;
  std::mutex lock;
  Worst worst;
  in_parallel((function.last - function.first) / kChunk + 1, [&](std::int64_t chunk) {
    const std::int64_t first = function.first + chunk * kChunk;
    // One more than the chunk: the step to the next chunk may fall, too.
    const Worst found = function.sweep(first, std::min(function.last, first + kChunk), 1);
    const std::lock_guard<std::mutex> guard(lock);
    worst.join(found);
  });
  return worst;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool sweep_function(const fog::test::CoreFunction& function) {
  const auto start = std::chrono::steady_clock::now();
  const Worst worst = sweep_all(function);
  const bool good = worst.error <= function.max_error && worst.largest_fall <= function.max_fall;
  std::printf("%-22s %12.4Lg %-24s at %11lld, largest fall %9.3Lg, %6.1f s%s\n", function.name,
              worst.error, function.unit, static_cast<long long>(worst.at), worst.largest_fall,
              seconds_since(start), good ? "" : "  ABOVE ITS DOCUMENTED ERROR");
  std::fflush(stdout);
  return good;
}

bool draw_function(const fog::test::CoreProduct& function) {
  constexpr std::int64_t kDraws = 1'000'000'000;
  constexpr std::int64_t kParts = 1000;
  const auto start = std::chrono::steady_clock::now();
  std::atomic<std::int64_t> wrong{0};
  in_parallel(kParts, [&](std::int64_t part) {
    wrong += function.wrong_draws(static_cast<std::uint64_t>(part) + 1, kDraws / kParts);
  });
  wrong += function.wrong_edges();
  std::printf("%-22s %12lld wrong, %6.1f s%s\n", function.name,
              static_cast<long long>(wrong.load()), seconds_since(start),
              wrong == 0 ? "" : "  WRONG");
  std::fflush(stdout);
  return wrong == 0;
}

}  // namespace

int main(int argc, char** argv) {
  const char* const wanted = argc > 1 ? argv[1] : "";
  bool good = true;
  bool any = false;
  for (const auto& function : fog::test::core_functions()) {
    if (std::strstr(function.name, wanted) == nullptr) continue;
    any = true;
    good = sweep_function(function) && good;
  }
  for (const auto& function : fog::test::core_products()) {
    if (std::strstr(function.name, wanted) == nullptr) continue;
    any = true;
    good = draw_function(function) && good;
  }
  if (!any) {
    std::fprintf(stderr, "core_functions: no function's name contains '%s'\n", wanted);
    return 2;
  }
  return good ? 0 : 1;
}
