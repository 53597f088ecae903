#include "recording/input_file.hpp"

#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "recording/decision_rules.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"

namespace fogcomp::recording {
namespace {

constexpr std::uint32_t kByteOrderMark = 0xFEFF;
constexpr std::uint32_t kReplacement = 0xFFFD;

std::uint32_t unit_of(std::string_view text, std::size_t at, ByteOrder order) {
  const std::uint32_t first = static_cast<unsigned char>(text[at]);
  const std::uint32_t second = static_cast<unsigned char>(text[at + 1]);
  return order == ByteOrder::little ? first | (second << 8U) : second | (first << 8U);
}

bool is_latin(std::uint32_t unit) {
  return unit == '\t' || unit == '\n' || unit == '\r' || (unit >= 0x20U && unit < 0x250U);
}

bool is_text_in(std::string_view head, ByteOrder order) {
  const std::size_t units = std::min(head.size() / 2, rules::kUtf16UnitsLookedAt);
  std::size_t latin = 0;
  for (std::size_t i = 0; i < units; ++i) {
    const std::uint32_t unit = unit_of(head, 2 * i, order);
    if (is_latin(unit) || (i == 0 && unit == kByteOrderMark)) ++latin;
  }
  return units >= rules::kMinUtf16Units &&
         static_cast<double>(latin) >= rules::kMinLatinShare * static_cast<double>(units);
}

char* put_utf8(std::uint32_t code, char* out) {
  const auto tail = [&](unsigned shift) {
    *out++ = static_cast<char>(0x80U | ((code >> shift) & 0x3FU));
  };
  if (code < 0x80U) {
    *out++ = static_cast<char>(code);
  } else if (code < 0x800U) {
    *out++ = static_cast<char>(0xC0U | (code >> 6U));
    tail(0);
  } else if (code < 0x10000U) {
    *out++ = static_cast<char>(0xE0U | (code >> 12U));
    tail(6);
    tail(0);
  } else {
    *out++ = static_cast<char>(0xF0U | (code >> 18U));
    tail(12);
    tail(6);
    tail(0);
  }
  return out;
}

constexpr std::size_t kMaxBufferBytes = 1U << 20U;
constexpr std::size_t kFewestBufferBytes = 1U << 16U;
constexpr std::size_t kPieceBytes = 1U << 14U;
constexpr const char* kStandardInput = "/dev/stdin";

// Byte order, if a file that begins with `head` is UTF-16 text ("Unicode text" of a spreadsheet),
// with or without a byte order mark: nearly all of its first characters are Latin.
std::optional<ByteOrder> utf16_order(std::string_view head) {
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    if (is_text_in(head, order)) return order;
  }
  return std::nullopt;
}

}  // namespace

char* Utf16Decoder::decode(std::string_view bytes, char* out) {
  rest_ += bytes;
  std::size_t at = 0;
  for (std::size_t end = 2; end <= rest_.size(); at = end, end += 2) {
    std::uint32_t code = unit_of(rest_, at, order_);
    const bool is_high = code >= 0xD800U && code < 0xDC00U;
    if (is_high && end + 2 > rest_.size()) break;
    const std::uint32_t low = is_high ? unit_of(rest_, end, order_) : 0;
    if (low >= 0xDC00U && low < 0xE000U) {
      code = 0x10000U + ((code - 0xD800U) << 10U) + (low - 0xDC00U);
      end += 2;
    } else if (code >= 0xD800U && code < 0xE000U) {
      code = kReplacement;
    }
    if (code != kByteOrderMark) out = put_utf8(code, out);
  }
  rest_.erase(0, at);
  return out;
}

InputFile::InputFile(std::string path, std::function<void(const std::string&, double)> progress)
    : path_(std::move(path)), buffer_bytes_(kMaxBufferBytes), progress_(std::move(progress)) {
  descriptor_ = open_input(path_ == "-" ? kStandardInput : path_);
  struct stat status {};
  if (::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) {
    size_ = static_cast<std::size_t>(status.st_size);
  }
  // No larger than the file, plus a byte to detect its end.
  if (size_ > 0) buffer_bytes_ = std::clamp(size_ + 1, kFewestBufferBytes, kMaxBufferBytes);
  // One more byte for the line end that a last line may lack; not zeroed, because most is not used.
  buffer_.reset(new char[buffer_bytes_ + 1]);
}

InputFile::~InputFile() {
  ::close(descriptor_);
}

std::size_t InputFile::read_into(char* place, std::size_t bytes) {
  for (;;) {
    const ssize_t got = ::read(descriptor_, place, bytes);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      throw InputError(path_, std::string("cannot be read (") + std::strerror(errno) + ")");
    }
    at_end_ = got == 0;
    read_bytes_ += static_cast<std::size_t>(got);
    return static_cast<std::size_t>(got);
  }
}

void InputFile::append_decoded(std::string_view bytes) {
  char* const end = utf16_->decode(bytes, buffer_.get() + end_);
  end_ = static_cast<std::size_t>(end - buffer_.get());
}

// The text read so far is UTF-16: from now on the buffer holds UTF-8.
void InputFile::begin_decoding(ByteOrder order) {
  const std::string raw(buffer_.get(), end_);
  buffer_bytes_ = 2 * kMaxBufferBytes;
  buffer_.reset(new char[buffer_bytes_ + 1]);
  utf16_.emplace(order);
  end_ = 0;
  append_decoded(raw);
}

// Moves the unread bytes to the front and reads until the buffer is full or the file ends.
void InputFile::fill() {
  std::memmove(buffer_.get(), buffer_.get() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  while (!utf16_ && !at_end_ && end_ < buffer_bytes_) {
    end_ += read_into(buffer_.get() + end_, buffer_bytes_ - end_);
    // A pipe may deliver single bytes: the content is judged by more of them.
    if (begun_ || (!at_end_ && end_ < kPieceBytes)) continue;
    begun_ = true;
    if (const auto order = utf16_order({buffer_.get(), end_})) begin_decoding(*order);
  }
  std::array<char, kPieceBytes> piece;
  while (utf16_ && !at_end_ && end_ + Utf16Decoder::max_output(kPieceBytes) < buffer_bytes_) {
    const std::size_t got = read_into(piece.data(), kPieceBytes);
    append_decoded({piece.data(), got});
  }
  if (size_ == 0 || !progress_) return;
  progress_("reading " + path_, static_cast<double>(read_bytes_) / static_cast<double>(size_));
}

std::string_view InputFile::peek() {
  fill();
  return {buffer_.get() + begin_, end_ - begin_};
}

std::string_view InputFile::next_block() {
  const std::string_view block = peek();
  begin_ = end_;
  return block;
}

bool InputFile::next_line(std::string_view& line) {
  const char* start = buffer_.get() + begin_;
  const void* found = std::memchr(start, '\n', end_ - begin_);
  if (found == nullptr) {
    fill();
    if (begin_ == end_) return false;
    start = buffer_.get();
    found = std::memchr(start, '\n', end_);
  }
  ++line_number_;
  if (found == nullptr) {
    if (!at_end_) throw InputError(where(), "line longer than 1 MiB; is this a recording?");
    lacks_line_end_ = true;
    buffer_[end_] = '\n';
    found = buffer_.get() + end_;
    begin_ = end_;
  } else {
    begin_ = static_cast<std::size_t>(static_cast<const char*>(found) - buffer_.get()) + 1;
  }
  auto length = static_cast<std::size_t>(static_cast<const char*>(found) - start);
  while (length > 0 && start[length - 1] == '\r') --length;
  line = {start, length};
  return true;
}

std::string InputFile::where() const {
  return path_ + ":" + std::to_string(line_number_);
}

}  // namespace fogcomp::recording
