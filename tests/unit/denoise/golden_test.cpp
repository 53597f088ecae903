// The offline transform, thresholds and denoising against PyWavelets and numpy
// (tests/golden/wavelet/make_golden.py), to 1e-12.
#include <cmath>
#include <map>

#include "denoise/denoise.hpp"
#include "denoise/filters.hpp"
#include "unit/denoise/golden_file.hpp"
#include "unit/denoise/view.hpp"

namespace fogcomp::denoise {
namespace {

using fog::test::view;

constexpr double kTolerance = 1e-12;

template <class Values>
void expect_near(const Values& values, const std::vector<double>& golden, const std::string& what) {
  ASSERT_EQ(values.size(), golden.size()) << what;
  for (std::size_t i = 0; i < golden.size(); ++i) {
    ASSERT_NEAR(values[i], golden[i], kTolerance) << what << " value " << i;
  }
}

// These tables of PyWavelets are themselves off by more than 1e-12 from the orthonormal filter.
double filter_tolerance(const std::string& name) {
  const std::map<std::string, double> coarse{
      {"sym3", 4e-12}, {"sym5", 2e-12}, {"sym6", 2e-12}, {"sym7", 2e-12}};
  const auto found = coarse.find(name);
  return found == coarse.end() ? kTolerance : found->second;
}

TEST(WaveletGolden, FiltersAreThoseOfPyWavelets) {
  const auto lines = fog::test::golden_lines("filters.txt");
  ASSERT_EQ(lines.size(), wavelet_names().size());
  for (const auto& line : lines) {
    const std::vector<double>& taps = lowpass_filter(line[0]);
    const std::vector<double> golden = fog::test::numbers(line, 1);
    ASSERT_EQ(taps.size(), golden.size()) << line[0];
    for (std::size_t i = 0; i < taps.size(); ++i) {
      ASSERT_NEAR(taps[i], golden[i], filter_tolerance(line[0])) << line[0] << " tap " << i;
    }
  }
}

TEST(WaveletGolden, DecompositionsOfEveryFamilyAndAwkwardLengthAgree) {
  const auto lines = fog::test::golden_lines("decompositions.txt");
  std::size_t cases = 0;
  for (std::size_t at = 0; at < lines.size(); ++cases) {
    const std::vector<std::string> words = lines[at++];
    ASSERT_EQ(words[0], "case");
    const std::string what = words[1] + " " + words[2] + " " + words[3];
    const std::vector<double> signal = fog::test::golden_signal(std::stoul(words[3]));
    const std::vector<double>& taps = lowpass_filter(words[1]);
    const auto extension = words[2] == "symmetric" ? Extension::symmetric : Extension::periodic;
    std::vector<double> again = signal;
    const auto parts =
        decompose({again.data(), again.size()}, taps, std::stoi(words[4]), extension);
    const auto expect_as_stored = [&](fog::Span<double> values) {
      expect_near(std::vector<double>(values.begin(), values.end()),
                  fog::test::numbers(lines[at++], 1), what);
    };
    expect_as_stored(parts.approximation);
    for (const fog::Span<double> detail : parts.details) expect_as_stored(detail);
    reconstruct(parts, taps, {again.data(), again.size()});
    expect_near(again, signal, what + " reconstructed");
  }
  EXPECT_EQ(cases, wavelet_names().size() * 2 * 7);
}

TEST(WaveletGolden, ThresholdRulesAgreeWithFullSorting) {
  const auto lines = fog::test::golden_lines("thresholds.txt");
  std::vector<double> values;
  for (const auto& words : lines) {
    if (words[0] == "case") {
      values = fog::test::golden_signal(std::stoul(words[1]));
      for (double& value : values) value *= 1.7;
      for (std::size_t i = 0; i < values.size(); i += 10) values[i] *= 1 + std::stod(words[2]);
      continue;
    }
    if (words[0] == "noise") {
      EXPECT_NEAR(noise_of(view(values)), std::stod(words[1]), kTolerance);
      continue;
    }
    const double threshold =
        threshold_of(threshold_rule(words[0]), view(values), std::stod(words[1]));
    EXPECT_NEAR(threshold, std::stod(words[2]), kTolerance)
        << words[0] << " of " << values.size() << " values, sigma " << words[1];
  }
}

TEST(WaveletGolden, WholeDenoisingAgrees) {
  const auto lines = fog::test::golden_lines("denoised.txt");
  for (std::size_t at = 0; at < lines.size(); at += 2) {
    const std::vector<std::string>& words = lines[at];
    std::vector<double> values = fog::test::golden_signal(700);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] += 4 * std::sin(static_cast<double>(i) / 60);
    }
    DenoiseMethod method;
    method.wavelet = words[1];
    method.levels = 4;
    method.extension = words[2] == "symmetric" ? Extension::symmetric : Extension::periodic;
    method.rule = threshold_rule(words[3]);
    method.hard = words[4] == "hard";
    method.remove_outliers = false;
    denoise({values.data(), values.size()}, method);
    std::vector<double> every_seventh;
    for (std::size_t i = 0; i < values.size(); i += 7) every_seventh.push_back(values[i]);
    expect_near(every_seventh, fog::test::numbers(lines[at + 1], 1),
                words[1] + " " + words[2] + " " + words[3] + " " + words[4]);
  }
}

}  // namespace
}  // namespace fogcomp::denoise
