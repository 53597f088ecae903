#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "board/replay.hpp"
#include "support/faulty_line.hpp"
#include "support/sample_models.hpp"

namespace fog::test {

/// What a board made of a faulty line, held against one that nothing happened to.
struct DriftVerdict {
  std::uint64_t samples = 0;
  std::uint64_t valid = 0;    ///< undelayed rates
  std::uint64_t trusted = 0;  ///< valid, and no flag is set
  double clean_since_s = 0;   ///< of the last trusted ones, without a break
  double worst_dph = 0;       ///< of trusted ones: drift error beyond what the temperatures explain
  double worst_at_s = 0;
};

/// Three boards: one with the faults; one that had neither fault nor loss; and one that had no
/// loss, but was told the same wrong temperatures, where the first believed them. What the third
/// differs by from the second is what the temperature's error explains.
class DriftUnderFaults {
 public:
  explicit DriftUnderFaults(const fogcomp::model::Model& model, double most_degc_per_min = 3)
      : table_(fogcomp::board::make_board_table(without_denoiser(model), {})),
        parameters_(fogcomp::board::read_board_table(table_, "test")),
        most_degc_per_min_(most_degc_per_min) {}

  DriftVerdict run(const std::vector<Fault>& faults, double duration_s, std::uint64_t seed) const {
    FaultyLine line(faults, seed, most_degc_per_min_);
    Witness truth(parameters_, seed, most_degc_per_min_);
    Witness told(parameters_, seed, most_degc_per_min_);
    HostBoard board = make_board(parameters_);
    Clock clock(seed + 2);
    Judge judge;
    std::int64_t before_us = 0;
    while (static_cast<double>(line.time_us()) < duration_s * 1e6) {
      for (const FaultyLine::Arrival& arrival : line.next()) {
        if (starts_anew(faults, before_us, arrival.time_us)) board = make_board(parameters_);
        before_us = arrival.time_us;
        const OutputSample out = board->process(arrival.sample, clock.at(arrival.time_us));
        const bool believed = !any(out.status, Status::temperature_invalid);
        truth.advance_to(arrival.time_us, 0);
        told.advance_to(arrival.time_us,
                        believed ? arrival.sample.temperature_q16 - raw(arrival.true_degc) : 0);
        const double explained = std::abs(told.drift_dph() - truth.drift_dph());
        judge.take(out, static_cast<double>(arrival.time_us) * 1e-6,
                   std::abs(dph(out.drift) - truth.drift_dph()) - explained);
      }
    }
    return judge.verdict;
  }

 private:
  using HostBoard = std::unique_ptr<fogcomp::board::HostCompensator>;

  // Whether the board's power came back between two times.
  static bool starts_anew(const std::vector<Fault>& faults, std::int64_t from_us,
                          std::int64_t to_us) {
    return std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) {
      const auto back_us = static_cast<std::int64_t>(fault.to_s * 1e6);
      return fault.kind == Fault::Kind::power_cycle && from_us < back_us && back_us <= to_us;
    });
  }
  // It has no part in the drift, and costs most of the time.
  static fogcomp::model::Model without_denoiser(fogcomp::model::Model model) {
    model.denoise.levels = 0;
    return model;
  }
  static HostBoard make_board(const ModelParameters& parameters) {
    return std::make_unique<fogcomp::board::HostCompensator>(parameters, ImageProof::not_needed());
  }
  static double dph(Rate rate) { return std::ldexp(rate.raw(), -Rate::fractional_bits); }
  static std::int32_t raw(double degc) { return static_cast<std::int32_t>(degc * 65536); }

  // The board's: it is about to wrap, and says when a sample was read, not when it came.
  class Clock {
   public:
    explicit Clock(std::uint64_t seed) : random_(seed) {}

    SampleTime at(std::int64_t time_us) {
      const auto late_ms = static_cast<std::uint32_t>(random_() % 3U);
      since_ms_ = std::max(since_ms_, static_cast<std::uint32_t>(time_us / 1000) + late_ms);
      return {true, since_ms_ - 60'000U};
    }

   private:
    std::mt19937_64 random_;
    std::uint32_t since_ms_ = 0;
  };

  struct Judge {
    void take(const OutputSample& out, double time_s, double error_dph) {
      const bool trusted = out.compensated_valid() && out.status == Status::none;
      ++verdict.samples;
      verdict.valid += out.compensated_valid();
      verdict.trusted += trusted;
      if (trusted && !trusted_before) verdict.clean_since_s = time_s;
      trusted_before = trusted;
      if (!trusted || error_dph <= verdict.worst_dph) return;
      verdict.worst_dph = error_dph;
      verdict.worst_at_s = time_s;
    }
    DriftVerdict verdict;
    bool trusted_before = false;
  };

  // A board on a line without faults.
  class Witness {
   public:
    Witness(const ModelParameters& parameters, std::uint64_t seed, double most_degc_per_min)
        : board_(make_board(parameters)), coil_(seed, most_degc_per_min) {}

    /// Up to a time; temperatures of the last block, if they come with this call, are wrong by so
    /// much: a mean of few samples, and late, is of those.
    void advance_to(std::int64_t time_us, std::int32_t error_q16) {
      while (sample_ * kPeriodUs <= time_us) {
        const bool last = sample_ * kPeriodUs > time_us - kSecondUs;
        const double degc = coil_.at(static_cast<double>(sample_ * kPeriodUs) * 1e-6);
        SensorSample sample{static_cast<std::uint16_t>(sample_),
                            static_cast<std::int32_t>(sample_ * 37 % 101), raw(degc), true, true};
        if (last) sample.temperature_q16 += error_q16;
        drift_dph_ = dph(board_->process(sample).drift);
        ++sample_;
      }
    }
    double drift_dph() const { return drift_dph_; }

   private:
    HostBoard board_;
    CoilTemperature coil_;
    std::int64_t sample_ = 0;
    double drift_dph_ = 0;
  };

  fogcomp::board::BoardTable table_;
  ModelParameters parameters_;
  double most_degc_per_min_;
};

}  // namespace fog::test
