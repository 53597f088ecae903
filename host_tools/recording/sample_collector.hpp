#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/acquisition/sequence_monitor.hpp"
#include "core/frames/extension_frame.hpp"
#include "recording/input_file.hpp"
#include "recording/long_recording.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// A sample of a captured stream, to or from a board.
struct CapturedSample {
  std::uint16_t sequence = 0;
  double rate_dph = 0;
  double temperature_degc = 0;
  bool rate_valid = false;
  bool temperature_valid = false;
};

/// Converts the samples of a capture to rows of a Recording, with times from their numbers.
class SampleCollector {
 public:
  /// `frame_bytes`: per sample, to reserve memory. The arguments must outlive this object.
  SampleCollector(const InputFile& file, const ReadOptions& options, std::size_t frame_bytes);

  /// Takes a value that is valid from the next sample until another one comes.
  void add(const fog::ExtensionRecord& record);
  void add(const CapturedSample& sample);

  /// Throws InputError if there was no valid sample. `what`: the kind of stream, for messages.
  Recording finish(std::size_t discarded_bytes, const char* what);

 private:
  bool holds_temperature() const;

  double rate_hz_;
  const ReadWatch& watch_;
  Recording recording_;
  LongRecording long_recording_;
  CaptureCounts counts_;
  fog::SequenceMonitor sequence_;
  bool any_ = false;
  // Number of the sample: starts with its sequence number, then counts the time of the board.
  std::uint64_t number_ = 0;
  std::optional<std::uint64_t> temperature_number_;  // of the sample with the present temperature
  double temperature_degc_ = 0;
  std::array<std::optional<double>, fog::kExtensionInputs> extension_;
};

}  // namespace fogcomp::recording
