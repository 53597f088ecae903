#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/acquisition/sample_time.hpp"
#include "core/signal/inputs.hpp"
#include "core/signal/span.hpp"
#include "recording/input_file.hpp"
#include "recording/recording.hpp"

namespace fogcomp::board {

/// Receives bytes of a sensor stream and the arrival time of their sample, if known.
using TimedByteSink = std::function<void(fog::Span<const std::uint8_t>, fog::SampleTime)>;
using ByteSink = std::function<void(fog::Span<const std::uint8_t>)>;

/// The sensor stream that a board would have received for a recording: counts by the scale factor,
/// one frame per row, sequence numbers with the gaps of the recording, and before each frame an
/// extension record for every input in `extension`, whose columns the recording must have.
/// Delivered row by row with times; reports progress to `watch`.
void make_sensor_stream(const recording::Recording& recording, double scale_factor,
                        fog::InputMask extension, const TimedByteSink& sink,
                        const recording::ReadWatch& watch = {});

/// Sensor stream of a file: a captured stream unchanged, damage included; a CSV as the board would
/// have received it.
class StreamSource {
 public:
  /// Reads a CSV completely (with its errors, also for a missing column of `needs`); only opens a
  /// capture. Either may be a pipe.
  StreamSource(const std::string& path, const recording::ReadOptions& options, double scale_factor,
               fog::InputMask needs);

  bool is_capture() const { return capture_ != nullptr; }
  /// For a CSV.
  double period_s() const { return recording_.period_s; }
  std::size_t rows() const { return recording_.rows(); }
  const std::vector<double>& time_s() const { return recording_.time_s; }

  /// May be called once: a pipe cannot be read again.
  void send(const TimedByteSink& sink);

 private:
  double scale_factor_;
  fog::InputMask extension_;
  recording::ReadWatch watch_;
  std::unique_ptr<recording::InputFile> capture_;  ///< nothing for a CSV
  recording::Recording recording_;
};

}  // namespace fogcomp::board
