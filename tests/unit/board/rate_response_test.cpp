// Delay and bandwidth that export states, against the board's denoiser itself; and the table of
// firmware/README.md.
#include "board/delays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/denoise/any_denoiser.hpp"
#include "denoise/filters.hpp"
#include "support/sample_models.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

struct Setting {
  const char* wavelet;
  int levels;
  double sample_rate_hz;
};

// Besides the undelayed rate.
constexpr Setting kUsual[] = {{"haar", 3, 1000}, {"haar", 5, 200}, {"db4", 3, 1000},
                              {"db4", 5, 200},   {"sym8", 3, 200}, {"sym8", 4, 200},
                              {"sym8", 5, 200},  {"sym8", 5, 100}, {"sym8", 6, 1000}};

// A board's denoiser of a gyro with so much noise, with thresholds that do not change.
class BoardDenoiser {
 public:
  explicit BoardDenoiser(const Setting& setting, double noise_dph_rthz = 0.075)
      : table_(table_of(setting, noise_dph_rthz)),
        parameters_(read_board_table(table_, "test")),
        denoiser_(parameters_.denoise),
        sample_rate_hz_(setting.sample_rate_hz) {}

  const fog::ModelParameters& parameters() const { return parameters_; }

  double step(double dph) {
    const auto raw = static_cast<std::int32_t>(std::lround(std::ldexp(dph, kFraction)));
    return std::ldexp(denoiser_.step(fog::Rate::from_raw(raw), true).rate.raw(), -kFraction);
  }

  /// Of a sine of the given number of periods in kSamples: amplitude out / in, with the phase by
  /// which the output is late. Images of other frequencies are left out, as a spectrum shows them.
  std::complex<double> gain(std::size_t periods, double amplitude_dph) {
    std::complex<double> in;
    std::complex<double> out;
    const std::size_t settled = 2 * denoiser_.delay();
    for (std::size_t i = 0; i < settled + kSamples; ++i) {
      const double radians = 2 * M_PI * static_cast<double>(i * periods % kSamples) / kSamples;
      const double dph = amplitude_dph * std::sin(radians);
      const double answer = step(dph);
      if (i < settled) continue;
      in += dph * std::polar(1.0, -radians);
      out += answer * std::polar(1.0, -radians);
    }
    return out / in;
  }
  double hz(std::size_t periods) const {
    return static_cast<double>(periods) * sample_rate_hz_ / kSamples;
  }

  static constexpr std::size_t kSamples = 16384;

 private:
  static constexpr int kFraction = fog::Rate::fractional_bits;

  static BoardTable table_of(const Setting& setting, double noise_dph_rthz) {
    model::Model model = fog::test::paper_like_model();
    model.denoise = {setting.wavelet, setting.levels, fog::ThresholdRule::fixed, false};
    model.noise_dph_rthz = noise_dph_rthz;
    BoardSettings settings;
    settings.sample_rate_hz = setting.sample_rate_hz;
    return make_board_table(model, settings);
  }

  BoardTable table_;
  fog::ModelParameters parameters_;
  fog::Denoiser<fog::kAnyTaps, fog::kMaxLevels> denoiser_;
  double sample_rate_hz_;
};

// Samples by which a step is late.
std::size_t step_delay(BoardDenoiser& board) {
  constexpr double kStepDph = 100;
  for (int i = 0; i < 1000; ++i) board.step(0);
  std::size_t delay = 0;
  while (board.step(kStepDph) < kStepDph / 2) ++delay;
  return delay;
}

// Between the two whole numbers of periods that have the gain between them.
double measured_minus_3db_hz(const Setting& setting) {
  constexpr double kAmplitudeDph = 0.2;
  const auto gain = [&](std::size_t periods) {
    return std::abs(BoardDenoiser(setting).gain(periods, kAmplitudeDph));
  };
  std::size_t below = 1;
  std::size_t above = BoardDenoiser::kSamples >> (setting.levels + 1);
  while (above - below > 1) {
    const std::size_t middle = (below + above) / 2;
    (gain(middle) > M_SQRT1_2 ? below : above) = middle;
  }
  const double share = (gain(below) - M_SQRT1_2) / (gain(below) - gain(above));
  const BoardDenoiser board(setting);
  return board.hz(below) + share * (board.hz(above) - board.hz(below));
}

std::string name_of(const Setting& setting) {
  return format("%s x %d, %g Hz", setting.wavelet, setting.levels, setting.sample_rate_hz);
}

TEST(RateResponse, DelayIsThatOfAStep) {
  for (const Setting& setting : kUsual) {
    BoardDenoiser board(setting);
    const RateResponse said = denoised_response(board.parameters());
    EXPECT_EQ(said.delay_samples, step_delay(board)) << name_of(setting);
    EXPECT_DOUBLE_EQ(said.delay_s * setting.sample_rate_hz,
                     static_cast<double>(said.delay_samples));
  }
}

TEST(RateResponse, BandwidthIsThatOfASmallSine) {
  for (const Setting& setting : kUsual) {
    const RateResponse said = denoised_response(BoardDenoiser(setting).parameters());
    const double measured = measured_minus_3db_hz(setting);
    EXPECT_NEAR(said.minus_3db_hz / measured, 1, 0.002) << name_of(setting);
  }
}

// Several filters may be as late; of each the health record has a tap.
TEST(RateResponse, ToldByHealthRecord_IsThatOfTheTable) {
  for (const std::string& wavelet : denoise::wavelet_names()) {
    for (const int levels : {1, 2, 3, 5, 6, 10}) {
      const BoardDenoiser board({wavelet.c_str(), levels, 200}, 0);
      const RateResponse tables = denoised_response(board.parameters());
      const fog::Span<const std::int32_t> low = board.parameters().denoise.low();
      const auto tap = static_cast<std::uint32_t>(low[low.size / 2]) & 0xFFFF0000U;
      const auto delay = static_cast<std::uint32_t>(tables.delay_samples);
      const RateResponse told = response_told(delay | tap, 0.005);
      EXPECT_EQ(late_text(told), late_text(tables)) << wavelet << " x " << levels;
      EXPECT_NEAR(told.minus_3db_hz / tables.minus_3db_hz, 1, 1e-6);
      const RateResponse other = response_told(delay | (tap ^ 0x40000000U), 0.005);
      EXPECT_TRUE(std::isnan(other.minus_3db_hz)) << wavelet << " x " << levels;
      EXPECT_EQ(other.delay_s, tables.delay_s);
    }
  }
  EXPECT_TRUE(std::isnan(response_told(0, 0.005).minus_3db_hz));
  EXPECT_TRUE(std::isnan(response_told(465, 0.005).minus_3db_hz))
      << "an image that tells no filter";
}

TEST(RateResponse, SineBeyondTheThresholdsPasses) {
  for (const Setting& setting : kUsual) {
    BoardDenoiser board(setting);
    const RateResponse said = denoised_response(board.parameters());
    const auto periods = static_cast<std::size_t>(said.minus_3db_hz / board.hz(1));
    const std::complex<double> gain = board.gain(periods, 1000);
    EXPECT_NEAR(std::abs(gain), 1, 0.005) << name_of(setting);
    const double late =
        2 * M_PI * static_cast<double>(periods * said.delay_samples) / BoardDenoiser::kSamples;
    EXPECT_NEAR(std::abs(gain / std::abs(gain) - std::polar(1.0, -late)), 0, 0.005)
        << name_of(setting);
  }
}

TEST(RateResponse, WithoutThresholdsEverythingPasses) {
  for (const Setting& setting : kUsual) {
    BoardDenoiser board(setting, 0);
    EXPECT_NEAR(std::abs(board.gain(BoardDenoiser::kSamples / 4 + 1, 10)), 1, 1e-5)
        << name_of(setting);
  }
}

TEST(RateResponse, WordsSayWhichRateTheFramesHave) {
  const auto words = [](fog::OutputSelection output, fog::OutputOptions options, int levels) {
    model::Model model = fog::test::paper_like_model();
    model.denoise.levels = levels;
    BoardSettings settings;
    settings.output = output;
    settings.output_options = options;
    const BoardTable table = make_board_table(model, settings);
    return rate_words(read_board_table(table, "test"));
  };
  using fog::OutputSelection;
  const std::string undelayed = "undelayed, with the gyro's own bandwidth";
  const std::string denoised =
      "denoised, 2325 ms late (465 samples), -3 dB at 2.85 Hz for what is below its thresholds";
  EXPECT_EQ(words(OutputSelection::kvh, 0, 5), "KVH frames: " + denoised);
  EXPECT_EQ(words(OutputSelection::both, fog::kRotationIsUndelayed, 5), "KVH frames: " + undelayed);
  EXPECT_EQ(words(OutputSelection::kvh, 0, 0), "KVH frames: " + undelayed);
  EXPECT_EQ(words(OutputSelection::compact, 0, 5),
            "compact frames: " + undelayed + ", and " + denoised);
  EXPECT_EQ(words(OutputSelection::compact, 0, 0), "compact frames: " + undelayed);
}

TEST(RateResponse, LongDelay_InItsOwnUnit) {
  EXPECT_EQ(delay_text(0.0875), "87.5 ms");
  EXPECT_EQ(delay_text(2.325), "2325 ms");
  EXPECT_EQ(delay_text(46.5), "46.5 s");
  EXPECT_EQ(delay_text(4650), "77.5 min");
  EXPECT_EQ(delay_text(46500), "12.9 h");
}

// What is in the table is measured by the tests above. It is made anew from what this one says.
TEST(RateResponse, TableOfTheReadmeIsRight) {
  std::string table =
      "| denoiser | sample rate, Hz | delay, ms | -3 dB, Hz |\n|---|---|---|---|\n"
      "| undelayed | any | 0 | the gyro's own |\n";
  for (const Setting& setting : kUsual) {
    const RateResponse response = denoised_response(BoardDenoiser(setting).parameters());
    table += format("| `%s` x %d | %g | %.4g | %.3g |\n", setting.wavelet, setting.levels,
                    setting.sample_rate_hz, 1e3 * response.delay_s, response.minus_3db_hz);
  }
  std::ifstream file(FOG_SOURCE_DIR "/firmware/README.md");
  std::stringstream readme;
  readme << file.rdbuf();
  EXPECT_NE(readme.str().find(table), std::string::npos) << "it should have\n" << table;
}

}  // namespace
}  // namespace fogcomp::board
