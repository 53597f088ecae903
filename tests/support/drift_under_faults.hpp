#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/compensation/drift_model.hpp"
#include "core/pipeline/model_needs.hpp"
#include "support/board_image.hpp"
#include "support/denoised_judge.hpp"
#include "support/faulty_line.hpp"
#include "support/sample_models.hpp"

namespace fog::test {

/// Drift of a board with a faulty line, compared with a board without faults.
struct DriftVerdict {
  std::uint64_t samples = 0;
  std::uint64_t valid = 0;    ///< undelayed rates
  std::uint64_t trusted = 0;  ///< valid, and no flag is set
  double clean_since_s = 0;   ///< start of the present unbroken series of trusted rates
  double worst_dph = 0;       ///< of trusted ones: drift error beyond that of the temperatures
  double worst_at_s = 0;
  std::uint64_t false_frames = 0;   ///< that do not say what the board has found
  std::uint64_t trusted_wrong = 0;  ///< trusted, though the gyro stands or leaps
  double trusted_wrong_at_s = 0;    ///< the last of them
  std::uint64_t denoised_valid = 0;
  std::uint64_t denoised_wrong = 0;  ///< valid, and not those of the samples that they stand for
  double denoised_wrong_at_s = 0;    ///< the last of them
};

/// What a board is made for.
struct TestedBoard {
  bool has_clock = true;  ///< from a crystal
  double sample_rate_hz = 1e6 / kPeriodUs;
  FrameChoice frames = kFrameChoices[0];
  ImageKind image = ImageKind::generic;
  double turns_dps = 0;          ///< how it is moved
  bool has_reset_clock = false;  ///< that goes on while the board is reset
  /// Trained range, where it is not the model's: the truth is that of the model.
  std::optional<fogcomp::model::Range> trained{};
  /// Part of what the coil and the inputs do, ramps included, that the network and the expressions
  /// of the board's table were trained for: the truth is that of a model trained for all.
  double trained_part = 1;
  /// KVH frames have no flags: a rate that they call valid is trusted.
  bool judged_by_validity = false;
  /// The input beside the temperature that the model needs.
  std::optional<InputCourse> input{};
  /// It does not affect the drift, and needs most of the time. Of generic images.
  fogcomp::model::DenoiseSettings denoise{"sym8", 0, ThresholdRule::fixed, false};
};

/// A board with the faults, and the drift model twice: without faults or losses; and without
/// losses, but with the wrong readings that the board accepted. The difference between the third
/// and the second is the effect of their errors. For models without effects of the input rate.
class DriftUnderFaults {
 public:
  explicit DriftUnderFaults(const fogcomp::model::Model& model, double max_degc_per_min = 3,
                            const TestedBoard& setting = {})
      : table_(fogcomp::board::make_board_table(
            trained_within(trained_in_part(trained_for(denoised(model, setting), max_degc_per_min),
                                           setting.trained_part),
                           setting.trained),
            settings_of(setting))),
        parameters_(fogcomp::board::read_board_table(table_, "test")),
        true_table_(fogcomp::board::make_board_table(
            trained_for(denoised(model, setting), max_degc_per_min), settings_of(setting))),
        true_parameters_(fogcomp::board::read_board_table(true_table_, "test")),
        max_degc_per_min_(max_degc_per_min),
        setting_(setting),
        possible_input_(possible_input(model, setting)),
        period_us_(parameters_.acquisition.sample_period_us) {}

  DriftVerdict run(const std::vector<Fault>& faults, double duration_s, std::uint64_t seed) const {
    FaultyLine line(faults, seed, max_degc_per_min_,
                    {period_us_, setting_.turns_dps, setting_.input});
    Witnesses witnesses(true_parameters_, seed, max_degc_per_min_, setting_.input);
    FaultsInTime resets(faults);
    Board board([this] { return make_image(table_, parameters_, setting_.image); },
                setting_.has_reset_clock);
    Clock clock(seed + 2);
    Judge judge(parameters_, setting_.judged_by_validity);
    DenoisedJudge denoised(parameters_.denoise, setting_.denoise.wavelet);
    while (static_cast<double>(line.time_us()) < duration_s * 1e6) {
      if (board.be(worst_of(resets.at(static_cast<double>(line.time_us()) * 1e-6)))) {
        judge.forget_gyro();
      }
      const std::vector<FaultyLine::Arrival>& arrivals = line.next();
      denoised.begin_sample();
      if (arrivals.empty()) board.wait();
      for (const FaultyLine::Arrival& arrival : arrivals) {
        const std::optional<OutputSample> answer =
            board.process(arrival, clock.at(arrival.time_us, setting_.has_clock));
        if (!answer) denoised.take_damaged();
        if (!answer) continue;
        const OutputSample& out = *answer;
        if (!denoised.take(out)) {
          ++judge.verdict.denoised_wrong;
          judge.verdict.denoised_wrong_at_s = static_cast<double>(arrival.time_us) * 1e-6;
        }
        witnesses.advance_to(arrival.time_us, temperature_error(arrival, out),
                             input_error(arrival));
        judge.take(out, static_cast<double>(arrival.time_us) * 1e-6, witnesses.error_dph(out),
                   witnesses.explained_dph());
        judge.take_gyro(out, arrival,
                        static_cast<double>(arrival.time_us) / static_cast<double>(period_us_));
      }
    }
    judge.end(witnesses.explained_dph());
    judge.verdict.false_frames = board.false_frames();
    judge.verdict.denoised_valid = denoised.valid();
    return judge.verdict;
  }

 private:
  static constexpr double kDphPerLsb = 1.0 / (1U << Rate::fractional_bits);

  // The usual lines, or the fastest where they might not carry the frames.
  static fogcomp::board::BoardSettings settings_of(const TestedBoard& setting) {
    constexpr double kFastHz = 1000;
    fogcomp::board::BoardSettings settings;
    settings.sample_rate_hz = setting.sample_rate_hz;
    settings.output = setting.frames.output;
    settings.output_options = setting.frames.options;
    settings.extension = setting.input.has_value();
    if (setting.judged_by_validity) {
      settings.invalidating |= Status::temperature_clamped | Status::history_unknown;
      // A late sample may be one of a demodulator that has been away, and counts anew.
      if (!setting.has_clock) settings.invalidating |= Status::sequence_gap;
    }
    if (setting.sample_rate_hz > kFastHz) {
      settings.sensor_line = SerialLine(kMaxSensorBaud);
      settings.output_line = SerialLine(kMaxOutputBaud);
    }
    return settings;
  }

  // State kept over a reset.
  enum class Reset : std::uint8_t { none, keeps_state, keeps_state_of_unknown_age, forgets };
  static Reset worst_of(const std::vector<Fault*>& faults) {
    Reset worst = Reset::none;
    for (const Fault* fault : faults) {
      if (fault->kind == Fault::Kind::board_restart) worst = std::max(worst, Reset::keeps_state);
      if (fault->kind == Fault::Kind::pin_reset) {
        worst = std::max(worst, Reset::keeps_state_of_unknown_age);
      }
      if (fault->kind == Fault::Kind::power_cycle) worst = std::max(worst, Reset::forgets);
    }
    return worst;
  }

  // Pipeline and kept state, as in the product's main loop (firmware/app).
  class Board {
   public:
    Board(std::function<std::unique_ptr<BoardImage>()> image, bool has_reset_clock)
        : image_(std::move(image)), pipeline_(image_()), has_reset_clock_(has_reset_clock) {}

    /// Whether it has just been restarted.
    bool be(Reset reset) {
      if (reset != Reset::none) {
        off_ = std::max(off_, reset);
      } else if (off_ != Reset::none) {
        restart();
        return true;
      }
      return false;
    }
    /// Nothing if the bytes of the sample were damaged.
    std::optional<OutputSample> process(const FaultyLine::Arrival& arrival, SampleTime time) {
      const std::optional<OutputSample> out =
          pipeline_->process(arrival.sample, time, arrival.damage, arrival.record);
      if (!out) {
        wait();
        return out;
      }
      silent_ = 0;
      if (block_ended_) {
        size_ = pipeline_->keep(state_.data());
        newest_ = time;
      }
      block_ended_ = pipeline_->ended_block();
      return out;
    }
    std::uint64_t false_frames() const { return false_frames_ + pipeline_->false_frames(); }
    /// No sample has come in its time slot.
    void wait() {
      if (off_ != Reset::none || ++silent_ < 2) return;
      size_ = 0;
      pipeline_->answer_silence();
    }

   private:
    void restart() {
      false_frames_ += pipeline_->false_frames();
      pipeline_ = image_();
      block_ended_ = false;
      silent_ = 0;
      if (off_ == Reset::forgets) size_ = 0;
      if (size_ > 0 && has_reset_clock_ && newest_.known) {
        pipeline_->resume_after(state_.data(), newest_);
      } else if (size_ > 0) {
        pipeline_->resume(state_.data(), off_ == Reset::keeps_state);
      }
      off_ = Reset::none;
    }

    std::function<std::unique_ptr<BoardImage>()> image_;
    std::unique_ptr<BoardImage> pipeline_;
    bool has_reset_clock_;
    SampleTime newest_;  // of the state
    std::array<std::uint32_t, BoardImage::kMaxStateWords> state_{};
    std::uint64_t false_frames_ = 0;
    std::size_t size_ = 0;
    bool block_ended_ = false;
    int silent_ = 0;
    Reset off_ = Reset::none;
  };

  static fogcomp::model::Model denoised(fogcomp::model::Model model, const TestedBoard& setting) {
    model.denoise = setting.denoise;
    return model;
  }
  // A network that is clamped is flagged: here it has been trained for what the coil does.
  static fogcomp::model::Model trained_for(fogcomp::model::Model model, double degc_per_min) {
    for (auto& input : model.network.inputs) {
      if (input.signal == NetworkInput::temperature_rate) input.half_range = 1.5 * degc_per_min;
    }
    return model;
  }
  // The same functions of signals that are clamped earlier.
  static fogcomp::model::Model trained_in_part(fogcomp::model::Model model, double part) {
    if (part == 1) return model;
    const auto narrow = [part](auto& range, double middle, double amplitude) {
      range = {middle - part * amplitude, middle + part * amplitude};
    };
    for (std::size_t i = 0; i < model.network.inputs.size(); ++i) {
      model.network.inputs[i].half_range *= part;
      model.network.hidden.weights.col(static_cast<Eigen::Index>(i)) *= part;
    }
    if (model.rate_range_degc_per_min) {
      narrow(*model.rate_range_degc_per_min, 0, model.rate_range_degc_per_min->max);
    }
    for (fogcomp::model::EffectTerm& term : model.terms) {
      if (!term.expression) continue;
      auto& ranges = term.expression->ranges;
      narrow(ranges[0], kMiddleDegc, kSwingDegc);
      const std::size_t first_input = ranges.size() - kExtensionInputs;
      for (std::size_t i = 0; i < kExtensionInputs; ++i) {
        const InputCourse course{extension_input(i), 1};
        narrow(ranges[first_input + i], course.middle(), course.amplitude());
      }
    }
    return model;
  }
  // Of CoilTemperature.
  static constexpr double kMiddleDegc = 10;
  static constexpr double kSwingDegc = 48;

  static fogcomp::model::Model trained_within(fogcomp::model::Model model,
                                              const std::optional<fogcomp::model::Range>& range) {
    if (range) {
      model.min_degc = range->min;
      model.max_degc = range->max;
    }
    return model;
  }
  // Errors of the readings that the board has believed.
  static std::optional<std::int32_t> temperature_error(const FaultyLine::Arrival& arrival,
                                                       const OutputSample& out) {
    if (has_any(out.status, Status::temperature_invalid)) return std::nullopt;
    return arrival.sample.temperature_q16 - raw(arrival.true_degc);
  }
  // What a board may believe of an input, as firmware/DESIGN.md promises it: the trained range and
  // half of it again; of light, whose logarithm counts, by ratio; of temperatures what there is.
  static fogcomp::model::Range possible_input(const fogcomp::model::Model& model,
                                              const TestedBoard& setting) {
    constexpr double kAnything = 1e9;
    fogcomp::model::Range possible{-kAnything, kAnything};
    if (!setting.input) return possible;
    const auto& trained = model.input_ranges[extension_number(setting.input->input)];
    if (!trained) return possible;
    const fogcomp::model::Range range = trained->range;
    if (setting.input->input == Input::light_power) {
      const double ratio = std::sqrt(range.max / range.min);
      return {range.min / ratio, range.max * ratio};
    }
    const double half = (range.max - range.min) / 2;
    possible = {range.min - half, range.max + half};
    if (setting.input->input != Input::temperature2) return possible;
    return {std::max(possible.min, -70.0), std::min(possible.max, 130.0)};
  }
  // It may have believed whatever is possible; the table's limits are not asked: they may be wrong.
  std::optional<std::int32_t> input_error(const FaultyLine::Arrival& arrival) const {
    if (!arrival.record || arrival.record->other_kind != 0) return std::nullopt;
    const std::int32_t value = arrival.record->record.value.raw();
    constexpr int kRounding = 1;
    if (value < raw(possible_input_.min) - kRounding) return std::nullopt;
    if (value > raw(possible_input_.max) + kRounding) return std::nullopt;
    return value - raw(arrival.true_input);
  }
  static double dph(Rate rate) { return rate.raw() * kDphPerLsb; }
  static std::int32_t raw(double degc) { return static_cast<std::int32_t>(degc * 65536); }

  // The board's clock: about to wrap; gives the time of reading a sample, not of its arrival.
  class Clock {
   public:
    explicit Clock(std::uint64_t seed) : random_(seed) {}

    SampleTime at(std::int64_t time_us, bool has_clock) {
      const auto late_ms = static_cast<std::uint32_t>(random_() % 3U);
      since_ms_ = std::max(since_ms_, static_cast<std::uint32_t>(time_us / 1000) + late_ms);
      return {has_clock, since_ms_ - 60'000U};
    }

   private:
    std::mt19937_64 random_;
    std::uint32_t since_ms_ = 0;
  };

  class Judge {
   public:
    Judge(const ModelParameters& parameters, bool by_validity)
        : by_validity_(by_validity),
          period_s_(parameters.acquisition.sample_period_us * 1e-6),
          stuck_samples_(2 * parameters.acquisition.stuck.samples),
          largest_step_dph_(
              std::ldexp(parameters.acquisition.rate.step.raw(), -RateStep::fractional_bits)),
          dph_per_count_(3600 / paper_like_model().scale_factor) {}

    /// A rate must not be trusted after counts that have been equal, but for a whisper, for as long
    /// as the table says: twice that, because the whisper's first extreme begins the count anew.
    /// Nor if it is a leap from a trusted one beyond the table's largest step for each sample since
    /// then. `at` counts sample periods.
    void take_gyro(const OutputSample& out, const FaultyLine::Arrival& arrival, double at) {
      const std::int32_t counts = arrival.sample.rate_counts;
      constexpr std::int64_t kWhisper = 60;  // of both signs: within the smallest stuck band
      const bool alike = std::abs(std::int64_t{counts} - first_alike_) <= kWhisper;
      if (!alike || !arrival.gyro_stands) alike_ = 0;
      if (alike_++ == 0) first_alike_ = counts;
      const double leap_dph =
          static_cast<double>(std::abs(std::int64_t{counts} - last_counts_)) * dph_per_count_;
      const bool leaps =
          trusted_last_ &&
          leap_dph > largest_step_dph_ * std::max(1.0, std::round(at - last_at_)) + kRoundingDph;
      // One that comes again was measured when it came first.
      if (arrival.sample.sequence != last_sequence_) last_at_ = at;
      last_sequence_ = arrival.sample.sequence;
      trusted_last_ = is_trusted(out);
      last_counts_ = counts;
      if (!trusted_last_ || (!leaps && alike_ <= stuck_samples_)) return;
      ++verdict.trusted_wrong;
      verdict.trusted_wrong_at_s = at * period_s_;
    }
    /// The board has.
    void forget_gyro() {
      alike_ = 0;
      trusted_last_ = false;
    }

    /// The board's blocks end at other times than the witness's: what explains an error may come a
    /// little later.
    void take(const OutputSample& out, double time_s, double error_dph, double explained_dph) {
      const bool trusted = is_trusted(out);
      ++verdict.samples;
      verdict.valid += out.compensated_valid();
      verdict.trusted += trusted;
      if (trusted && !trusted_before_) verdict.clean_since_s = time_s;
      trusted_before_ = trusted;
      if (trusted && error_dph - explained_dph > verdict.worst_dph) {
        suspects_.push_back({time_s, error_dph, explained_dph});
      }
      while (!suspects_.empty() && suspects_.front().time_s < time_s - kLongestBlocksS) {
        judge_suspect(explained_dph);
      }
    }
    void end(double explained_dph) {
      while (!suspects_.empty()) judge_suspect(explained_dph);
    }
    DriftVerdict verdict;

   private:
    static constexpr double kRoundingDph = 0.01;
    static constexpr double kLongestBlocksS = 2;

    bool is_trusted(const OutputSample& out) const {
      constexpr Status kOfDenoised =
          Status::denoised_invalid | Status::denoised_refused | Status::denoiser_filling;
      return out.compensated_valid() && (by_validity_ || !has_any(out.status, ~kOfDenoised));
    }

    struct Suspect {
      double time_s;
      double error_dph;
      double explained_dph;  // at that time
    };
    void judge_suspect(double explained_dph) {
      const Suspect suspect = suspects_.front();
      suspects_.pop_front();
      const double beyond_dph = suspect.error_dph - std::max(suspect.explained_dph, explained_dph);
      if (beyond_dph <= verdict.worst_dph) return;
      verdict.worst_dph = beyond_dph;
      verdict.worst_at_s = suspect.time_s;
    }

    bool by_validity_;
    std::deque<Suspect> suspects_;

    bool trusted_before_ = false;
    bool trusted_last_ = false;
    std::int32_t last_counts_ = 0;
    double last_at_ = 0;
    std::uint16_t last_sequence_ = 0;
    std::int32_t first_alike_ = 0;
    std::uint32_t alike_ = 0;  // counts in a row
    double period_s_;
    std::uint32_t stuck_samples_;
    double largest_step_dph_;
    double dph_per_count_;
  };

  // The drift model alone: it takes any temperatures, where a board might refuse some.
  class Witness {
   public:
    explicit Witness(const ModelParameters& parameters)
        : model_(parameters.thermal, parameters.effects, parameters.expressions, parameters.network,
                 parameters.policy),
          collector_(needs_of(parameters)) {}

    /// A temperature that is not believed counts where a block has no other.
    void take(Temperature temperature, bool believed, const std::optional<ExtensionRecord>& input,
              Elapsed elapsed, bool ends_block) {
      if (std::exchange(stepped_, false)) before_ = drift_;
      drift_ = model_.drift();
      BlockMeans<BoardNumbers> now{temperature, Rate{}, elapsed};
      if (input) {
        Collector::Extension values(bit_of(input->input));
        values.add(input->input, input->value);
        collector_.add_extension(values);
        now[input->input] = input->value;
      }
      if (!model_.started()) model_.start(now);
      if (believed || (ends_block && !collector_.has_temperature())) {
        collector_.add_temperature(temperature);
      }
      if (!ends_block) return;
      model_.step(collector_.means(elapsed));
      collector_.clear();
      stepped_ = true;
    }
    /// Of the temperature taken last, and of the block before.
    Rate drift() const { return drift_; }
    Rate drift_before() const { return before_; }

   private:
    using Model = DriftModel<kAllEffects, kAnyModel.expressions, kAnyModel.network_inputs>;
    using Collector = BlockCollector<Model::inputs>;

    Model model_;
    Collector collector_;
    Rate drift_{};
    Rate before_{};
    bool stepped_ = false;
  };

  // Two of them on a line without faults, of which one is told wrong temperatures, for blocks that
  // begin at the same time.
  struct WitnessPair {
    WitnessPair(const ModelParameters& parameters, std::uint32_t begun_samples)
        : truth(parameters), told(parameters), blocks(parameters.samples_per_block) {
      blocks.advance(begun_samples);
    }
    double explained_dph() const { return std::abs(dph(told.drift()) - dph(truth.drift())); }

    Witness truth;
    Witness told;
    BlockClock blocks;
  };

  // Nobody knows where a board's blocks begin after lost samples or a restart: a wrong temperature
  // may be all of one, or half of two. So there are pairs for several beginnings.
  class Witnesses {
   public:
    Witnesses(const ModelParameters& parameters, std::uint64_t seed, double max_degc_per_min,
              const std::optional<InputCourse>& input)
        : coil_(seed, max_degc_per_min),
          input_(input),
          period_us_(parameters.acquisition.sample_period_us),
          longest_bridge_us_(period_us_ * parameters.samples_per_block *
                             parameters.policy.hold_blocks),
          settle_blocks_(std::max(1, static_cast<int>(parameters.policy.settle_blocks))) {
      for (std::uint32_t i = 0; i < kBeginnings; ++i) {
        pairs_.emplace_back(parameters, parameters.samples_per_block * i / kBeginnings);
      }
    }

    /// Runs up to a time. Block means completed in this call may be wrong by this much, because
    /// they are means of few, late readings. Nothing: the board has not believed it.
    void advance_to(std::int64_t time_us, std::optional<std::int32_t> temperature_error,
                    std::optional<std::int32_t> input_error) {
      const Believed input_before = std::exchange(input_read_, largest(time_us, input_error));
      for (; sample_ * period_us_ <= time_us; ++sample_) {
        const std::int64_t now_us = sample_ * period_us_;
        const bool last = now_us > time_us - kSecondUs;
        const double time_s = static_cast<double>(now_us) * 1e-6;
        const double degc = coil_.at(time_s);
        take({raw(degc),
              last && temperature_error ? *temperature_error : held_error(temperature_, now_us)},
             !last || temperature_error.has_value(),
             {input_ ? raw(input_->at(time_s, degc)) : 0,
              held_error(last ? input_read_ : input_before, now_us)});
      }
      if (temperature_error) temperature_ = {time_us, *temperature_error};
      for (const WitnessPair& pair : pairs_) {
        explained_dph_ = std::max(explained_dph_, pair.explained_dph());
      }
    }
    /// Error that wrong temperatures explain, or have explained while a model settles: a board that
    /// refused some, or started anew, forgets them earlier or later than the witness that took all.
    double explained_dph() const { return std::max(explained_dph_, explained_before_dph_); }
    /// Error beyond what the true drift changes in a block: a board whose blocks begin elsewhere,
    /// as after lost samples of a demodulator that counts anew, is that much ahead or behind.
    double error_dph(const OutputSample& out) const {
      const Witness& truth = pairs_.front().truth;
      const double truth_dph = dph(truth.drift());
      return std::abs(dph(out.drift) - truth_dph) - std::abs(truth_dph - dph(truth.drift_before()));
    }

   private:
    static constexpr std::uint32_t kBeginnings = 4;

    struct Reading {
      std::int32_t right;
      std::int32_t error;
    };
    // The error of a reading that was believed then.
    struct Believed {
      std::int64_t at_us = 0;
      std::int32_t error = 0;
    };

    void take(Reading temperature, bool believed, Reading input) {
      const auto record = [&](std::int32_t error) -> std::optional<ExtensionRecord> {
        if (!input_) return std::nullopt;
        return ExtensionRecord{input_->input, ExtensionValue::from_raw(input.right + error)};
      };
      for (WitnessPair& pair : pairs_) {
        const bool ends_block = pair.blocks.advance(1) > 0;
        const Elapsed elapsed = pair.blocks.elapsed();
        pair.truth.take(Temperature::from_raw(temperature.right), true, record(0), elapsed,
                        ends_block);
        pair.told.take(Temperature::from_raw(temperature.right + temperature.error), believed,
                       record(input.error), elapsed, ends_block);
        if (&pair == &pairs_.front() && ends_block && elapsed.raw() % settle_blocks_ == 0) {
          explained_before_dph_ = std::exchange(explained_dph_, 0);
        }
      }
    }
    // Of the errors of an input in two blocks: a board refuses what comes before and after a leap
    // until it is confirmed, so that a block may have none but the wrong values.
    Believed largest(std::int64_t time_us, std::optional<std::int32_t> error) const {
      constexpr std::int64_t kBlocksUs = 2 * kSecondUs;
      if (!error) return input_read_;
      const bool larger = std::abs(*error) >= std::abs(input_read_.error);
      return larger || time_us - input_read_.at_us > kBlocksUs ? Believed{time_us, *error}
                                                               : input_read_;
    }
    // A board bridges what it has not believed, or has missed, from the last reading that it
    // believed, error included; beyond the longest bridge it starts anew.
    std::int32_t held_error(const Believed& before, std::int64_t now_us) const {
      return now_us - before.at_us <= longest_bridge_us_ ? before.error : 0;
    }

    std::deque<WitnessPair> pairs_;
    CoilTemperature coil_;
    std::optional<InputCourse> input_;
    std::int64_t period_us_;
    std::int64_t sample_ = 0;
    std::int64_t longest_bridge_us_;
    Believed temperature_;
    Believed input_read_;
    int settle_blocks_;
    double explained_dph_ = 0;         // most, since the model has settled last
    double explained_before_dph_ = 0;  // ... in the time that it took before
  };

  fogcomp::board::BoardTable table_;
  ModelParameters parameters_;
  fogcomp::board::BoardTable true_table_;
  ModelParameters true_parameters_;
  double max_degc_per_min_;
  TestedBoard setting_;
  fogcomp::model::Range possible_input_;
  std::int64_t period_us_;
};

}  // namespace fog::test
