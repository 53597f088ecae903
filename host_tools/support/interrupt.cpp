#include "support/interrupt.hpp"

#include <csignal>

namespace fogcomp {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;
// Handler restored for a second Ctrl-C: it removes unfinished files.
void (*g_before)(int) = SIG_DFL;

extern "C" void on_interrupt(int) {
  g_interrupted = 1;
  std::signal(SIGINT, g_before);
}

}  // namespace

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
