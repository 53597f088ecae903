// boot_flips MACHINE ELF SEED SAMPLES AREA...: boots the image once for each bit flipped in it,
// feeds the board SAMPLES good sensor samples, and says what became of each boot. Areas as in
// flip_plan.hpp. Exit code 1 if any damaged image had a frame accepted that marks a rate valid, or
// if a signal stopped it, after which it tells of those it has done.
#include <csignal>
#include <cstdio>
#include <exception>
#include <map>
#include <random>
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

constexpr auto kQuiet = 400ms;  // after which nothing more is expected
constexpr auto kLongest = 6s;   // for a board that keeps talking
constexpr std::size_t kRestartsSeen = 3;

/// Result of one boot, in words.
const std::string kValid = "a RATE MARKED VALID";
const std::string kRefused = "answered, no rate valid";
const std::string kRestarts = "restarts";
const std::string kGarbled = "output that no driver accepts";
const std::string kSilent = "no output";
const std::string kLockUp = "processor locked up";

const std::string& feed(EmulatedBoard& board, std::size_t samples) {
  board.resume();
  HealthyStream stream;
  OutputReader reader;
  std::size_t boots_fed = 0;
  bool fed_blindly = false;
  const auto deadline = std::chrono::steady_clock::now() + kLongest;
  for (;;) {
    const bool came = board.exchange(kQuiet);
    reader.read(board.output);
    if (reader.valid() > 0) return kValid;
    if (reader.accepted() >= samples) return kRefused;
    if (std::chrono::steady_clock::now() > deadline) return kGarbled;
    const std::size_t restarts = board.times_said("restarting");
    if (restarts >= kRestartsSeen) return kRestarts;
    const std::size_t boots = board.boots();
    if (boots > kRestartsSeen) return kRestarts;
    if (boots > boots_fed) {
      boots_fed = boots;
      board.send_to_sensor_port(stream.next(static_cast<int>(samples)));
    }
    if (came) continue;
    if (boots_fed == 0 && !fed_blindly) {  // it may run without being able to report it
      fed_blindly = true;
      board.send_to_sensor_port(stream.next(static_cast<int>(samples)));
      continue;
    }
    if (restarts > 0) return kRestarts;
    return board.output.empty() ? kSilent : kGarbled;
  }
}

const std::string& boot_with(EmulatedBoard& board, const Flip& flip, std::size_t samples) {
  board.flip(flip);
  try {
    return feed(board, samples);
  } catch (const QemuEnded&) {
    return kLockUp;
  }
}

volatile std::sig_atomic_t stopped = 0;

int run(const std::vector<std::string>& words) {
  if (words.size() < 5) {
    std::fputs("usage: boot_flips MACHINE ELF SEED SAMPLES AREA...\n", stderr);
    return 2;
  }
  std::mt19937 random(static_cast<std::mt19937::result_type>(std::stoul(words[2])));
  const std::size_t samples = std::stoul(words[3]);
  const auto flips = fogcomp::injection::plan_flips({words.begin() + 4, words.end()}, random);
  if (EmulatedBoard whole(words[0], words[1]); feed(whole, samples) != kValid) {
    std::fputs("boot_flips: the image as it is gives no valid rate\n", stderr);
    return 1;
  }
  std::map<std::string, std::map<std::string, int>> outcomes;
  int accepted = 0;
  std::size_t done = 0;
  for (const Flip& flip : flips) {
    if (stopped != 0) break;
    ++done;
    EmulatedBoard board(words[0], words[1]);
    const std::string& outcome = boot_with(board, flip, samples);
    ++outcomes[flip.area][outcome];
    if (outcome != kValid) continue;
    ++accepted;
    std::printf("valid rate in spite of bit %u of %08x (%s)\n", flip.bit, flip.address,
                flip.area.c_str());
  }
  for (const auto& [area, of_area] : outcomes) {
    for (const auto& [outcome, times] : of_area) {
      std::printf("%-18s %6d %s\n", area.c_str(), times, outcome.c_str());
    }
  }
  std::printf("%zu of %zu bits flipped, %d images gave a rate marked valid\n", done, flips.size(),
              accepted);
  return accepted == 0 && done == flips.size() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  for (const int which : {SIGINT, SIGTERM}) std::signal(which, [](int) { stopped = 1; });
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "boot_flips: %s\n", error.what());
    return 2;
  }
}
