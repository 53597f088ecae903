#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "simulation/parameters.hpp"
#include "support/random.hpp"

namespace fogcomp::simulation {

/// Noise of a row, i.e. of the mean over the row's period. Every source has the exact distribution
/// of its block means, so that 10 s rows have the noise of averaging 2000 rows of 200 Hz, at the
/// cost of one row.
class NoiseSource {
 public:
  virtual ~NoiseSource() = default;
  /// Writes the next `rows` values, deg/h.
  virtual void fill(double* values, std::size_t rows) = 0;
};

/// Angle random walk N in deg/sqrt(h): independent rows of standard deviation N / sqrt(period).
class WhiteNoise : public NoiseSource {
 public:
  WhiteNoise(double n_dprh, double period_s, std::uint64_t seed);
  void fill(double* values, std::size_t rows) override;

 private:
  Random random_;
  double sigma_dph_;
};

/// Bias instability B in deg/h: S(f) = B^2 / (2 pi f), two-sided. A sum of first-order Gauss-Markov
/// processes an octave apart, each stationary from the first row and stepped exactly: end value and
/// mean of every period are drawn from their joint distribution. The Allan deviation is flat to 4 %
/// from 30 kShortest_s to a twentieth of kLongest_s (measured), and lower outside.
class FlickerNoise : public NoiseSource {
 public:
  static constexpr double kShortest_s = 0.03125;
  static constexpr double kLongest_s = 1048576;

  FlickerNoise(double b_dph, double period_s, std::uint64_t seed);
  void fill(double* values, std::size_t rows) override;

 private:
  struct Process {
    double value_dph;
    double memory;          ///< fraction of the value left after a period
    double end_sigma_dph;   ///< of the noise added by the end of a period
    double mean_memory;     ///< fraction of the value in the period's mean
    double mean_per_end;    ///< regression of the mean's new part on the end's, in its sigmas
    double mean_sigma_dph;  ///< of the mean's part that is independent of the end
  };
  Random random_;
  std::vector<Process> processes_;
};

/// Rate random walk K in deg/h/sqrt(h), from zero at the first row.
class RandomWalk : public NoiseSource {
 public:
  RandomWalk(double k_dphrh, double period_s, std::uint64_t seed);
  void fill(double* values, std::size_t rows) override;

 private:
  Random random_;
  double sigma_dph_;  ///< of the increment of a period
  double value_dph_ = 0;
};

/// Rate ramp R in deg/h/h, from zero at time 0.
class RateRamp : public NoiseSource {
 public:
  RateRamp(double r_dphh, double period_s);
  void fill(double* values, std::size_t rows) override;

 private:
  double dph_per_row_;
  double row_ = 0;
};

/// Single outliers: at random times, half a second long, of either sign, with exponentially
/// distributed sizes.
class Outliers : public NoiseSource {
 public:
  Outliers(double per_hour, double size_dph, double period_s, std::uint64_t seed);
  void fill(double* values, std::size_t rows) override;

 private:
  void draw_next();

  Random random_;
  double per_second_;
  double size_dph_;
  double period_s_;
  double row_ = 0;
  double start_s_ = 0;
  double height_dph_ = 0;
};

struct NamedNoise {
  std::string name;
  std::unique_ptr<NoiseSource> source;
};

/// The additive sources enabled by the part `noise`, for rows of `period_s`.
std::vector<NamedNoise> make_noise(const Parameters& noise, double period_s, std::uint64_t seed);

/// Angle quantisation Q in deg: the output is the difference of an accumulated angle in whole steps
/// of sqrt(12) Q, divided by the period, so that the error does not accumulate.
class AngleQuantizer {
 public:
  AngleQuantizer(double q_deg, double period_s);
  void apply(double* rate_dph, std::size_t rows);

 private:
  double step_dph_;       ///< one step of angle per period, as a rate
  double remainder_ = 0;  ///< angle not yet output, in steps
};

}  // namespace fogcomp::simulation
