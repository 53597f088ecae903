#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fogcomp {

/// Where writing to `path` ends up: the target of a symbolic link, whether it exists or not, else
/// `path` itself. Throws InputError for links in a circle.
std::string resolve_links(const std::string& path);

/// Whether two paths name the same regular file, by whatever links and spellings, or the same place
/// for a file that neither names yet. Pipes and devices, which are not replaced, are never the
/// same.
bool same_file(const std::string& a, const std::string& b);

/// A file that appears whole or not at all: written under a temporary name beside its own and
/// renamed by commit(). Without commit() (an error, an interrupt) the temporary file is removed and
/// whatever had the name before is untouched. What is no regular file, a pipe or a device, is
/// written to as it is.
class OutputFile {
 public:
  /// Opens the temporary file. Throws InputError where the folder cannot be written or `path` is a
  /// directory.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Appends bytes. Throws InputError where the disk is full.
  void write(const void* bytes, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }

  /// Flushes, checks that all was written, and gives the file its name.
  void commit();

  const std::string& path() const { return path_; }

 private:
  void flush();
  void discard_temporary();

  std::string path_;
  std::string temporary_path_;  ///< empty where a pipe or device is written in place
  int descriptor_ = -1;
  std::vector<char> buffer_;
};

/// Makes the folder, and those above it, where it is missing. Throws InputError where it cannot be
/// or nothing can be written there.
void make_folder(const std::string& folder);

/// Writes `text` to `path` whole or not at all.
void write_file(const std::string& path, std::string_view text);

/// The whole file. Throws InputError for a missing file, a directory or a read error.
std::string read_file(const std::string& path);

}  // namespace fogcomp
