#pragma once

#include <memory>
#include <string>

#include "board/sensor_stream.hpp"
#include "recording/input_file.hpp"
#include "recording/recording.hpp"

namespace fogcomp::board {

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
