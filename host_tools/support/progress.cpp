#include "support/progress.hpp"

#include <unistd.h>
#include <algorithm>
#include <csignal>
#include <cstdio>

namespace fogcomp {
namespace {

using Seconds = std::chrono::duration<double>;
constexpr double kQuietSeconds = 2;
constexpr double kRedrawSeconds = 0.1;
constexpr int kBarWidth = 30;

volatile std::sig_atomic_t g_interrupted = 0;
// Handler restored for a second Ctrl-C: it removes unfinished files.
void (*g_before)(int) = SIG_DFL;

extern "C" void on_interrupt(int) {
  g_interrupted = 1;
  std::signal(SIGINT, g_before);
}

}  // namespace

Progress::Progress(std::string label)
    : label_(std::move(label)),
      on_terminal_(::isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::update(double fraction) {
  if (!on_terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  const double elapsed_s = Seconds(now - start_).count();
  if (elapsed_s < kQuietSeconds || Seconds(now - last_).count() < kRedrawSeconds) return;
  last_ = now;
  drawn_ = true;
  const double done = std::clamp(fraction, 1e-3, 1.0);
  const int filled = static_cast<int>(done * kBarWidth);
  std::fprintf(stderr, "\r%s [%.*s%*s] %3.0f %%, %.0f s left\033[K", label_.c_str(), filled,
               "##############################", kBarWidth - filled, "", 100 * done,
               elapsed_s * (1 - done) / done);
}

InterruptGuard::InterruptGuard() {
  g_interrupted = 0;
  g_before = std::signal(SIGINT, on_interrupt);
  if (g_before == SIG_IGN) std::signal(SIGINT, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, g_before);
}

bool InterruptGuard::interrupted() const {
  return g_interrupted != 0;
}

}  // namespace fogcomp
