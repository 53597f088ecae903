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
#include <fstream>
#include <mutex>
#include <optional>
#include <random>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp {
namespace {

constexpr std::size_t kBufferBytes = 1U << 20U;
constexpr mode_t kNewFileMode = 0644;  // less the umask
constexpr const char* kOwnDescriptors = "/proc/self/fd/";

// Temporary files in use, for the signal handler, which removes them after an interruption. A fixed
// array, because a signal handler may neither lock nor allocate.
constexpr std::size_t kMaxOpenFiles = 16;
constexpr std::size_t kLongestPath = 4096;
std::array<char[kLongestPath], kMaxOpenFiles> unfinished_paths;
std::mutex unfinished_mutex;

void remove_unfinished_files(int signal_number) {
  for (const auto& path : unfinished_paths) {
    if (path[0] != '\0') ::unlink(path);
  }
  std::signal(signal_number, SIG_DFL);
  ::raise(signal_number);
}

// All signals that end a program by default. One that is handled or ignored already (sanitizer,
// nohup) is left as it is.
constexpr int kDeadlySignals[] = {SIGINT,  SIGTERM, SIGHUP,  SIGQUIT, SIGPIPE, SIGALRM, SIGXCPU,
                                  SIGUSR1, SIGUSR2, SIGABRT, SIGBUS,  SIGFPE,  SIGILL,  SIGSEGV};

void install_handlers() {
  for (const int number : kDeadlySignals) {
    struct sigaction before {};
    ::sigaction(number, nullptr, &before);
    if (before.sa_handler == SIG_DFL) std::signal(number, remove_unfinished_files);
  }
}

void remember_unfinished(const std::string& path) {
  const std::lock_guard<std::mutex> lock(unfinished_mutex);
  static const bool handlers_installed = [] {
    install_handlers();
    return true;
  }();
  static_cast<void>(handlers_installed);
  if (path.size() >= kLongestPath) return;
  for (auto& slot : unfinished_paths) {
    if (slot[0] == '\0') {
      std::memcpy(slot + 1, path.c_str() + 1, path.size());
      slot[0] = path[0];  // last, so that the handler never sees an incomplete path
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

// Blocks signals between creating a file and registering it for removal.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t all;
    sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

// N, if the path is one of this process' own descriptors (/dev/stdout leads to /proc/self/fd/1):
// opening it again would overwrite a file from its start.
std::optional<int> own_descriptor(const std::string& path) {
  for (const std::string folder : {kOwnDescriptors, "/dev/fd/"}) {
    if (path.rfind(folder, 0) != 0) continue;
    const auto number = parse_number(path.substr(folder.size()));
    if (number) return static_cast<int>(*number);
  }
  return std::nullopt;
}

// Path that a write to `path` reaches: the target of a symbolic link, even if it does not exist,
// else `path` itself. Throws InputError for circular links.
std::string resolve_links(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr int kMaxLinks = 40;  // as in Linux
  fs::path target = path;
  for (int links = 0; links <= kMaxLinks; ++links) {
    if (own_descriptor(target.string())) return target.string();  // its link is not a path
    std::error_code no_link;
    const fs::path next = fs::read_symlink(target, no_link);
    if (no_link) return target.string();
    target = target.parent_path() / next;  // just `next` if it is absolute
  }
  throw InputError(path, "is a link that leads to itself; name a file");
}

// Canonical path, independent of links and spelling.
std::filesystem::path canonical_place(const std::string& path) {
  std::error_code error;
  const std::filesystem::path place =
      std::filesystem::weakly_canonical(std::filesystem::absolute(resolve_links(path)), error);
  return error ? std::filesystem::path(path) : place;
}

}  // namespace

void require_printable_name(const std::string& path) {
  if (!has_control_character(path)) return;
  throw InputError(path, "has a control character in its name; rename it");
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

OutputFile::OutputFile(std::string path) : path_(std::move(path)), target_(resolve_links(path_)) {
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    throw InputError(path_, "is a directory; name a file to write");
  }
  const std::optional<int> own = own_descriptor(target_);
  if (own) {
    descriptor_ = ::fcntl(*own, F_DUPFD_CLOEXEC, 0);
  } else if (exists && !S_ISREG(status.st_mode)) {
    // A pipe or a device (/dev/null) is written to, not replaced by a file.
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    // Also by its mode, because for root every file is writable.
    constexpr mode_t kAnyoneWrites = S_IWUSR | S_IWGRP | S_IWOTH;
    if (exists && ((status.st_mode & kAnyoneWrites) == 0 || ::access(target_.c_str(), W_OK) != 0)) {
      throw InputError(path_, "is read-only; name another file, or allow writing (chmod u+w)");
    }
    open_temporary();
    if (exists && descriptor_ >= 0) {
      static_cast<void>(::fchmod(descriptor_, status.st_mode & 0777U));
      const bool same_owner = ::fchown(descriptor_, status.st_uid, status.st_gid) == 0;
      static_cast<void>(same_owner);  // only root may change the owner
    }
  }
  if (descriptor_ < 0) {
    throw InputError(path_, std::string("cannot be written (") + std::strerror(errno) +
                                "); choose a folder that exists and may be written");
  }
  buffer_.reserve(kBufferBytes);
}

// Without a name, if the file system and /proc support that: then nothing remains of a process that
// is killed in any way.
void OutputFile::open_temporary() {
  if (::access(kOwnDescriptors, X_OK) == 0) {
    const std::string folder = std::filesystem::path(target_).parent_path().string();
    descriptor_ = ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC,
                         kNewFileMode);
    nameless_ = descriptor_ >= 0;
  }
  if (nameless_) return;
  name_temporary([&](const char* name) {
    descriptor_ = ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kNewFileMode);
    return descriptor_ >= 0;
  });
}

// A name that cannot exist before: `make` creates the file, or fails with EEXIST.
bool OutputFile::name_temporary(const std::function<bool(const char*)>& make) {
  constexpr int kMaxAttempts = 100;
  std::random_device random;
  const SignalsHeld held;
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    const std::string candidate = target_ + format(".part-%08x", random());
    if (make(candidate.c_str())) {
      temporary_path_ = candidate;
      remember_unfinished(temporary_path_);
      return true;
    }
    if (errno != EEXIST) return false;
  }
  return false;
}

// A link cannot replace a file, but a rename can: an unnamed file first gets a temporary name.
bool OutputFile::give_name() {
  if (nameless_) {
    const std::string own = kOwnDescriptors + std::to_string(descriptor_);
    nameless_ = !name_temporary([&](const char* name) {
      return ::linkat(AT_FDCWD, own.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
    });
    if (nameless_) return false;
  }
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0 || temporary_path_.empty()) return closed == 0;  // a pipe has its name already
  if (std::rename(temporary_path_.c_str(), target_.c_str()) != 0) return false;
  forget_unfinished(temporary_path_);
  return true;
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
      throw InputError(path_, std::string("cannot be written (") + std::strerror(errno) +
                                  "); free space there or name another place");
    }
    done += static_cast<std::size_t>(written);
  }
  buffer_.clear();
}

void OutputFile::commit() {
  flush();
  if (give_name()) return;
  const int error = errno;
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

bool file_begins_with(const std::string& path, std::string_view text) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string head(text.size(), '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == text;
}

int open_input(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    throw InputError(path,
                     std::string("cannot be read (") + std::strerror(errno) + "); check the name");
  }
  struct stat status {};
  const bool known = ::fstat(descriptor, &status) == 0;
  struct stat null {};
  const bool is_null = ::stat("/dev/null", &null) == 0 && status.st_rdev == null.st_rdev;
  const bool endless = known && (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) && !is_null &&
                       ::isatty(descriptor) != 1;
  if (known && !S_ISDIR(status.st_mode) && !endless) return descriptor;
  ::close(descriptor);
  throw InputError(path, endless ? "is a device that never ends; name a file"
                                 : "is a directory; name a file in it");
}

std::string read_file(const std::string& path) {
  constexpr std::size_t kMaxBytes = 64U << 20U;
  const int descriptor = open_input(path);
  std::string text;
  std::array<char, 65536> chunk;
  for (;;) {
    const ssize_t got = ::read(descriptor, chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got > 0) text.append(chunk.data(), static_cast<std::size_t>(got));
    if (got > 0 && text.size() <= kMaxBytes) continue;
    const int error = errno;
    ::close(descriptor);
    if (got == 0) return text;
    throw InputError(path, got < 0 ? std::string("cannot be read (") + std::strerror(error) + ")"
                                   : "is larger than 64 MiB; is it the right file?");
  }
}

}  // namespace fogcomp
