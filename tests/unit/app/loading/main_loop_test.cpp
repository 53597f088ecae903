// The product's main loop with the generic image's model, while a table is loaded. This test is the
// board; its demodulator continues to send.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "board/table_files.hpp"
#include "core/frames/kvh_frame.hpp"
#include "core/frames/load_message.hpp"
#include "core/pipeline/slot_loader.hpp"
#include "platform/board.hpp"
#include "support/sample_models.hpp"
#include "timed_board.hpp"

namespace {

using fog::LoadAnswer;
using fog::LoadMessage;
using fog::LoadRefusal;
using fog::LoadStep;
using fog::test::board;
using fog::test::EndOfTest;
using fog::test::Restart;

constexpr std::size_t kFrameBytes = std::tuple_size_v<fog::KvhFrame>;

std::vector<std::uint32_t> slot_of(std::uint32_t sequence) {
  fogcomp::board::BoardSettings settings;
  settings.invalidating = fog::Status::none;
  const auto table = fogcomp::board::make_board_table(fog::test::paper_like_model(), settings);
  const std::string bytes = fogcomp::board::slot_bytes(table, sequence, "test");
  std::vector<std::uint32_t> words(bytes.size() / 4);
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

void ask_to_load(const std::vector<std::uint32_t>& slot) {
  LoadMessage message{LoadStep::begin, 0, fog::kLoadHeadWords, {}};
  std::copy_n(slot.begin(), fog::kLoadHeadWords, message.words.begin());
  std::array<std::uint8_t, fog::kMaxLoadBytes> bytes{};
  const std::size_t size = fog::encode_load_message(message, bytes.data());
  board.requests.insert(board.requests.end(), bytes.begin(),
                        bytes.begin() + static_cast<std::ptrdiff_t>(size));
}

// What the board has sent since the last call.
struct Sent {
  std::vector<LoadAnswer> answers;
  int valid = 0;
  int silent = 0;  // not valid
};
Sent what_was_sent() {
  Sent sent;
  for (const auto& bytes : board.sent) {
    LoadAnswer answer;
    if (bytes.size() == kFrameBytes) {
      ++(bytes[28] != 0 ? sent.valid : sent.silent);
    } else if (bytes.size() == fog::kLoadAnswerBytes &&
               fog::decode_load_answer(bytes.data(), answer)) {
      sent.answers.push_back(answer);
    }
  }
  board.sent.clear();
  return sent;
}

// One after the other: as on a board, the model is the one present at the start.
TEST(MainLoopOfTheGenericImage, StopsTheRateWhileATableIsLoadedSaysSoAndRestarts) {
  const auto first = slot_of(1);
  board.flash.program(0, 0, first.data(), first.size());
  board.run_for(5000);
  EXPECT_GT(what_was_sent().valid, 100) << "the denoiser is full after half of the time";

  ask_to_load(slot_of(2));
  board.run_for(1000);
  Sent sent = what_was_sent();
  ASSERT_EQ(sent.answers.size(), 1U);
  EXPECT_EQ(sent.answers[0].refusal, LoadRefusal::strap_open);
  EXPECT_NEAR(sent.valid, 200, 2) << "as if nothing had been asked for";
  EXPECT_LT(sent.silent, 10);

  board.strap_closed = true;
  ask_to_load(slot_of(2));
  board.run_for(1000);
  EXPECT_TRUE(board.stalled);
  EXPECT_EQ(board.patience_ms, 106U) << "the watchdog is as tight as before";
  sent = what_was_sent();
  ASSERT_EQ(sent.answers.size(), 1U);
  EXPECT_EQ(sent.answers[0].refusal, LoadRefusal::none);
  EXPECT_LE(sent.valid, 2);
  EXPECT_NEAR(sent.silent, 200, 5) << "a second of frames that are not valid";

  board.end_us = board.now_us + 6'000'000;
  EXPECT_THROW(fog::app::run(), Restart) << "nobody goes on loading";
  sent = what_was_sent();
  EXPECT_EQ(sent.valid, 0);
  EXPECT_GT(sent.silent, 700);
}

}  // namespace
