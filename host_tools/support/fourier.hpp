#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace fogcomp {

/// Discrete Fourier transform of any number of values, in O(n log n): sum of v[i] e^(-2 pi i k /
/// n).
std::vector<std::complex<double>> fourier(const std::vector<std::complex<double>>& values);

/// |discrete Fourier transform|^2 / n of any number n of values, from frequency 0 to below half a
/// cycle per value: element k is for k cycles in n. The mean of each for white noise is its
/// variance.
std::vector<double> periodogram(const std::vector<double>& values);

/// Orthonormal cosine transform (DCT-II) of every column, of any number of rows: row k is the
/// amplitude of k half cycles. It diagonalises the covariance of white noise and of a random walk
/// about its mean, and nearly that of flicker noise.
Eigen::MatrixXd cosine_transform(const Eigen::Ref<const Eigen::MatrixXd>& columns);

}  // namespace fogcomp
