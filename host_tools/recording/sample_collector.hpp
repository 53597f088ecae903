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

/// A sample of a captured stream, sent to a board or by one.
struct CapturedSample {
  std::uint16_t sequence = 0;
  double rate_dph = 0;
  double temperature_degc = 0;
  bool rate_valid = false;
  bool temperature_valid = false;
};

/// Turns the samples of a capture into rows of a Recording, whose time is their number.
class SampleCollector {
 public:
  /// `frame_bytes`: of a sample, to make room for those of a file. Those given must outlive this.
  SampleCollector(const InputFile& file, const ReadOptions& options, std::size_t frame_bytes);

  /// A value that belongs to the next sample and holds until another one comes.
  void add(const fog::ExtensionRecord& record);
  void add(const CapturedSample& sample);

  /// Throws InputError where there was no sample, or none that is valid. `what`: the kind of
  /// stream, for messages.
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
  // Of the sample. The first has its sequence number; from there on it counts the time of the
  // board.
  std::uint64_t number_ = 0;
  std::optional<std::uint64_t> temperature_number_;  // of the sample whose temperature stands
  double temperature_degc_ = 0;
  std::array<std::optional<double>, fog::kExtensionInputs> extension_;
};

}  // namespace fogcomp::recording
