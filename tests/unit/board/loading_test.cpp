// Loading a table with the tool into a board. This test is the board, behind a socket, running the
// flashed code. An unsuitable table is refused with a reason.
#include "board/loading.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <memory>
#include <set>
#include <thread>

#include "board/board_texts.hpp"
#include "board/table_files.hpp"
#include "core/frames/health_record.hpp"
#include "core/frames/health_request.hpp"
#include "core/pipeline/slot_loader.hpp"
#include "support/cut_flash.hpp"
#include "support/input_error.hpp"
#include "support/sample_models.hpp"

namespace {

using fog::test::CutFlash;
using fogcomp::board::BoardSettings;
using fogcomp::board::BoardTable;
using fogcomp::board::LoadedTable;

constexpr fogcomp::board::ProcessorNumber kProcessor{0x00340051, 0x57355012, 0x2032394D};

/// The generic image's command port.
class Board {
 public:
  explicit Board(const std::string& path) : socket_(socket(AF_UNIX, SOCK_STREAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    listen(socket_, 1);
    start();
    thread_ = std::thread([this] { serve(); });
  }
  ~Board() {
    ends_ = true;
    thread_.join();
    close(socket_);
  }
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;

  // Set before the tool connects.
  CutFlash flash;
  bool strap_closed = true;
  bool has_slots = true;
  std::set<unsigned> lost_answers;  ///< to messages that load: the first, the second, ...
  fog::SlotChoice choice() const { return choice_; }

 private:
  void start() {
    choice_ = fog::choose_slot(flash.both(), fog::kGenericImage, kProcessor, parameters_);
    const fog::LoadTarget target = fog::load_target(choice_, flash.both(), kProcessor);
    loader_ = std::make_unique<fog::SlotLoader<CutFlash>>(flash, target, fog::kGenericImage);
  }
  void serve() {
    while (!ends_) {
      pollfd waiting{socket_, POLLIN, 0};
      if (poll(&waiting, 1, 5) <= 0) continue;
      const int connection = accept(socket_, nullptr, nullptr);
      start();
      while (!ends_ && answer(connection)) {
      }
      close(connection);
    }
  }
  bool answer(int connection) {
    pollfd waiting{connection, POLLIN, 0};
    if (poll(&waiting, 1, 5) <= 0) return true;
    std::uint8_t byte = 0;
    if (read(connection, &byte, 1) != 1) return false;
    const auto send = [&](const auto& bytes) {
      static_cast<void>(::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL));
    };
    if (health_.feed(byte)) {
      fog::HealthRecord record;
      std::copy(kProcessor.begin(), kProcessor.end(), &record[fog::HealthWord::processor]);
      send(fog::encode_health_response(record));
    }
    if (has_slots && slots_.feed(byte)) send(fog::encode_slots_response(slots()));
    if (loads_.feed(byte)) {
      const auto bytes = fog::encode_load_answer(loader_->take(loads_.message(), strap_closed));
      if (lost_answers.count(++answers_) == 0) send(bytes);
      if (loader_->has_ended()) start();
    }
    return true;
  }
  fog::SlotsRecord slots() const {
    fog::SlotsRecord record;
    record.used = static_cast<std::uint8_t>(choice_.slot);
    for (std::size_t i = 0; i < record.slots.size(); ++i) {
      const fog::SlotContents& slot = choice_.slots[i];
      record.slots[i].error = static_cast<std::uint8_t>(slot.error);
      record.slots[i].sequence = slot.sequence;
      if (slot.table.size == 0) continue;
      record.slots[i].table = static_cast<std::uint32_t>(slot.table[slot.table.size - 1]);
      std::memcpy(record.slots[i].serial.data(), slot.table.data + fog::kIdentityAt, 16);
    }
    return record;
  }

  int socket_;
  unsigned answers_ = 0;
  std::atomic<bool> ends_{false};
  std::thread thread_;
  fog::ModelParameters parameters_;
  fog::SlotChoice choice_;
  std::unique_ptr<fog::SlotLoader<CutFlash>> loader_;
  fog::HealthRequestParser health_;
  fog::RequestParser<fog::kSlotsRequest> slots_;
  fog::LoadParser loads_;
};

class LoadTable : public testing::Test {
 protected:
  LoadTable() {
    std::string folder =
        (std::filesystem::temp_directory_path() / "fogcomp_loading_XXXXXX").string();
    folder_ = mkdtemp(folder.data());
    path_ = folder_ + "/port";
    board_ = std::make_unique<Board>(path_);
  }
  ~LoadTable() override {
    board_.reset();
    std::filesystem::remove_all(folder_);
  }

  static BoardTable table(const std::string& serial, const BoardSettings& settings = {}) {
    BoardSettings with = settings;
    with.serial = serial;
    return fogcomp::board::make_board_table(fog::test::paper_like_model(), with);
  }
  LoadedTable load(const BoardTable& table, bool another_gyro = false, bool serial_given = true) {
    fogcomp::board::BoardPort port(path_, fog::SerialLine());
    return fogcomp::board::load_table(port, table,
                                      {"PORT", "GYRO.bin", another_gyro, serial_given});
  }
  // The error message, and the number of bytes written to the board.
  std::string refusal(const BoardTable& table) {
    const std::size_t before = board_->flash.writes;
    std::string message;
    try {
      load(table);
    } catch (const fogcomp::InputError& error) {
      message = error.what();
    }
    written_ = board_->flash.writes - before;
    return message;
  }
  void expect_refused(const BoardTable& table, const std::string& words) {
    const std::string message = refusal(table);
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_EQ(written_, 0U);
  }

  std::string folder_;
  std::string path_;
  std::unique_ptr<Board> board_;
  std::size_t written_ = 0;
};

TEST_F(LoadTable, GoesIntoTheSlotThatIsNotInUseAndIsNewer) {
  for (std::uint32_t i = 1; i < 4; ++i) {
    const LoadedTable loaded = load(table("G1"));
    EXPECT_EQ(loaded.slot, (i + 1) % 2);
    EXPECT_EQ(loaded.record.sequence, i);
    EXPECT_EQ(loaded.record.table, static_cast<std::uint32_t>(table("G1").words.back()));
  }
}

TEST_F(LoadTable, ComesThroughALineThatLosesAnswers) {
  board_->lost_answers = {2};  // of a block: a begin is waited for longer
  EXPECT_EQ(load(table("G1")).slot, 0U);
  const std::size_t words = fogcomp::board::slot_bytes(table("G1"), 1, "").size() / 4;
  const std::size_t blocks = (words - fog::kLoadHeadWords + 31) / fog::kMaxLoadWords;
  board_->lost_answers = {static_cast<unsigned>(3 + blocks + 2 + blocks)};  // of the second end
  EXPECT_EQ(load(table("G1")).slot, 1U);
}

TEST_F(LoadTable, OfAnotherGyroOrBoardIsRefusedBeforeAnythingIsSent) {
  load(table("G1"));
  expect_refused(table("G2"), "GYRO.bin: is of gyro G2, and the board's table of gyro G1");
  BoardSettings elsewhere;
  elsewhere.processor = {1, 2, 3};
  expect_refused(table("G1", elsewhere),
                 "GYRO.bin: is bound to processor 000000010000000200000003; this board has "
                 "00340051573550122032394d");
  EXPECT_EQ(load(table("G2"), true).slot, 1U);
  BoardSettings here;
  here.processor = kProcessor;
  EXPECT_EQ(load(table("G2", here)).slot, 0U);
}

TEST_F(LoadTable, TooLargeForTheImageIsRefusedBeforeAnythingIsSent) {
  fogcomp::model::Model model = fog::test::paper_like_model();
  model.denoise.levels = fog::kGenericLevels + 1;
  expect_refused(fogcomp::board::make_board_table(model, {}), "denoisers of up to 6 levels");
}

TEST_F(LoadTable, IsRefusedByTheBoardByName) {
  load(table("G1"));
  board_->strap_closed = false;
  expect_refused(table("G1"), "PORT: the board's service strap is open");
  board_->strap_closed = true;
  board_->flash.fails = true;
  expect_refused(table("G1"), "PORT: the board's flash does not hold");
  board_->flash.fails = false;
  EXPECT_EQ(load(table("G1")).record.sequence, 2U);
}

TEST_F(LoadTable, FirstTable_SerialNotGiven_Refused) {
  try {
    load(table("G1"), false, false);
    FAIL();
  } catch (const fogcomp::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("say which that is: --serial"), std::string::npos);
  }
  load(table("G1"));
  EXPECT_EQ(load(table("G1"), false, false).slot, 1U);
}

TEST_F(LoadTable, TableWithoutSerial_OfAGyrosBoard_Refused) {
  load(table("G1"));
  expect_refused(table(""),
                 "is of no gyro (without a serial number), and the board's table of gyro G1");
}

TEST_F(LoadTable, NeedsTheGenericImage) {
  board_->has_slots = false;
  expect_refused(table("G1"), "flash the generic image");
}

}  // namespace
