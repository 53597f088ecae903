#include "support/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

namespace {

// What work of more than two seconds writes to `to`, read at `from`, its other end; both are
// closed.
std::string said_by_long_work(int to, int from) {
  const int saved = ::dup(STDERR_FILENO);
  ::dup2(to, STDERR_FILENO);
  ::close(to);
  {
    fogcomp::Progress progress("working");
    progress.update(0.1);  // nobody is told of short work
    std::this_thread::sleep_for(std::chrono::milliseconds(2050));
    progress.update(0.5);
  }
  ::dup2(saved, STDERR_FILENO);
  ::close(saved);
  std::string said;
  for (char byte; ::read(from, &byte, 1) == 1;)
    said += byte;  // to the end of a pipe, EIO of a screen
  ::close(from);
  return said;
}

TEST(Progress, IsABarOfLongWorkOnATerminalWhichIsWipedAtTheEnd) {
  const int screen = ::posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_TRUE(screen >= 0 && ::grantpt(screen) == 0 && ::unlockpt(screen) == 0);
  const int terminal = ::open(::ptsname(screen), O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  const std::string said = said_by_long_work(terminal, screen);
  EXPECT_EQ(said.find("\rworking [###############               ]  50 %, "), 0U) << said;
  EXPECT_NE(said.find(" s left\033[K"), std::string::npos) << said;
  EXPECT_EQ(said.rfind("\r\033[K"), said.size() - 4) << said;
}

TEST(Progress, SaysNothingWhereThereIsNoTerminal) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  EXPECT_EQ(said_by_long_work(ends[1], ends[0]), "");
}

}  // namespace
