#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fogcomp {

/// Throws InputError for a path with a control character in it: wherever it is printed, a terminal
/// would obey it.
void require_printable_name(const std::string& path);

/// Where writing to `path` ends up: the target of a symbolic link, whether it exists or not, else
/// `path` itself. Throws InputError for links in a circle.
std::string resolve_links(const std::string& path);

/// Whether two paths name the same regular file, by whatever links and spellings, or the same place
/// for a file that neither names yet. Pipes and devices, which are not replaced, are never the
/// same.
bool same_file(const std::string& a, const std::string& b);

/// A file that appears whole or not at all: written without a name in the folder of its own, or
/// under a temporary one where the file system has no such files, and named by commit(). Without
/// commit() (an error, a signal) nothing is left of it, except of one with a temporary name when
/// SIGKILL ends the process, and whatever had the name before is untouched. A file that is replaced
/// keeps its permissions; a symbolic link stays one, and its target is replaced. What is no regular
/// file, a pipe or a device, is written to as it is.
class OutputFile {
 public:
  /// Opens the temporary file. Throws InputError where the folder cannot be written, or `path` is a
  /// directory or a file that is read-only.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends bytes. Throws InputError where the disk is full.
  void write(const void* bytes, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }

  /// Hands all bytes to the system. With two outputs, both are flushed before one is committed, so
  /// that a full disk leaves neither.
  void flush();

  /// Flushes, checks that all was written, and gives the file its name.
  void commit();

  const std::string& path() const { return path_; }

 private:
  void open_temporary();
  bool name_temporary(const std::function<bool(const char*)>& make);
  bool give_name();
  void discard_temporary();

  std::string path_;
  std::string target_;          ///< `path_` with its links resolved
  std::string temporary_path_;  ///< empty as long as there is none
  bool nameless_ = false;       ///< a file that has no name yet
  int descriptor_ = -1;
  std::vector<char> buffer_;
};

/// Makes the folder, and those above it, where it is missing. Throws InputError where it cannot be
/// or nothing can be written there.
void make_folder(const std::string& folder);

/// Writes `text` to `path` whole or not at all.
void write_file(const std::string& path, std::string_view text);

/// Opens a file, pipe or terminal for reading and returns its descriptor. Throws InputError for a
/// missing file, a directory, and a device such as /dev/zero, which never ends.
int open_input(const std::string& path);

/// The whole file. Throws InputError as open_input() does, for a read error, and for one larger
/// than the 64 MiB that no model, header or profile comes near.
std::string read_file(const std::string& path);

}  // namespace fogcomp
