#include "support/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <mutex>

#include "support/input_error.hpp"

namespace fogcomp {
namespace {

constexpr std::size_t kBufferBytes = 1U << 20U;

// Temporary files in being, for the signal handler: an interrupted command leaves no half file.
// A fixed array, because a signal handler may neither lock nor allocate.
constexpr std::size_t kMostOpenFiles = 16;
constexpr std::size_t kLongestPath = 4096;
std::array<char[kLongestPath], kMostOpenFiles> unfinished_paths;
std::mutex unfinished_mutex;

void remove_unfinished_files(int signal_number) {
  for (const auto& path : unfinished_paths) {
    if (path[0] != '\0') ::unlink(path);
  }
  std::signal(signal_number, SIG_DFL);
  ::raise(signal_number);
}

void remember_unfinished(const std::string& path) {
  const std::lock_guard<std::mutex> lock(unfinished_mutex);
  static const bool handlers_installed = [] {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
      if (std::signal(number, remove_unfinished_files) == SIG_IGN) std::signal(number, SIG_IGN);
    }
    return true;
  }();
  static_cast<void>(handlers_installed);
  if (path.size() >= kLongestPath) return;
  for (auto& slot : unfinished_paths) {
    if (slot[0] == '\0') {
      std::memcpy(slot + 1, path.c_str() + 1, path.size());
      slot[0] = path[0];  // last, so that the handler never sees half a path
      return;
    }
  }
}

void forget_unfinished(const std::string& path) {
  const std::lock_guard<std::mutex> lock(unfinished_mutex);
  for (auto& slot : unfinished_paths) {
    if (path == slot) slot[0] = '\0';
  }
}

// A path that neither links nor spellings change.
std::filesystem::path canonical_place(const std::string& path) {
  std::error_code error;
  const std::filesystem::path place =
      std::filesystem::weakly_canonical(std::filesystem::absolute(resolve_links(path)), error);
  return error ? std::filesystem::path(path) : place;
}

}  // namespace

std::string resolve_links(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr int kMaxLinks = 40;  // as Linux follows
  fs::path target = path;
  for (int links = 0; links <= kMaxLinks; ++links) {
    std::error_code no_link;
    const fs::path next = fs::read_symlink(target, no_link);
    if (no_link) return target.string();
    target = target.parent_path() / next;  // `next` alone where it is absolute
  }
  throw InputError(path, "is a link that leads to itself; name a file");
}

bool same_file(const std::string& a, const std::string& b) {
  struct stat status_a {};
  struct stat status_b {};
  const bool exists_a = ::stat(a.c_str(), &status_a) == 0;
  const bool exists_b = ::stat(b.c_str(), &status_b) == 0;
  if (exists_a != exists_b) return false;
  if (!exists_a) return canonical_place(a) == canonical_place(b);
  return S_ISREG(status_a.st_mode) && status_a.st_dev == status_b.st_dev &&
         status_a.st_ino == status_b.st_ino;
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  struct stat status {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    throw InputError(path_, "is a directory; name a file to write");
  }
  // A pipe or a device (/dev/null) is written to, never replaced by a file.
  const bool in_place = exists && !S_ISREG(status.st_mode);
  if (in_place) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    temporary_path_ = path_ + ".part-" + std::to_string(::getpid());
    descriptor_ = ::open(temporary_path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  }
  if (descriptor_ < 0) {
    throw InputError(path_, std::string("cannot be written (") + std::strerror(errno) +
                                "); choose a folder that exists and may be written");
  }
  if (!in_place) remember_unfinished(temporary_path_);
  buffer_.reserve(kBufferBytes);
}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  discard_temporary();
}

void OutputFile::discard_temporary() {
  if (temporary_path_.empty()) return;
  ::unlink(temporary_path_.c_str());
  forget_unfinished(temporary_path_);
}

void OutputFile::write(const void* bytes, std::size_t size) {
  const char* data = static_cast<const char*>(bytes);
  if (buffer_.size() + size > kBufferBytes) flush();
  buffer_.insert(buffer_.end(), data, data + size);
}

void OutputFile::flush() {
  std::size_t done = 0;
  while (done < buffer_.size()) {
    const ssize_t written = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      throw InputError(
          path_, std::string("write failed (") + std::strerror(errno) + "); is the disk full?");
    }
    done += static_cast<std::size_t>(written);
  }
  buffer_.clear();
}

void OutputFile::commit() {
  flush();
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  const bool in_place = temporary_path_.empty();
  const bool named =
      closed == 0 && (in_place || std::rename(temporary_path_.c_str(), path_.c_str()) == 0);
  const int error = errno;
  if (named && !in_place) forget_unfinished(temporary_path_);
  if (named) return;
  discard_temporary();
  throw InputError(path_, std::string("cannot be written (") + std::strerror(error) + ")");
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::string remedy = "); name a folder that can be written";
  if (error) throw InputError(folder, "cannot be made (" + error.message() + remedy);
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    throw InputError(folder, std::string("cannot be written (") + std::strerror(errno) + remedy);
  }
}

void write_file(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

std::string read_file(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    throw InputError(path,
                     std::string("cannot be read (") + std::strerror(errno) + "); check the name");
  }
  std::string text;
  std::array<char, 65536> chunk;
  for (;;) {
    const ssize_t got = ::read(descriptor, chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      const int error = errno;
      ::close(descriptor);
      throw InputError(path, error == EISDIR
                                 ? std::string("is a directory; name a file")
                                 : std::string("cannot be read (") + std::strerror(error) + ")");
    }
    if (got == 0) break;
    text.append(chunk.data(), static_cast<std::size_t>(got));
  }
  ::close(descriptor);
  return text;
}

}  // namespace fogcomp
