#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog {

// Protocol that writes a model table into a slot of a board through its command port (SPEC.md,
// "Loading a table"): each message is answered before the next one is sent.

enum class LoadStep : std::uint8_t {
  begin,  ///< first words of the slot: asks whether the rest may come; erases
  block,  ///< the next words
  end,    ///< verifies the words and makes the slot valid
};

/// Reasons for which a board refuses a step. Numbers up to other_gyro are those of ModelError.
enum class LoadRefusal : std::uint8_t {
  none,
  not_a_model,
  other_layout,
  damaged,
  out_of_range,
  not_in_image,
  other_board,
  other_gyro,       ///< the table in use belongs to another gyro
  not_newer,        ///< than the table in use: it would not be used
  strap_open,       ///< the board's service strap is open
  flash_failed,     ///< does not keep what is written to it
  not_expected,     ///< a step that does not follow the last one
  frames_too_long,  ///< for the table's sample period
  no_owner,         ///< the board's first table binds it to a gyro: that must be meant
  sample_too_dear,  ///< to compute, for the table's sample period
};

constexpr std::size_t kMaxLoadWords = 32;

struct LoadMessage {
  LoadStep step = LoadStep::begin;
  std::uint32_t at = 0;    ///< of a block: its first word in the slot; of a begin: its options
  std::uint32_t size = 0;  ///< words
  std::array<std::uint32_t, kMaxLoadWords> words{};
};

/// Bits of `at` in a `begin` message.
constexpr std::uint32_t kMayBeAnotherGyro = 1;
constexpr std::uint32_t kMayBeFirst = 2;  ///< of a board that belongs to no gyro yet

struct LoadAnswer {
  LoadStep step = LoadStep::begin;
  LoadRefusal refusal = LoadRefusal::none;
  std::uint32_t next = 0;  ///< words of the slot that the board has
};

constexpr std::size_t kLoadHeaderBytes = 8;
constexpr std::size_t kMaxLoadBytes = kLoadHeaderBytes + 4 * kMaxLoadWords + 4;
constexpr std::size_t kLoadAnswerBytes = 12;
using LoadAnswerBytes = std::array<std::uint8_t, kLoadAnswerBytes>;

/// Writes a message to `out`, at least kMaxLoadBytes, and returns its size in bytes.
std::size_t encode_load_message(const LoadMessage& message, std::uint8_t* out);

LoadAnswerBytes encode_load_answer(const LoadAnswer& answer);

/// Reads kLoadAnswerBytes bytes. Returns false, and changes nothing, unless sync, numbers and CRC
/// are right.
bool decode_load_answer(const std::uint8_t* bytes, LoadAnswer& answer);

/// Finds messages in a byte stream. After damage it may miss the next one: a sender that gets no
/// answer repeats the message.
class LoadParser {
 public:
  /// Whether this byte completes a message with a right CRC.
  bool feed(std::uint8_t byte);
  const LoadMessage& message() const { return message_; }

 private:
  bool is_possible() const;
  bool read();

  std::size_t size_ = 0;
  std::array<std::uint8_t, kMaxLoadBytes> bytes_{};
  LoadMessage message_;
};

}  // namespace fog
