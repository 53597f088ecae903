// Recordings of users: text and captured sensor streams.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <string>

#include "fuzzing.hpp"
#include "recording/columns.hpp"
#include "recording/recording.hpp"
#include "support/input_error.hpp"

using fog::test::promise;

namespace {

// A file in memory that can be opened by its name.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("recording", 0)) {}
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
  void hold(const std::uint8_t* data, std::size_t size) const {
    promise(::ftruncate(descriptor_, 0) == 0 &&
                ::pwrite(descriptor_, data, size, 0) == static_cast<ssize_t>(size),
            "memory takes the file");
  }

 private:
  int descriptor_;
};

void check_column(const std::vector<double>& values, std::size_t rows) {
  promise(values.empty() || values.size() == rows, "a column has as many values as rows");
  for (const double value : values) promise(std::isfinite(value), "values are numbers");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const MemoryFile file;
  file.hold(data + 1, size - 1);
  fogcomp::recording::ReadOptions options;
  if ((data[0] & 1U) != 0) options.skip_bad_rows = true;
  if ((data[0] & 2U) != 0) options.scale_factor = 3600 * 1024;
  if ((data[0] & 4U) != 0) options.default_input_rate_dph = 10.6;
  try {
    const fogcomp::recording::Recording recording =
        fogcomp::recording::read_recording(file.path(), options);
    promise(recording.rows() > 0, "a recording has rows");
    promise(recording.temperature_degc.size() == recording.rows() &&
                recording.rate_dph.size() == recording.rows(),
            "a recording has temperature and rate");
    for (const fogcomp::recording::ColumnInfo& info : fogcomp::recording::kColumns) {
      check_column(recording[info.column], recording.rows());
    }
  } catch (const fogcomp::InputError&) {  // a message for the user
  }
  return 0;
}
