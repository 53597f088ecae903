#include "batch/fingerprint.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::batch {
namespace {

constexpr std::uint64_t kPrime = 0x100000001b3;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

void Fingerprint::add_bytes(std::string_view bytes) {
  std::uint64_t hash = hash_;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * kPrime;
  hash_ = hash;
}

void Fingerprint::add(std::string_view word) {
  add_bytes(format("%zu:", word.size()));
  add_bytes(word);
}

void Fingerprint::add_file(const std::string& path) {
  add(std::filesystem::path(path).filename().string());
  // In pieces: a recording may be larger than the memory.
  const std::unique_ptr<std::FILE, CloseFile> file(::fdopen(open_input(path), "rb"));
  std::array<char, 65536> piece;
  std::size_t size = 0;
  while (file && (size = std::fread(piece.data(), 1, piece.size(), file.get())) > 0) {
    add_bytes({piece.data(), size});
  }
  if (!file || std::ferror(file.get()) != 0) {
    throw InputError(path, std::string("cannot be read (") + std::strerror(errno) + ")");
  }
}

std::string Fingerprint::text() const {
  return format("%016llx", static_cast<unsigned long long>(hash_));
}

}  // namespace fogcomp::batch
