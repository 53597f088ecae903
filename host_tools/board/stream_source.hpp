#pragma once

#include <memory>
#include <string>

#include "board/sensor_stream.hpp"
#include "recording/input_file.hpp"
#include "recording/recording.hpp"

namespace fogcomp::board {

/// Bytes of the sensor stream for a file: a captured stream as it is, damage and all; a CSV as the
/// board would have seen it.
class StreamSource {
 public:
  /// Reads a CSV whole (its errors come from here, also for a column that `needs` names and it
  /// lacks); only opens a capture, which has what it has. A pipe will do for either.
  StreamSource(const std::string& path, const recording::ReadOptions& options, double scale_factor,
               fog::InputMask needs);

  bool is_capture() const { return capture_ != nullptr; }
  /// Of a CSV.
  double period_s() const { return recording_.period_s; }
  std::size_t rows() const { return recording_.rows(); }
  const std::vector<double>& time_s() const { return recording_.time_s; }

  /// Once: a pipe cannot be read again.
  void send(const TimedByteSink& sink);

 private:
  double scale_factor_;
  fog::InputMask extension_;
  recording::ReadWatch watch_;
  std::unique_ptr<recording::InputFile> capture_;  ///< nothing for a CSV
  recording::Recording recording_;
};

}  // namespace fogcomp::board
