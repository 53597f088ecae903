#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/acquisition/calibration.hpp"
#include "core/acquisition/extension_monitor.hpp"
#include "core/acquisition/sample_monitor.hpp"
#include "core/compensation/drift_model.hpp"
#include "core/denoise/denoiser.hpp"
#include "core/denoise/optional_denoiser.hpp"
#include "core/effects/effect_check.hpp"
#include "core/frames/compact_frame.hpp"
#include "core/frames/delta_angle.hpp"
#include "core/frames/kvh_frame.hpp"
#include "core/frames/output_bytes.hpp"
#include "core/frames/rate_float.hpp"
#include "core/frames/stream_parser.hpp"
#include "core/health/image_seal.hpp"
#include "core/health/integrity_token.hpp"
#include "core/pipeline/block_clock.hpp"
#include "core/pipeline/model_needs.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "core/signal/output_sample.hpp"
#include "core/thermal/block_collector.hpp"

namespace fog {

/// Z rotation of the KVH frames: the rate or, if the header says so, the angle per sample.
template <bool kMayBeAngle>
class Rotation {
 public:
  explicit Rotation(const ModelParameters& /*parameters*/) {}
  void step(Rate /*rate*/) {}
  void stand() {}
  std::uint32_t bits(Rate rate) const { return rate_as_radians_float(rate); }
};
template <>
class Rotation<true> {
 public:
  explicit Rotation(const ModelParameters& parameters)
      : is_angle_((parameters.output_options & kRotationIsAngle) != 0U),
        angle_(parameters.acquisition.sample_period_us) {}
  void step(Rate rate) { angle_.step(rate); }
  void stand() { angle_.stand(); }
  std::uint32_t bits(Rate rate) const {
    return is_angle_ ? angle_.bits() : rate_as_radians_float(rate);
  }

 private:
  bool is_angle_;
  DeltaAngle angle_;
};

/// The whole pipeline: bytes of the sensor stream in, bytes of the output stream out; process()
/// shows the order of the stages. Template parameters limit the model, so that an image contains
/// only what it needs: effects `kEffects`, expressions `kExpressions`, a network of
/// `kNetworkInputs`, filters up to `kTaps` x `kLevels`, frames `kOutput` (with both: any selection)
/// and their options `kOptions`, lines that pass
/// `kLinesError`, a cost that passes `kIsAffordable`.
template <EffectMask kEffects, ExpressionMask kExpressions, NetworkInputMask kNetworkInputs,
          std::size_t kTaps, std::size_t kLevels, OutputSelection kOutput = OutputSelection::both,
          OutputOptions kOptions = kAllOutputOptions, LinesCheck kLinesError = lines_error,
          CostCheck kIsAffordable = is_affordable>
class Compensator {
  using Drift = DriftModel<kEffects, kExpressions, kNetworkInputs>;

 public:
  static constexpr ModelShape capacity{kEffects,
                                       kExpressions,
                                       kNetworkInputs,
                                       filters_of(kTaps),
                                       kLevels,
                                       effect_fits<kEffects>,
                                       expression_check<kExpressions>(),
                                       kOutput,
                                       kOptions,
                                       kLinesError,
                                       kIsAffordable};

  /// `parameters` must have been read with this class's capacity. Parameters of a refused table
  /// make a pipeline that answers every sample and marks none valid. `token`: result of the image
  /// check, used at every sample.
  Compensator(const ModelParameters& parameters, const IntegrityToken& token)
      : fault_(parameters.fault),
        token_(token),
        calibration_(parameters.calibration),
        output_(parameters.output),
        invalidating_(parameters.invalidating),
        rotation_(parameters),
        sends_undelayed_((parameters.output_options & kRotationIsUndelayed) != 0U),
        monitor_(parameters.acquisition),
        extension_monitor_(needs_of(parameters), parameters.acquisition.input_limits,
                           parameters.acquisition.sample_period_us, kConfirmUs),
        block_clock_(parameters.samples_per_block),
        collector_(needs_of(parameters)),
        pending_(needs_of(parameters)),
        drift_model_(parameters.thermal, parameters.effects, parameters.expressions,
                     parameters.network, parameters.policy),
        catch_up_steps_(parameters.catch_up_steps()),
        denoiser_(parameters.denoise) {}

  /// Takes one byte of the sensor stream. If it completes a sample, writes the frames that answer
  /// it to `out` (at least kMaxOutputBytes) and returns their size; else returns 0.
  std::size_t feed(std::uint8_t byte, std::uint8_t* out) {
    return feed(byte, out,
                [](const SensorSample& sample) -> const SensorSample& { return sample; });
  }

  /// The same for a board with data of its own: judges `amend(sample)` at the time `clock()`
  /// (SampleTime).
  template <class Amend, class Clock = NoClock>
  std::size_t feed(std::uint8_t byte, std::uint8_t* out, Amend amend, Clock clock = {}) {
    switch (parser_.feed(byte)) {
      case StreamParser::Found::nothing:
        return 0;
      case StreamParser::Found::extension:
        take(parser_.extension());
        return 0;
      case StreamParser::Found::sample:
        break;
    }
    process(amend(parser_.sample()), clock());
    return encode(last_, out);
  }

  /// Writes frames without a valid rate to `out`, because no sample has come, and returns their
  /// size. Changes nothing else; the elapsed time is accounted for with the next sample.
  std::size_t answer_silence(std::uint8_t* out) {
    begin_answer();
    ++silent_frames_;
    last_.status |= fault_ | Status::no_samples | Status::rate_refused | Status::denoised_refused |
                    status_if(token_.for_status() != kIntactImage, Status::self_test_failed);
    return encode(last_, out);
  }

  /// Takes a value that belongs to the next sample. An impossible value counts as missing. A value
  /// that shows that its predecessors were wrong discards the state built on them.
  void take(const ExtensionRecord& record) {
    const ReadingUse use = extension_monitor_.judge(record);
    if (use == ReadingUse::none) return;
    if (use == ReadingUse::good_new_history) {
      drift_model_.stop();
      collector_.forget(record.input);
      pending_.forget(record.input);
    }
    pending_.add(record.input, record.value);
  }

  /// Result of the latest image check. A rate is valid only if it is recent and equals
  /// kIntactImage. If damaged code sets a frame valid in spite of it, the frame's CRC is wrong.
  IntegrityToken& integrity_token() { return token_; }

  /// Values in the frames written last.
  const OutputSample& last() const { return last_; }

  /// Bytes of the sensor stream that belonged to no good frame, modulo 2^32.
  std::uint32_t discarded_bytes() const { return parser_.discarded_bytes(); }

  /// Samples by which the rate of the KVH frames is late; without such frames, the denoised rate.
  std::uint32_t rate_delay() const {
    return sends_undelayed() ? 0U : static_cast<std::uint32_t>(denoiser_.delay());
  }

  /// Whether a block ended with the last sample, so that keep() has new state.
  bool ended_block() const { return ended_block_; }

  /// Saves the state that a restart of the board must not lose: thermal state, history, time since
  /// power-on. Writes it to `words` (at least kMaxStateWords) and returns the number of words; 0 if
  /// there is no state worth saving.
  std::size_t keep(std::uint32_t* words) {
    if (has_any(last_.status, Status::drift_given_up) || !drift_model_.has_caught_up()) return 0;
    StateCarrier state(StateCarrier::Way::to_words, words);
    carry(state);
    return static_cast<std::size_t>(state.end() - words);
  }
  static constexpr std::size_t kMaxStateWords =
      (sizeof(Drift) + sizeof(BlockClock)) / sizeof(std::uint32_t) + 1;

  /// Continues from `words`, written by keep() for the same model; to be called before the first
  /// sample. The time since then is treated as a gap in the sequence numbers. If it may have been
  /// longer than these can show (`was_short` false), the thermal state starts anew and only the
  /// time since power-on continues.
  void resume(std::uint32_t* words, bool was_short) {
    StateCarrier state(StateCarrier::Way::to_members, words);
    carry(state);
    if (!was_short) drift_model_.stop();
    extension_monitor_.resume(drift_model_.last_block().extension);
  }
  /// The same if a clock has outlasted the reset: `newest` is the arrival time of the newest sample
  /// of `words`, by the clock of the next samples; it gives the length of the gap.
  void resume_after(std::uint32_t* words, SampleTime newest) {
    resume(words, newest.known);
    monitor_.set_newest_time(newest);
  }

  /// Passes one sample, which arrived at `now`, through all stages.
  OutputSample process(const SensorSample& sample, SampleTime now = {}) {
    begin_answer();
    const Rate measured = calibrated_rate(calibration_, sample.rate_counts);
    const SampleMonitor::Verdict verdict = monitor_.judge(sample, measured, now);
    pass_lost_time(verdict);
    const auto temperature = Temperature::from_raw(sample.temperature_q16);
    const bool temperature_good = prepare_drift_model(verdict, temperature, measured);
    drift_model_.update_rate(measured, !has_any(verdict.status, kRateInvalid));

    OutputSample& result = last_;
    result.sequence = sample.sequence;
    result.drift = drift_model_.drift();
    result.status = fault_ | verdict.status | drift_model_.status() | input_missing_ |
                    status_if(!verdict.temperature_confirmed || !extension_monitor_.confirmed(),
                              Status::drift_given_up) |
                    status_if(token_.for_status() != kIntactImage, Status::self_test_failed);
    result.compensated = BoardNumbers::saturating_difference(measured, result.drift);

    // A late sample is answered, but does not advance the time of the stages.
    const bool measured_well = !has_any(result.status, kRateInvalid);
    result.status |= status_if(has_any(result.status, invalidating_), Status::rate_refused);
    if (!verdict.late) {
      denoise(result.compensated, measured_well);
      count_doubtful(measured_well && !result.compensated_valid(), verdict.missing);
      if (temperature_good) last_temperature_ = temperature;
    }
    result.denoised = denoised_.rate;
    result.status |=
        status_if(!denoised_.valid || doubtful_outputs_ > 0, Status::denoised_invalid) |
        status_if(denoiser_.filling(), Status::denoiser_filling);
    result.status |= status_if(has_any(result.status, invalidating_ | Status::denoised_invalid),
                               Status::denoised_refused);
    result.temperature = last_temperature_;
    if (verdict.late) return result;

    extension_monitor_.advance(verdict.missing + 1);
    if (temperature_good) collector_.add_temperature(temperature);
    if (measured_well) collector_.add_rate(result.compensated);
    end_sample();
    return result;
  }

 private:
  using Collector = BlockCollector<Drift::inputs>;

  void carry(StateCarrier& state) {
    drift_model_.carry(state);
    block_clock_.carry(state);
    monitor_.carry(state, drift_model_.last_block().temperature);
  }

  void begin_answer() {
    token_.consume();
    rotation_.stand();
    ended_block_ = false;
  }

  // Collects the extension records and advances the time by one sample.
  void end_sample() {
    collector_.add_extension(pending_);
    pending_.clear();
    finish_blocks(block_clock_.advance(1));
    for (std::uint32_t i = 0; i < catch_up_steps_; ++i) drift_model_.catch_up();
  }

  // A rate that is refused although it was measured well is not replaced in the denoiser. So the
  // denoised rate is not valid from the first such rate until the delay after the last one. Across
  // lost samples it stands for an earlier time than its delay says, until all of the denoiser's
  // samples have come after them. KVH's sequence counts lost samples, so that a driver sees them; a
  // silence has answered some.
  void count_doubtful(bool refused, std::uint32_t missing) {
    if (missing > silent_frames_) frames_ += missing - silent_frames_;
    silent_frames_ = 0;
    if (refused || missing > 0) {
      doubtful_outputs_ = denoiser_.delay() + (refused ? 1 : 0);
    } else if (doubtful_outputs_ > 0) {
      --doubtful_outputs_;
    }
  }

  // Lost samples are elapsed time. It has passed before this sample, whose drift may be an old one.
  void pass_lost_time(const SampleMonitor::Verdict& verdict) {
    finish_blocks(block_clock_.advance(verdict.missing));
    if (verdict.doubtful) drift_model_.unsettle();
  }

  // Returns whether the sample's temperature may be used: without time there is no temperature
  // rate. If necessary starts the model before a block is full, with the sample's values as means.
  bool prepare_drift_model(const SampleMonitor::Verdict& verdict, Temperature temperature,
                           Rate measured) {
    const bool timed = !has_any(verdict.status, Status::sample_rate);
    if (verdict.temperature == ReadingUse::good_new_history || !timed) {
      drift_model_.stop();
      collector_.forget_temperature();
    }
    const bool good = timed && verdict.temperature != ReadingUse::none;
    if (good && !drift_model_.started() && pending_.has_all()) {
      drift_model_.start({temperature, measured, block_clock_.elapsed(), pending_.means()});
    }
    return good;
  }

  // The values collected belong to the first of these blocks, at whose end the clock was elapsed -
  // (blocks - 1). Its drift is valid from the next sample on.
  void finish_blocks(std::uint32_t blocks) {
    if (blocks == 0) return;
    ended_block_ = true;
    input_missing_ = status_if(!collector_.has_inputs(), Status::input_missing);
    if (collector_.has_temperature() && collector_.has_inputs()) {
      const auto later = Elapsed::from_raw(static_cast<std::int32_t>(blocks - 1));
      drift_model_.take(collector_.means(block_clock_.elapsed() - later));
      --blocks;
    }
    collector_.clear();
    if (blocks > 0) drift_model_.hold(blocks);
  }

  void denoise(Rate compensated, bool measured_well) {
    denoised_ = denoiser_.step(compensated, measured_well);
    rotation_.step(sends_undelayed() ? compensated : denoised_.rate);
  }

  // Whether the KVH frames have the undelayed rate.
  bool sends_undelayed() const {
    if constexpr ((kOptions & kRotationIsUndelayed) == 0U) return false;
    return sends_undelayed_;
  }

  bool sends(OutputSelection frame) const {
    if constexpr (kOutput != OutputSelection::both) return kOutput == frame;
    return output_ == frame || output_ == OutputSelection::both;
  }

  std::size_t encode(const OutputSample& sample, std::uint8_t* out) {
    std::size_t size = 0;
    const auto append = [&](const auto& frame) {
      for (const std::uint8_t byte : frame) out[size++] = byte;
    };
    if constexpr (kOutput != OutputSelection::compact) {
      if (sends(OutputSelection::kvh)) {
        const bool undelayed = sends_undelayed();
        append(encode_kvh_frame(sample.temperature,
                                rotation_.bits(undelayed ? sample.compensated : sample.denoised),
                                undelayed ? sample.compensated_valid() : sample.denoised_valid(),
                                frames_, token_.for_frames()));
      }
    }
    if constexpr (kOutput != OutputSelection::kvh) {
      if (sends(OutputSelection::compact)) {
        append(encode_compact_frame(sample, static_cast<std::uint16_t>(denoiser_.delay()),
                                    token_.for_frames()));
      }
    }
    ++frames_;
    return size;
  }

  Status fault_;
  IntegrityToken token_;
  const CalibrationParameters& calibration_;
  OutputSelection output_;
  Status invalidating_;
  Rotation<(kOptions & kRotationIsAngle) != 0U> rotation_;
  bool sends_undelayed_;
  StreamParser parser_;
  SampleMonitor monitor_;
  ExtensionMonitor<Drift::inputs & kAllExtensionInputs> extension_monitor_;
  BlockClock block_clock_;
  Collector collector_;
  typename Collector::Extension pending_;  // received since the last sample
  Status input_missing_ = Status::none;
  Drift drift_model_;
  std::uint32_t catch_up_steps_;
  std::conditional_t<(kTaps > kOrNone), OptionalDenoiser<kTaps % kOrNone, kLevels>,
                     Denoiser<kTaps, kLevels>>
      denoiser_;
  DenoiserOutput denoised_;
  std::size_t doubtful_outputs_ = 0;  // left, of the denoiser
  bool ended_block_ = false;
  Temperature last_temperature_{};
  OutputSample last_;
  std::uint32_t frames_ = 0;         // answers and samples that were lost
  std::uint32_t silent_frames_ = 0;  // since the last sample
};

}  // namespace fog
