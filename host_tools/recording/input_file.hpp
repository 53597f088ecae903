#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace fogcomp::recording {

enum class ByteOrder : std::uint8_t { little, big };

/// Converts UTF-16 to UTF-8 piece by piece. The byte order mark is dropped; invalid units become
/// U+FFFD.
class Utf16Decoder {
 public:
  explicit Utf16Decoder(ByteOrder order) : order_(order) {}

  /// Largest number of UTF-8 bytes for `bytes` of input and the rest of the previous piece.
  static constexpr std::size_t max_output(std::size_t bytes) { return bytes / 2 * 3 + 8; }
  /// Writes the characters of a piece to `out`, at least max_output(bytes.size()) bytes, and
  /// returns the new end.
  char* decode(std::string_view bytes, char* out);

 private:
  ByteOrder order_;
  std::string rest_{};  // of a character that the next piece completes
};

/// A file or pipe read once from start to end through one buffer, by lines or by blocks. Reports
/// progress if the size is known. UTF-16 text is converted to UTF-8. Errors are InputError with the
/// file's name.
class InputFile {
 public:
  /// "-" is standard input. Throws for a missing or unreadable file and for a directory. `progress`
  /// is called with the fraction read, 0..1; may be empty.
  explicit InputFile(std::string path,
                     std::function<void(const std::string& stage, double done)> progress = {});
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& path() const { return path_; }
  /// Size in bytes, 0 if unknown (a pipe).
  std::size_t size() const { return size_; }
  bool is_utf16() const { return utf16_.has_value(); }
  /// Whether peek() shows the whole rest.
  bool at_end() const { return at_end_; }

  /// The unread bytes in the buffer, without taking them: 1 MiB, or the rest of the file.
  std::string_view peek();
  /// Takes the bytes that peek() shows; empty at the end of the file.
  std::string_view next_block();

  /// Takes the next line, without its LF or CRLF; false at the end. The byte after the view is
  /// readable and is CR or LF. Throws for a line longer than 1 MiB.
  bool next_line(std::string_view& line);
  /// Whether the line taken last is the file's last one and has no LF.
  bool lacks_line_end() const { return lacks_line_end_; }
  /// Of the line taken last, from 1.
  std::size_t line_number() const { return line_number_; }
  /// `FILE:LINE` of the line taken last, for messages.
  std::string where() const;

 private:
  void fill();
  std::size_t read_into(char* place, std::size_t bytes);
  void begin_decoding(ByteOrder order);
  void append_decoded(std::string_view bytes);

  std::string path_;
  int descriptor_ = -1;
  std::size_t size_ = 0;
  std::size_t buffer_bytes_;
  std::unique_ptr<char[]> buffer_;
  std::size_t begin_ = 0;  // unread bytes: [begin_, end_)
  std::size_t end_ = 0;
  bool at_end_ = false;
  std::size_t line_number_ = 0;
  bool lacks_line_end_ = false;
  std::size_t read_bytes_ = 0;
  bool begun_ = false;
  std::optional<Utf16Decoder> utf16_;
  std::function<void(const std::string&, double)> progress_;
};

/// Name of the script in importers/ that reads a file with these first bytes ("mcap"); "" if none
/// does.
std::string importer_of(std::string_view head);

/// Throws InputError for a file of a common format that is neither text nor a sensor stream,
/// recognised by its first bytes, with the way to a CSV.
void refuse_foreign_format(std::string_view head, const std::string& path);

}  // namespace fogcomp::recording
