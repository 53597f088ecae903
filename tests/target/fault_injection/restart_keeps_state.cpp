// restart_keeps_state MACHINE ELF IN.bin EXPECTED.bin ADDRESS: plays the sensor stream IN.bin into
// a board with compact frames and, two thirds of the way, corrupts a constant at ADDRESS in its
// memory, so that its self-test restarts it. EXPECTED.bin is the output of an undisturbed board.
// Exit code 1 unless, soon after the restart, the drift is that board's again, without a flag. A
// board on its internal oscillator cannot know how many samples it lost (SPEC.md,
// thermal_settling), and says so.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>

#include "core/frames/compact_frame.hpp"
#include "core/frames/sensor_frame.hpp"
#include "core/signal/status.hpp"
#include "emulated_board.hpp"

namespace {

using namespace std::chrono_literals;
using fogcomp::injection::Bytes;
using fogcomp::injection::EmulatedBoard;

constexpr auto kPatience = 12s;
constexpr std::size_t kAhead = 16;  // samples on their way: fewer than a line holds
// In samples; a board that starts anew settles for 2,420.
constexpr std::size_t kSoon = 400;
constexpr double kBoundDph = 0.05;
constexpr fog::Status kOfDenoiser =
    fog::Status::denoiser_filling | fog::Status::denoised_invalid | fog::Status::denoised_refused;

using Samples = std::map<unsigned, fog::OutputSample>;  // by number: fewer than 65536

Samples samples_in(const Bytes& frames, std::size_t from) {
  Samples samples;
  for (std::size_t at = from; at + fog::kCompactFrameBytes <= frames.size(); ++at) {
    fog::OutputSample sample;
    std::uint16_t delay = 0;
    if (!fog::decode_compact_frame(&frames[at], sample, delay)) continue;
    samples[sample.sequence] = sample;
    at += fog::kCompactFrameBytes - 1;
  }
  return samples;
}

Bytes read_file(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  Bytes bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.empty()) throw std::runtime_error("cannot read " + name);
  return bytes;
}

/// Feeds a board without flooding it.
class Feed {
 public:
  Feed(EmulatedBoard& board, const Bytes& stream) : board_(board), stream_(stream) {}

  void until(std::size_t samples) {
    while (sent_ < samples) {
      const std::size_t answered = board_.output.size() / fog::kCompactFrameBytes + lost_;
      if (sent_ < answered + kAhead && board_.unsent() == 0)
        send(std::min(kAhead / 2, samples - sent_));
      if (board_.exchange(kPatience)) continue;
      lost_ = sent_ - (answered - lost_);  // what was on its way at the restart
    }
  }
  std::size_t sent() const { return sent_; }

 private:
  void send(std::size_t samples) {
    const auto from = stream_.begin() + static_cast<std::ptrdiff_t>(sent_ * fog::kSensorFrameBytes);
    board_.send_to_sensor_port(
        {from, from + static_cast<std::ptrdiff_t>(samples * fog::kSensorFrameBytes)});
    sent_ += samples;
  }

  EmulatedBoard& board_;
  const Bytes& stream_;
  std::size_t sent_ = 0;
  std::size_t lost_ = 0;
};

int judge(const Samples& samples, const Samples& expected, unsigned restarted_at,
          fog::Status tolerated) {
  std::size_t clean = 0;
  unsigned first = 0;
  double worst_dph = 0;
  for (const auto& [number, sample] : samples) {
    if ((sample.status & ~tolerated) != fog::Status::none || number < restarted_at) continue;
    if (clean++ == 0) first = number;
    const double off_lsb = sample.drift.raw() - expected.at(number).drift.raw();
    worst_dph = std::max(worst_dph, std::abs(off_lsb) / (1 << fog::Rate::fractional_bits));
  }
  std::printf(
      "restarted before sample %u: %zu samples after it, %zu without a flag from %u on, off by "
      "%.3f deg/h\n",
      restarted_at, samples.size(), clean, first, worst_dph);
  return clean > samples.size() / 4 && first <= restarted_at + kSoon && worst_dph <= kBoundDph ? 0
                                                                                               : 1;
}

int run(const std::vector<std::string>& words) {
  if (words.size() != 5) {
    std::fputs("usage: restart_keeps_state MACHINE ELF IN.bin EXPECTED.bin ADDRESS\n", stderr);
    return 2;
  }
  const Bytes stream = read_file(words[2]);
  const std::size_t samples = stream.size() / fog::kSensorFrameBytes;
  EmulatedBoard board(words[0], words[1]);
  board.resume();
  while (board.boots() == 0) {
    if (!board.exchange(kPatience)) throw std::runtime_error("the board does not start");
  }
  Feed feed(board, stream);
  feed.until(2 * samples / 3);
  board.stop();
  board.flip({"", static_cast<std::uint32_t>(std::stoul(words[4], nullptr, 16)), 0});
  board.resume();
  for (std::size_t more = feed.sent(); board.boots() < 2; more += kAhead) {
    if (more > samples - samples / 6) throw std::runtime_error("no restart");
    feed.until(more);
  }
  const std::size_t before = board.output.size();
  const auto restarted_at = static_cast<unsigned>(feed.sent());
  feed.until(samples);
  while (board.exchange(1s)) {
  }
  if (board.times_said("reset cause self-test") != 1) throw std::runtime_error(board.console);
  const bool has_clock = board.times_said("internal oscillator") == 0;
  const fog::Status unknown = has_clock ? fog::Status::none : fog::Status::thermal_settling;
  return judge(samples_in(board.output, before), samples_in(read_file(words[3]), 0), restarted_at,
               kOfDenoiser | unknown);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "restart_keeps_state: %s\n", error.what());
    return 2;
  }
}
