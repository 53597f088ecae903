// The board's parser: every frame it finds was sent, byte for byte, after the one before; and after
// any bytes it is back within one good frame.
#include <algorithm>
#include <vector>

#include "core/frames/stream_parser.hpp"
#include "fuzzing.hpp"

using fog::StreamParser;
using fog::test::promise;

namespace {

class Listener {
 public:
  StreamParser::Found feed(std::uint8_t byte) {
    sent_.push_back(byte);
    const StreamParser::Found found = parser_.feed(byte);
    if (found == StreamParser::Found::sample) take(encode_sensor_frame(parser_.sample()));
    if (found == StreamParser::Found::extension) take(encode_extension_frame(parser_.extension()));
    promise(sent_.size() - good_ - parser_.discarded_bytes() < fog::kSensorFrameBytes,
            "every byte is in a frame, discarded, or waited with");
    return found;
  }

  const StreamParser& parser() const { return parser_; }

 private:
  template <class Frame>
  void take(const Frame& frame) {
    const auto at = std::search(sent_.begin() + taken_, sent_.end(), frame.begin(), frame.end());
    promise(at != sent_.end(), "a frame is accepted as it was sent");
    taken_ = at - sent_.begin() + static_cast<std::ptrdiff_t>(frame.size());
    good_ += frame.size();
  }

  StreamParser parser_;
  std::vector<std::uint8_t> sent_;
  std::ptrdiff_t taken_ = 0;  // end of the last frame found
  std::size_t good_ = 0;      // bytes of all of them
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Listener listener;
  for (std::size_t i = 0; i < size; ++i) listener.feed(data[i]);
  auto found = StreamParser::Found::nothing;
  for (std::uint16_t sequence = 0xA55A; sequence < 0xA55A + 2; ++sequence) {
    for (const std::uint8_t byte :
         fog::encode_sensor_frame({sequence, 0x5AA5C3A5, 25 << 16, true, true})) {
      found = listener.feed(byte);
    }
  }
  promise(found == StreamParser::Found::sample && listener.parser().sample().sequence == 0xA55B,
          "it is back within one good frame");
  return 0;
}
