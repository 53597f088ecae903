// The board's command port, and the host's reader of its answer.
#include <algorithm>

#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"
#include "core/frames/health_record.hpp"
#include "core/frames/health_request.hpp"
#include "core/frames/slots_record.hpp"
#include "fuzzing.hpp"

using fog::test::promise;

namespace {

void read_answer(const std::uint8_t* bytes) {
  fog::HealthRecord record;
  if (!fog::decode_health_response(bytes, record)) return;
  const fog::HealthResponse again = fog::encode_health_response(record);
  // An earlier image's has another layout, and thus another CRC.
  constexpr std::ptrdiff_t kAfterLayout = 3;
  constexpr std::ptrdiff_t kCrc = fog::kHealthResponseBytes - 4;
  promise(std::equal(again.begin() + kAfterLayout, again.begin() + kCrc, bytes + kAfterLayout),
          "an answer is read as it was sent");
}

void read_slots(const std::uint8_t* bytes) {
  fog::SlotsRecord record;
  if (!fog::decode_slots_response(bytes, record)) return;
  const fog::SlotsResponse again = fog::encode_slots_response(record);
  const bool same = std::equal(again.begin(), again.end(), bytes);
  // The three bytes behind each error are of no account.
  promise(same || fog::load_le32(bytes + 4) > 0xFFU || fog::load_le32(bytes + 36) > 0xFFU,
          "an answer is read as it was sent");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fog::HealthRequestParser parser;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t received = std::min(i + 1, fog::kHealthRequestBytes);
    const bool is_request =
        received == fog::kHealthRequestBytes &&
        std::equal(fog::kHealthRequest.begin(), fog::kHealthRequest.end(), data + i + 1 - received);
    promise(parser.feed(data[i]) == is_request, "it answers requests, all of them, nothing else");
  }
  if (size < fog::kHealthResponseBytes) return 0;
  read_slots(data);
  read_answer(data);
  // With the CRC that chance would hardly meet.
  fog::HealthResponse sealed;
  constexpr std::size_t kCrc = sealed.size() - 4;
  std::copy_n(data, kCrc, sealed.begin());
  fog::store_le32(&sealed[kCrc], fog::crc32(sealed.data(), kCrc));
  read_answer(sealed.data());
  return 0;
}
