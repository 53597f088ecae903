#include "support/progress.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "support/output_file.hpp"

namespace {

namespace fs = std::filesystem;

class Interrupt : public ::testing::Test {
 protected:
  Interrupt() { fs::create_directory(folder_); }
  ~Interrupt() override { fs::remove_all(folder_); }

  // Runs `body` in a separate process, which is to die of SIGINT, with an output file open.
  template <class Body>
  void expect_no_half_file(Body body) {
    const pid_t child = ::fork();
    if (child == 0) {
      fogcomp::OutputFile file((folder_ / "out").string());
      body();
      ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), SIGINT);
    EXPECT_TRUE(fs::is_empty(folder_));
  }

  fs::path folder_ =
      fs::temp_directory_path() / ("fogcomp_interrupt_" + std::to_string(::getpid()));
};

TEST_F(Interrupt, LeavesNoHalfFile) {
  expect_no_half_file([] { std::raise(SIGINT); });
}

// Found so: after a training, nobody removed the report that was being written.
TEST_F(Interrupt, LeavesNoHalfFileAfterAGuard) {
  expect_no_half_file([] {
    { const fogcomp::InterruptGuard guard; }
    std::raise(SIGINT);
  });
}

TEST_F(Interrupt, ASecondOneLeavesNoHalfFile) {
  expect_no_half_file([] {
    const fogcomp::InterruptGuard guard;
    std::raise(SIGINT);
    if (!guard.interrupted()) ::_exit(1);
    std::raise(SIGINT);
  });
}

TEST_F(Interrupt, StaysIgnoredWhereItWas) {
  const auto before = std::signal(SIGINT, SIG_IGN);
  {
    const fogcomp::InterruptGuard guard;
    std::raise(SIGINT);
    EXPECT_FALSE(guard.interrupted());
  }
  EXPECT_EQ(std::signal(SIGINT, before), SIG_IGN);
}

}  // namespace
