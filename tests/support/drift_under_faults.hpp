#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "board/replay.hpp"
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
};

/// Three boards: one with the faults; one without faults or losses; and one without losses, but
/// with the wrong temperatures that the first accepted. The difference between the third and the
/// second is the effect of the temperature error.
class DriftUnderFaults {
 public:
  enum class BoardClock : std::uint8_t { none, crystal };
  explicit DriftUnderFaults(const fogcomp::model::Model& model, double max_degc_per_min = 3,
                            BoardClock board_clock = BoardClock::crystal)
      : table_(fogcomp::board::make_board_table(
            trained_for(without_denoiser(model), max_degc_per_min), {})),
        parameters_(fogcomp::board::read_board_table(table_, "test")),
        max_degc_per_min_(max_degc_per_min),
        board_clock_(board_clock) {}

  DriftVerdict run(const std::vector<Fault>& faults, double duration_s, std::uint64_t seed) const {
    FaultyLine line(faults, seed, max_degc_per_min_);
    Witness truth(parameters_, seed, max_degc_per_min_);
    Witness told(parameters_, seed, max_degc_per_min_);
    Board board(parameters_);
    Clock clock(seed + 2);
    Judge judge;
    while (static_cast<double>(line.time_us()) < duration_s * 1e6) {
      board.be(reset_at(faults, static_cast<double>(line.time_us()) * 1e-6));
      const auto arrivals = line.next();
      if (arrivals.empty()) board.wait();
      for (const FaultyLine::Arrival& arrival : arrivals) {
        const OutputSample out =
            board.process(arrival.sample, clock.at(arrival.time_us, board_clock_));
        const bool believed = !has_any(out.status, Status::temperature_invalid);
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

  // State kept over a reset.
  enum class Reset : std::uint8_t { none, keeps_state, keeps_state_of_unknown_age, forgets };
  static Reset reset_at(const std::vector<Fault>& faults, double time_s) {
    Reset worst = Reset::none;
    for (const Fault& fault : faults) {
      if (time_s < fault.from_s || time_s >= fault.to_s) continue;
      if (fault.kind == Fault::Kind::board_restart) worst = std::max(worst, Reset::keeps_state);
      if (fault.kind == Fault::Kind::pin_reset) {
        worst = std::max(worst, Reset::keeps_state_of_unknown_age);
      }
      if (fault.kind == Fault::Kind::power_cycle) worst = std::max(worst, Reset::forgets);
    }
    return worst;
  }

  // Pipeline and kept state, as in the product's main loop (firmware/app).
  class Board {
   public:
    explicit Board(const ModelParameters& parameters)
        : parameters_(parameters), pipeline_(make_board(parameters)) {}

    void be(Reset reset) {
      if (reset != Reset::none) {
        off_ = std::max(off_, reset);
      } else if (off_ != Reset::none) {
        restart();
      }
    }
    OutputSample process(const SensorSample& sample, SampleTime time) {
      silent_ = 0;
      const OutputSample out = pipeline_->process(sample, time);
      if (block_ended_) size_ = pipeline_->keep(state_.data());
      block_ended_ = pipeline_->ended_block();
      return out;
    }
    /// No sample has come in its time slot.
    void wait() {
      if (off_ == Reset::none && ++silent_ >= 2) size_ = 0;
    }

   private:
    void restart() {
      pipeline_ = make_board(parameters_);
      block_ended_ = false;
      silent_ = 0;
      if (off_ == Reset::forgets) size_ = 0;
      if (size_ > 0) pipeline_->resume(state_.data(), off_ == Reset::keeps_state);
      off_ = Reset::none;
    }

    const ModelParameters& parameters_;
    HostBoard pipeline_;
    std::array<std::uint32_t, fogcomp::board::HostCompensator::kMaxStateWords> state_{};
    std::size_t size_ = 0;
    bool block_ended_ = false;
    int silent_ = 0;
    Reset off_ = Reset::none;
  };

  // It does not affect the drift, and needs most of the time.
  static fogcomp::model::Model without_denoiser(fogcomp::model::Model model) {
    model.denoise.levels = 0;
    return model;
  }
  // A network that is clamped is flagged: here it has been trained for what the coil does.
  static fogcomp::model::Model trained_for(fogcomp::model::Model model, double degc_per_min) {
    for (auto& input : model.network.inputs) {
      if (input.signal == NetworkInput::temperature_rate) input.half_range = 1.5 * degc_per_min;
    }
    return model;
  }
  static HostBoard make_board(const ModelParameters& parameters) {
    return std::make_unique<fogcomp::board::HostCompensator>(parameters,
                                                             IntegrityToken::not_needed());
  }
  static double dph(Rate rate) { return std::ldexp(rate.raw(), -Rate::fractional_bits); }
  static std::int32_t raw(double degc) { return static_cast<std::int32_t>(degc * 65536); }

  // The board's clock: about to wrap; gives the time of reading a sample, not of its arrival.
  class Clock {
   public:
    explicit Clock(std::uint64_t seed) : random_(seed) {}

    SampleTime at(std::int64_t time_us, BoardClock kind) {
      const auto late_ms = static_cast<std::uint32_t>(random_() % 3U);
      since_ms_ = std::max(since_ms_, static_cast<std::uint32_t>(time_us / 1000) + late_ms);
      return {kind == BoardClock::crystal, since_ms_ - 60'000U};
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
    Witness(const ModelParameters& parameters, std::uint64_t seed, double max_degc_per_min)
        : board_(make_board(parameters)), coil_(seed, max_degc_per_min) {}

    /// Runs up to a time. Block temperatures completed in this call may be wrong by this much,
    /// because they are means of few, late samples.
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
  double max_degc_per_min_;
  BoardClock board_clock_;
};

}  // namespace fog::test
