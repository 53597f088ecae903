// boot_flips MACHINE ELF SEED SAMPLES AREA...: boots the image once for each bit flipped in it,
// feeds the board SAMPLES good sensor samples, and says what became of each boot. Areas as in
// flip_plan.hpp. Exit code 1 if any damaged image had a frame accepted that marks a rate valid, or
// if a signal stopped it, after which it tells of those it has done.
#include <csignal>
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

constexpr auto kQuiet = 400ms;  // after which nothing more is expected
constexpr auto kLongest = 6s;   // for a board that keeps talking
constexpr std::size_t kRestartsSeen = 3;

std::size_t count(const std::string& text, const char* word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++found;
  }
  return found;
}

/// What became of one boot, in words.
const std::string kValid = "a RATE MARKED VALID";
const std::string kRefused = "answered, no rate valid";
const std::string kRestarts = "restarts";
const std::string kGarbled = "output that no driver accepts";
const std::string kSilent = "no output";
const std::string kLockUp = "processor locked up";

const std::string& boot(EmulatedBoard& board, std::size_t samples) {
  board.drain();
  board.reset();
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
    if (count(board.console, "restarting") >= kRestartsSeen) return kRestarts;
    if (board.ended()) throw std::runtime_error("QEMU has ended");
    const std::size_t boots = count(board.console, "image: ");  // the last line of the boot message
    if (boots > kRestartsSeen) return kRestarts;
    if (boots > boots_fed) {
      boots_fed = boots;
      board.send_to_sensor_port(stream.next(static_cast<int>(samples)));
    }
    if (came) continue;
    if (boots_fed == 0 && !fed_blindly) {  // perhaps it lives but cannot say so
      fed_blindly = true;
      board.send_to_sensor_port(stream.next(static_cast<int>(samples)));
      continue;
    }
    if (count(board.console, "restarting") > 0) return kRestarts;
    return board.output.empty() ? kSilent : kGarbled;
  }
}

/// The board is stopped before and after, its image whole.
const std::string& boot_with(EmulatedBoard& board, const Flip& flip, std::size_t samples) {
  const std::uint8_t byte = board.read_byte(flip.address);
  const auto flipped = static_cast<std::uint8_t>(byte ^ (1U << flip.bit));
  board.write_byte(flip.address, flipped);
  if (board.read_byte(flip.address) != flipped) throw std::runtime_error("the flip did not take");
  const std::string* outcome = &kLockUp;
  try {
    outcome = &boot(board, samples);
    board.stop();
    board.write_byte(flip.address, byte);
  } catch (const std::runtime_error&) {  // QEMU ended, or answers no more
    board.replace();
  }
  return *outcome;
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
  EmulatedBoard board(words[0], words[1]);
  if (boot(board, samples) != kValid) {
    std::fputs("boot_flips: the image as it is gives no valid rate\n", stderr);
    return 1;
  }
  std::map<std::string, std::map<std::string, int>> outcomes;
  int accepted = 0;
  board.stop();
  std::size_t done = 0;
  for (const Flip& flip : flips) {
    if (stopped != 0) break;
    ++done;
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
