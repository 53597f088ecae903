#pragma once

#include <Eigen/Core>
#include <vector>

namespace fogcomp::noise {

/// Mean power of the quiet parts over bands of frequency, relative to white noise.
struct QuietSpectrum {
  Eigen::ArrayXd angle;  ///< per row, 0..pi
  Eigen::ArrayXd power;
  Eigen::ArrayXd count;  ///< of the periodogram's values in each band

  /// Whittle's, but for a constant; `density`: at each angle, relative to white noise.
  double log_likelihood(const Eigen::ArrayXd& density) const {
    return -(count * (density.log() + power / density)).sum();
  }
};

/// Noise of a row: white, plus first-order Gauss-Markov components that stand for flicker and slow
/// wander. Spectra of such components an octave or two apart add up to 1/f.
struct NoiseModel {
  struct Component {
    double tau_s = 0;
    double variance = 0;  ///< (deg/h)^2
  };
  double row_s = 0;
  double white_variance = 0;  ///< of a full row, (deg/h)^2
  std::vector<Component> components;
  /// How well the level of slow noise is known: as many independent values as a variance from them.
  double degrees_of_freedom = 1000;
  QuietSpectrum quiet_spectrum;   ///< empty without quiet parts
  bool from_quiet_parts = false;  ///< else from neighbouring rows alone: white, a lower bound

  /// A random walk of the bias beside all that, of a coefficient in deg/h/sqrt(h). Hours of it are
  /// hardly seen in a soak, so that it can only be said how likely each coefficient is.
  struct Walk {
    double coefficient = 0;
    double log_odds = 0;  ///< ln of the odds against none, by the quiet parts
  };
  std::vector<Walk> walks;  ///< in rising order; every one that matters over the longest run

  double white_dph() const;
  double wander_dph() const;  ///< of all components together
  /// Spectral density of all components together, relative to that of the white noise; `angle`: per
  /// row, 0..pi.
  double slow_density(double angle) const;
};

/// Rows without a gap, and the first frequency of their periodogram that holds noise alone.
struct NoiseSample {
  Eigen::VectorXd values;
  std::size_t first_frequency =
      3;  ///< by default, what removing a straight line spoils is left out
};
/// Of stretches of a residual, parted where it jumps.
std::vector<NoiseSample> noise_samples(const std::vector<Eigen::VectorXd>& stretches);

/// Fits the model to stretches of a residual in which only noise is left (soaks that have settled),
/// by Whittle's likelihood over all of them: each stretch's straight line is removed first, with
/// the one or two lowest frequencies that it spoils. White noise and flicker come first, then what
/// differs from them at single time constants (four times apart, from two rows on); variances
/// follow multiplicative updates (non-negative, never overshoot; Fevotte, Bertin & Durrieu 2009 for
/// this divergence). Flicker goes on, as it does in every gyro, at time constants longer than any
/// stretch, up to `run_s`: what it does over hours must not be taken for an effect.
NoiseModel fit_noise(const std::vector<NoiseSample>& samples, double row_s, double run_s);

/// For data without quiet stretches: white noise from second differences of neighbouring rows.
/// `run_s`: length of the longest recording.
NoiseModel white_noise_of(const Eigen::VectorXd& residual, double row_s, double run_s);

}  // namespace fogcomp::noise
