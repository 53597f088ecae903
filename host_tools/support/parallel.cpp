#include "support/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <vector>
#ifndef __EMSCRIPTEN__
#include <condition_variable>
#include <thread>
#endif

namespace fogcomp {
namespace {

using Body = std::function<void(std::size_t)>;

std::atomic<std::size_t> max_threads{0};  // 0: as many as there are cores

#ifdef __EMSCRIPTEN__
// A page that is opened from a file has no memory that threads could share.
void run(std::size_t count, const Body& body) {
  for (std::size_t i = 0; i < count; ++i) body(i);
}
#else
// The threads of a call from outside all bodies: they share its loop and the loops within its
// bodies, so that none is idle while another still has a loop to do.
class Crew {
 public:
  // The calling thread is one of the `threads`.
  explicit Crew(std::size_t threads) {
    for (std::size_t i = 1; i < threads; ++i) helpers_.emplace_back([this] { help(); });
  }
  ~Crew() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      done_ = true;
    }
    changed_.notify_all();
    for (std::thread& helper : helpers_) helper.join();
  }
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  void run(std::size_t count, const Body& body);

  static thread_local Crew* of_this_thread;

 private:
  struct Loop {
    const Body& body;
    std::size_t count;
    std::size_t next;        // smallest index that has not begun
    std::size_t unfinished;  // indices
    std::vector<std::exception_ptr> failures;
  };
  using Lock = std::unique_lock<std::mutex>;

  void help();
  bool do_one(Lock& lock, const Loop* after);
  void do_index(Lock& lock, Loop& loop);

  std::mutex mutex_;  // guards all below but the threads
  std::condition_variable changed_;
  std::vector<Loop*> loops_;  // the latest last
  bool done_ = false;
  std::vector<std::thread> helpers_;
};

thread_local Crew* Crew::of_this_thread = nullptr;

void Crew::run(std::size_t count, const Body& body) {
  Loop loop{body, count, 0, count, std::vector<std::exception_ptr>(count)};
  Lock lock(mutex_);
  loops_.push_back(&loop);
  changed_.notify_all();
  while (loop.next < loop.count) do_index(lock, loop);
  // Only with loops that others have begun since: an earlier one would keep this call waiting.
  while (loop.unfinished > 0) {
    if (!do_one(lock, &loop)) changed_.wait(lock);
  }
  loops_.erase(std::find(loops_.begin(), loops_.end(), &loop));
  lock.unlock();
  for (const std::exception_ptr& failure : loop.failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

void Crew::help() {
  of_this_thread = this;
  Lock lock(mutex_);
  while (!done_) {
    if (!do_one(lock, nullptr)) changed_.wait(lock);
  }
}

// Does an index of the latest loop that has one left, of those begun after `after`. False if there
// is none.
bool Crew::do_one(Lock& lock, const Loop* after) {
  for (auto loop = loops_.rbegin(); loop != loops_.rend() && *loop != after; ++loop) {
    if ((*loop)->next == (*loop)->count) continue;
    do_index(lock, **loop);
    return true;
  }
  return false;
}

// After a failure no further index begins; all smaller ones have begun.
void Crew::do_index(Lock& lock, Loop& loop) {
  const std::size_t index = loop.next++;
  lock.unlock();
  std::exception_ptr failure;
  try {
    loop.body(index);
  } catch (...) {
    failure = std::current_exception();
  }
  lock.lock();
  if (failure) {
    loop.failures[index] = failure;
    loop.unfinished -= loop.count - loop.next;
    loop.next = loop.count;
  }
  if (--loop.unfinished == 0) changed_.notify_all();
}

void run(std::size_t count, const Body& body) {
  if (Crew::of_this_thread != nullptr) return Crew::of_this_thread->run(count, body);
  std::size_t threads = max_threads;
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  if (threads == 1) {
    for (std::size_t i = 0; i < count; ++i) body(i);
    return;
  }
  Crew crew(threads);
  Crew::of_this_thread = &crew;
  const struct Leave {
    ~Leave() { Crew::of_this_thread = nullptr; }
  } leave;
  crew.run(count, body);
}
#endif

}  // namespace

void for_each_index(std::size_t count, const Body& body) {
  if (count > 1) return run(count, body);
  if (count == 1) body(0);  // its own loops may have more
}

void for_each_index(std::size_t count, const Body& body,
                    const std::function<void(double)>& progress) {
  if (!progress) return for_each_index(count, body);
  std::mutex telling;  // guards done
  std::size_t done = 0;
  for_each_index(count, [&](std::size_t i) {
    body(i);
    const std::lock_guard<std::mutex> lock(telling);
    progress(static_cast<double>(++done) / static_cast<double>(count));
  });
}

void set_max_threads(std::size_t threads) {
  max_threads = std::max<std::size_t>(1, threads);
}

}  // namespace fogcomp
