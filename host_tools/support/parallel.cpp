#include "support/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <vector>
#ifndef __EMSCRIPTEN__
#include <thread>
#endif

namespace fogcomp {
namespace {

#ifdef __EMSCRIPTEN__
// A page that is opened from a file has no memory that threads could share.
std::size_t cores() {
  return 1;
}
void run_beside(std::size_t, const std::function<void()>& work) {
  work();
}
#else
std::size_t cores() {
  return std::max(1U, std::thread::hardware_concurrency());
}

// Runs `work` here and in so many threads more.
void run_beside(std::size_t more, const std::function<void()>& work) {
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < more; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
}
#endif

std::atomic<std::size_t> max_threads{0};  // 0: as many as there are cores
thread_local bool is_inside = false;

}  // namespace

void for_each_index(std::size_t count, const std::function<void(std::size_t)>& body) {
  std::size_t threads = max_threads;
  if (threads == 0) threads = cores();
  threads = std::min(threads, count);
  if (is_inside || threads < 2) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> failures(count);
  run_beside(threads - 1, [&] {
    is_inside = true;
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        body(i);
      } catch (...) {
        failures[i] = std::current_exception();
        next = count;  // smaller indices have all begun
      }
    }
    is_inside = false;
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

void set_max_threads(std::size_t threads) {
  max_threads = std::max<std::size_t>(1, threads);
}

}  // namespace fogcomp
