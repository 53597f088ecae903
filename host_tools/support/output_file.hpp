#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace fogcomp {

/// Throws InputError for a path with a control character, which a terminal would execute when it is
/// printed.
void require_printable_name(const std::string& path);

/// Whether two paths name the same regular file, through any links and spellings, or the same place
/// for a new file. Pipes and devices, which are not replaced, are never the same.
bool same_file(const std::string& a, const std::string& b);

/// A file that appears completely or not at all: written without a name in its folder (or under a
/// temporary name, if the file system requires one) and named by commit(). Without commit() (an
/// error, a signal) nothing remains, except a temporary name after SIGKILL, and an existing file is
/// unchanged. A replaced file keeps its permissions; of a symbolic link the target is replaced.
/// Pipes and devices are written to directly.
class OutputFile {
 public:
  /// Opens the temporary file. Throws InputError if the folder is not writable, or `path` is a
  /// directory or a read-only file.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends bytes. Throws InputError if the disk is full.
  void write(const void* bytes, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }

  /// Passes all bytes to the system. Of two outputs, flush both before committing one, so that a
  /// full disk leaves neither.
  void flush();

  /// Flushes, checks for errors, and gives the file its name.
  void commit();

  const std::string& path() const { return path_; }

 private:
  void open_temporary();
  bool name_temporary(const std::function<bool(const char*)>& make);
  bool give_name();
  void discard_temporary();

  std::string path_;
  std::string target_;          ///< `path_` with links resolved
  std::string temporary_path_;  ///< empty if there is none
  bool nameless_ = false;       ///< has no name yet
  int descriptor_ = -1;
  std::vector<char> buffer_;
};

/// Creates the folder and its missing parents. Throws InputError if that fails or the folder is not
/// writable.
void make_folder(const std::string& folder);

/// Writes `text` to `path`, completely or not at all.
void write_file(const std::string& path, std::string_view text);

/// Whether a file has this text at its beginning. A pipe, which can be read only once, is not
/// looked at.
bool file_begins_with(const std::string& path, std::string_view text);

/// Opens a file, pipe or terminal for reading and returns its descriptor. Throws InputError for a
/// missing file, a directory, and an endless device such as /dev/zero.
int open_input(const std::string& path);

/// Reads the whole file. Throws InputError like open_input(), for a read error, and for more than
/// 64 MiB, far above any model, header or profile.
std::string read_file(const std::string& path);

}  // namespace fogcomp
