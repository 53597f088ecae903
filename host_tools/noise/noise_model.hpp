#pragma once

#include <Eigen/Core>
#include <vector>

namespace fogcomp::noise {

/// Mean power of the quiet parts over bands of frequency, relative to white noise.
struct QuietSpectrum {
  Eigen::ArrayXd angle;  ///< per row, 0..pi
  Eigen::ArrayXd power;
  Eigen::ArrayXd count;  ///< periodogram values per band

  /// Whittle's log-likelihood up to a constant; `density`: at each angle, relative to white noise.
  double log_likelihood(const Eigen::ArrayXd& density) const {
    return -(count * (density.log() + power / density)).sum();
  }
};

/// Noise of a row: white, plus first-order Gauss-Markov components that approximate flicker and
/// slow variation. Spectra of components an octave or two apart sum to 1/f.
struct NoiseModel {
  struct Component {
    double tau_s = 0;
    double variance = 0;  ///< (deg/h)^2
  };
  double row_s = 0;
  double white_variance = 0;  ///< of a full row, (deg/h)^2
  std::vector<Component> components;
  /// Uncertainty of the level of slow noise, as degrees of freedom of a variance.
  double degrees_of_freedom = 1000;
  QuietSpectrum quiet_spectrum;   ///< empty without quiet parts
  bool from_quiet_parts = false;  ///< else from neighbouring rows: white, a lower bound

  /// An additional random walk of the bias with a coefficient in deg/h/sqrt(h). Hours of it are
  /// hardly visible in a soak, so only a probability of each coefficient is known.
  struct Walk {
    double coefficient = 0;
    double log_odds = 0;  ///< ln of the odds against no walk, from the quiet parts
  };
  std::vector<Walk> walks;  ///< in rising order; all that are significant over the longest run

  double white_dph() const;
  double wander_dph() const;  ///< rms of all components together
  /// Spectral density of all components together, relative to that of the white noise; `angle`: per
  /// row, 0..pi.
  double slow_density(double angle) const;
};

/// Rows without a gap, and the first frequency of their periodogram with noise alone.
struct NoiseSample {
  Eigen::VectorXd values;
  std::size_t first_frequency =
      3;  ///< default: lower ones are disturbed by removing a straight line
};
/// Samples of a residual, divided at its jumps.
std::vector<NoiseSample> noise_samples(const std::vector<Eigen::VectorXd>& stretches);

/// Fits the model to stretches of a residual that contain only noise (settled soaks), by Whittle's
/// likelihood over all of them. A straight line is removed from each stretch, and the one or two
/// lowest frequencies, which it disturbs, are not used. First white noise and flicker are fitted,
/// then single time constants (four times apart, from two rows on), by multiplicative updates of
/// the variances (non-negative, no overshoot; Fevotte, Bertin & Durrieu 2009 for this divergence).
/// Flicker continues at time constants longer than any stretch, up to `run_s`, as in every gyro:
/// its variation over hours must not be taken for an effect.
NoiseModel fit_noise(const std::vector<NoiseSample>& samples, double row_s, double run_s);

/// For data without quiet stretches: white noise from second differences of neighbouring rows.
/// `run_s`: length of the longest recording.
NoiseModel white_noise_of(const Eigen::VectorXd& residual, double row_s, double run_s);

}  // namespace fogcomp::noise
