#include "support/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace fogcomp {
namespace {

using Seconds = std::chrono::duration<double>;
constexpr double kQuietSeconds = 2;
constexpr double kRedrawSeconds = 0.1;
constexpr int kBarWidth = 30;

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

}  // namespace fogcomp
