#include "batch/process_pool.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <vector>

#include "support/input_error.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"

namespace fogcomp::batch {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::timespec kTick{0, 200'000'000};

struct Running {
  pid_t process;
  std::size_t job;
  Clock::time_point start;
  bool overdue = false;
};

// Signals are waited for, not handled, so that they interrupt only at defined points.
class WatchedSignals {
 public:
  WatchedSignals() {
    sigemptyset(&watched_);
    sigaddset(&watched_, SIGCHLD);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
      struct sigaction action {};
      sigaction(number, nullptr, &action);
      if (action.sa_handler != SIG_IGN) sigaddset(&watched_, number);  // respects nohup
    }
    sigprocmask(SIG_BLOCK, &watched_, &before_);
  }
  ~WatchedSignals() { restore(); }
  WatchedSignals(const WatchedSignals&) = delete;
  WatchedSignals& operator=(const WatchedSignals&) = delete;

  void restore() const { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  // The signal that requests the end, or 0 after a tick or the end of a child.
  int wait() const {
    const int number = sigtimedwait(&watched_, nullptr, &kTick);
    return number > 0 && number != SIGCHLD ? number : 0;
  }

 private:
  sigset_t watched_;
  sigset_t before_;
};

// The child must not continue as a second parent.
[[noreturn]] void run_and_exit(const std::function<void(std::size_t)>& work, std::size_t job) {
  int code = 0;
  try {
    work(job);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    code = 1;
  }
  std::fflush(nullptr);
  ::_exit(code);
}

std::string death_of(const Running& running, int status, double time_limit_s) {
  if (running.overdue) return format("took longer than %g s and was ended", time_limit_s);
  if (WIFSIGNALED(status)) {
    return format("its process died of signal %d (%s)", WTERMSIG(status),
                  strsignal(WTERMSIG(status)));
  }
  return WEXITSTATUS(status) == 0 ? ""
                                  : format("its process exited with code %d", WEXITSTATUS(status));
}

// The running processes.
class Children {
 public:
  explicit Children(const PoolSettings& settings)
      : time_limit_s_(settings.time_limit_s), has_others_(settings.processes > 1) {}

  std::size_t count() const { return running_.size(); }

  void start(std::size_t job, const std::function<void(std::size_t)>& work,
             const WatchedSignals& signals) {
    std::fflush(nullptr);  // otherwise the child would print it again
    const pid_t process = ::fork();
    if (process < 0) {
      throw InputError("fogcomp batch", std::string("no process can be started (") +
                                            std::strerror(errno) + "); use fewer --jobs");
    }
    if (process == 0) {
      signals.restore();
      if (has_others_) set_max_threads(1);  // the other cores are theirs
      run_and_exit(work, job);
    }
    running_.push_back({process, job, Clock::now()});
  }

  // Reports processes that have ended, and kills those above the time limit.
  void supervise(const PoolEvents& events) {
    for (std::size_t i = 0; i < running_.size();) {
      int status = 0;
      if (::waitpid(running_[i].process, &status, WNOHANG) == 0) {
        end_if_overdue(running_[i]);
        ++i;
        continue;
      }
      const Running ended = running_[i];
      running_.erase(running_.begin() + static_cast<std::ptrdiff_t>(i));
      events.ended(ended.job, death_of(ended, status, time_limit_s_));
    }
  }

  void end_all() const {
    for (const Running& one : running_) ::kill(one.process, SIGTERM);
    for (const Running& one : running_) ::waitpid(one.process, nullptr, 0);
  }

 private:
  void end_if_overdue(Running& one) const {
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - one.start).count();
    if (time_limit_s_ <= 0 || elapsed_s <= time_limit_s_ || one.overdue) return;
    one.overdue = true;
    ::kill(one.process, SIGTERM);
  }

  double time_limit_s_;
  bool has_others_;
  std::vector<Running> running_;
};

}  // namespace

int run_in_processes(std::size_t jobs, const PoolSettings& settings,
                     const std::function<void(std::size_t)>& work, const PoolEvents& events) {
  const WatchedSignals signals;
  Children children(settings);
  std::size_t next = 0;
  while (next < jobs || children.count() > 0) {
    while (next < jobs && children.count() < settings.processes) {
      children.start(next++, work, signals);
    }
    const int asked_to_end = signals.wait();
    if (asked_to_end != 0) {
      children.end_all();
      return asked_to_end;
    }
    children.supervise(events);
    events.tick();
  }
  return 0;
}

}  // namespace fogcomp::batch
