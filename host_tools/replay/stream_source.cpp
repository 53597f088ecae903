#include "replay/stream_source.hpp"

#include "dataset/input_file.hpp"
#include "dataset/stream_reader.hpp"

namespace fogcomp {

StreamSource::StreamSource(const std::string& path, const ReadOptions& options, double scale_factor)
    : path_(path), scale_factor_(scale_factor) {
  InputFile file(path);
  capture_ = is_sensor_stream(file.peek());
  if (!capture_) recording_ = read_recording(path, options);
}

void StreamSource::send(const ByteSink& sink) const {
  if (!capture_) {
    make_sensor_stream(recording_, scale_factor_, sink);
    return;
  }
  InputFile file(path_);
  for (;;) {
    const std::string_view block = file.next_block();
    if (block.empty()) return;
    sink({reinterpret_cast<const std::uint8_t*>(block.data()), block.size()});
  }
}

}  // namespace fogcomp
