// running_flips MACHINE ELF SEED LIMIT AREA...: flips bits in the memory of a board while it
// answers good sensor samples, one bit per run, and prints after how many samples the board showed
// it: by an invalid rate, a frame that no driver accepts, or a restart. Areas as in flip_plan.hpp.
// Exit code 1 if any flip stayed undetected for LIMIT samples.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "emulated_board.hpp"
#include "flip_plan.hpp"
#include "healthy_stream.hpp"
#include "output_reader.hpp"

namespace {

using namespace std::chrono_literals;
using fogcomp::injection::EmulatedBoard;
using fogcomp::injection::Flip;
using fogcomp::injection::HealthyStream;
using fogcomp::injection::OutputReader;
using fogcomp::injection::QemuEnded;

constexpr auto kPatience = 12s;     // without a byte: the board promises 10 s
constexpr std::size_t kAhead = 32;  // samples on their way
constexpr double kSamplesPerS = 200;

const std::string kInvalid = "rate not valid, or no frame";
const std::string kRestart = "restart";
const std::string kLockUp = "processor locked up (QEMU gives up; the watchdog restarts a board)";
const std::string kHang = "NO ANSWER, NO RESTART";
const std::string kUnseen = "NOT SEEN";

struct Outcome {
  const std::string& what;
  std::size_t samples;  ///< answered with a valid rate after the flip
};

/// A board that is kept busy.
class Session {
 public:
  explicit Session(EmulatedBoard& board) : board_(board) {
    board_.resume();
    while (board_.boots() == 0) {
      if (!board_.exchange(kPatience)) throw std::runtime_error("the board does not start");
    }
  }

  /// Samples answered with a valid rate so far.
  std::size_t valid() const { return reader_.valid(); }

  /// Feeds and reads until `valid` samples were answered well or anything else happened.
  const std::string& feed_until(std::size_t valid) {
    for (;;) {
      if (sent_ < reader_.accepted() + kAhead && board_.unsent() == 0) {
        board_.send_to_sensor_port(stream_.next(kAhead / 2));
        sent_ += kAhead / 2;
      }
      const bool came = board_.exchange(kPatience);
      reader_.read(board_.output);
      if (board_.times_said("restarting") > 0 || board_.boots() > 1) return kRestart;
      if (reader_.saw_fault()) return kInvalid;
      if (!came) return kHang;
      if (reader_.valid() >= valid) return kUnseen;
    }
  }

 private:
  EmulatedBoard& board_;
  HealthyStream stream_;
  OutputReader reader_;
  std::size_t sent_ = 0;
};

Outcome run_with(EmulatedBoard& board, const Flip& flip, std::size_t healthy, std::size_t limit) {
  Session session(board);
  const std::string& first = session.feed_until(healthy);
  if (first != kUnseen) throw std::runtime_error("the board is not healthy: " + first);
  board.stop();
  board.flip(flip);
  const std::size_t before = session.valid();
  board.resume();
  try {
    const std::string& what = session.feed_until(before + limit);
    return {what, session.valid() - before};
  } catch (const QemuEnded&) {
    return {kLockUp, session.valid() - before};
  }
}

int run(const std::vector<std::string>& words) {
  if (words.size() < 5) {
    std::fputs("usage: running_flips MACHINE ELF SEED LIMIT AREA...\n", stderr);
    return 2;
  }
  std::mt19937 random(static_cast<std::mt19937::result_type>(std::stoul(words[2])));
  const std::size_t limit = std::stoul(words[3]);
  const auto flips = fogcomp::injection::plan_flips({words.begin() + 4, words.end()}, random);
  std::map<std::string, std::map<std::string, int>> outcomes;
  std::size_t worst = 0;
  int unseen = 0;
  for (const Flip& flip : flips) {
    // So that the scan is at any position, after the start.
    const std::size_t healthy = OutputReader::kStarting + random() % 600U;
    EmulatedBoard board(words[0], words[1]);
    const Outcome outcome = run_with(board, flip, healthy, limit);
    ++outcomes[flip.area][outcome.what];
    if (outcome.what == kUnseen || outcome.what == kHang) {
      ++unseen;
      std::printf("not seen: bit %u of %08x (%s)\n", flip.bit, flip.address, flip.area.c_str());
    } else {
      worst = std::max(worst, outcome.samples);
    }
  }
  for (const auto& [area, of_area] : outcomes) {
    for (const auto& [what, times] : of_area) {
      std::printf("%-18s %6d %s\n", area.c_str(), times, what.c_str());
    }
  }
  std::printf(
      "%zu bits flipped while running, %d not seen within %.1f s; the latest after %.1f s\n",
      flips.size(), unseen, static_cast<double>(limit) / kSamplesPerS,
      static_cast<double>(worst) / kSamplesPerS);
  return unseen == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "running_flips: %s\n", error.what());
    return 2;
  }
}
