// SPEC.md, "Model table", word by word: a table written by hand. Every word is read to its place
// and refused one beyond its limits.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/pipeline/model_needs.hpp"
#include "core/pipeline/model_parameters.hpp"
#include "core/pipeline/sample_cost.hpp"

namespace {

using fog::ModelError;
using fog::ModelParameters;

constexpr std::int32_t kOneDegree = 65536;
constexpr std::int32_t kHalf = 1 << 30;
constexpr std::int32_t kSynthesisHalf = 1 << 14;
constexpr auto kInvalidating =
    static_cast<std::int32_t>(fog::kRateInvalid | fog::Status::thermal_settling);

std::int32_t halves(std::int32_t upper, std::int32_t lower) {
  return static_cast<std::int32_t>((static_cast<std::uint32_t>(upper) << 16U) |
                                   (static_cast<std::uint32_t>(lower) & 0xFFFFU));
}

/// Words with names. read() adds their number and the CRC.
class Table {
 public:
  Table& put(const std::string& name, std::int32_t value) {
    at_[name] = words_.size();
    words_.push_back(value);
    return *this;
  }
  std::int32_t& operator[](const std::string& name) { return words_.at(at_.at(name)); }
  void insert(std::size_t at) { words_.insert(words_.begin() + static_cast<int>(at), 0); }
  void erase(std::size_t at) { words_.erase(words_.begin() + static_cast<int>(at)); }
  std::size_t size() const { return words_.size(); }

  ModelError read(ModelParameters& parameters, const fog::ModelShape& capacity = fog::kAnyModel) {
    words_[2] = static_cast<std::int32_t>(words_.size());
    const fog::Span<const std::int32_t> table{words_.data(), words_.size()};
    words_.back() = static_cast<std::int32_t>(fog::model_table_crc(table));
    return fog::read_model(table, capacity, parameters);
  }
  ModelError read(const fog::ModelShape& capacity = fog::kAnyModel) {
    ModelParameters parameters;
    return read(parameters, capacity);
  }

 private:
  std::vector<std::int32_t> words_;
  std::map<std::string, std::size_t> at_;
};

void put_input(Table& table, const std::string& name, std::int32_t signal, std::int32_t decay) {
  table.put(name + " signal", signal).put(name + " decay", decay).put(name + " centre", 7 + decay);
  table.put(name + " reach", 1000 + decay).put(name + " shift", 3 + signal);
}

// What stands behind the frames.
void put_end(Table& table) {
  table.put("invalidating", kInvalidating);
  table.put("sensor line", 921600).put("output line", 921600).put("crc", 0);
}

// What stands before the effects.
Table table_begun() {
  Table table;
  table.put("magic", 0x464F474D)
      .put("layout", fog::kModelLayout)
      .put("words", 0)
      .put("model", 0x11223344);
  table.put("serial 0", 0x2D474F46).put("serial 1", 0x31).put("serial 2", 0).put("serial 3", 0);
  table.put("processor 0", 7).put("processor 1", 8).put("processor 2", 9);
  table.put("period", 5000)
      .put("part", 50)
      .put("block", 200)
      .put("multiplier", kHalf + 1)
      .put("shift", 30);
  table.put("range", 1 << 20).put("step", 77).put("stuck", 100).put("band", 9);
  table.put("decay", 1001).put("gain", 2002);
  table.put("min", -40 * kOneDegree)
      .put("max", 60 * kOneDegree)
      .put("hold", 61)
      .put("accurate", 31)
      .put("settle", 121);
  table.put("input limits", 1).put("input min", -7).put("input max", 8).put("input step", 9);
  table.put("fraction", 21);
  return table;
}

// bias, a network of T and of T through a lag with one neuron or more, Haar's filter on one level.
Table good_table(std::int32_t neurons = 1) {
  Table table = table_begun();
  table.put("effects", 1);
  table.put("id", 0).put("constants", 0).put("coefficients", 1).put("coefficient", 12345);
  table.put("expressions", 0).put("program", 0);
  table.put("inputs", 2).put("neurons", neurons);
  put_input(table, "T", 0, 0);
  put_input(table, "lagged", 2, 55);
  table.put("hidden shift", 1).put("output shift", 2);
  for (std::int32_t i = 0; i < neurons; ++i) {
    table.put("bias", 10).put("weight 0", 20).put("weight 1", 30).put("weight 2", 0);
    table.put("weight 3", 0).put("output weight", 50);
  }
  table.put("output bias", 60).put("linear", 0).put("centre", 70).put("amplitude", 80);
  table.put("levels", 1).put("taps", 2).put("rule", 0).put("mode", 0);
  table.put("low 0", kHalf).put("low 1", kHalf);
  table.put("synthesis 0", halves(-kSynthesisHalf, kSynthesisHalf));
  table.put("synthesis 1", halves(kSynthesisHalf, kSynthesisHalf));
  table.put("threshold", 655).put("output", 2);
  put_end(table);
  return table;
}

TEST(ModelLimits, EveryWordArrivesWhereItBelongs) {
  Table table = good_table();
  table["linear"] = table["mode"] = 1;
  table["rule"] = 2;
  ModelParameters got;
  ASSERT_EQ(table.read(got), ModelError::none);
  EXPECT_EQ(got.fault, fog::Status::none);
  EXPECT_EQ(got.provenance, 0x11223344U);
  EXPECT_EQ(got.acquisition.sample_period_us, 5000U);
  EXPECT_EQ(got.samples_per_block, 200U);
  EXPECT_EQ(got.calibration.multiplier, kHalf + 1);
  EXPECT_EQ(got.calibration.shift, 30);
  EXPECT_EQ(got.acquisition.rate.range.raw(), 1 << 20);
  EXPECT_EQ(got.acquisition.rate.step.raw(), 77);
  EXPECT_EQ(got.acquisition.sample_rate_part, 50U);
  EXPECT_EQ(got.acquisition.stuck.samples, 100U);
  EXPECT_EQ(got.acquisition.stuck.band, 9U);
  EXPECT_EQ(got.thermal.derivative.decay.raw(), 1001);
  EXPECT_EQ(got.thermal.derivative.rate_gain.raw(), 2002);
  EXPECT_EQ(got.thermal.min.raw(), -40 * kOneDegree);
  EXPECT_EQ(got.thermal.max.raw(), 60 * kOneDegree);
  EXPECT_EQ(got.policy.hold_blocks, 61U);
  EXPECT_EQ(got.policy.accurate_blocks, 31U);
  EXPECT_EQ(got.policy.settle_blocks, 121U);
  ASSERT_EQ(got.acquisition.input_limits.size, 3U);
  EXPECT_EQ(got.acquisition.input_limits[0], -7);
  EXPECT_EQ(got.acquisition.input_limits[2], 9);
  EXPECT_EQ(got.effects.coefficient_fraction, 21);
  EXPECT_EQ(got.effects.enabled(), 1U);
  ASSERT_EQ(got.effects.by_id[0].coefficients.size, 1U);
  EXPECT_EQ(got.effects.by_id[0].coefficients[0], 12345);
  EXPECT_EQ(got.expressions.program.size, 0U);
  ASSERT_EQ(got.network.input_count, 2U);
  const fog::InputScaling& lagged = got.network.inputs[1];
  EXPECT_EQ(got.network.inputs[0].signal, fog::NetworkInput::temperature);
  EXPECT_EQ(lagged.signal, fog::NetworkInput::lagged_temperature);
  EXPECT_EQ(lagged.decay.raw(), 55);
  EXPECT_EQ(lagged.centre, 62);
  EXPECT_EQ(lagged.half_range, 1055);
  EXPECT_EQ(lagged.shift, 5);
  EXPECT_EQ(got.network.hidden_shift, 1);
  EXPECT_EQ(got.network.output_shift, 2);
  ASSERT_EQ(got.network.neurons.size, 6U);
  EXPECT_EQ(got.network.neurons[5], 50);
  EXPECT_EQ(got.network.output_bias, 60);
  EXPECT_TRUE(got.network.linear_output);
  EXPECT_EQ(got.network.centre.raw(), 70);
  EXPECT_EQ(got.network.amplitude.raw(), 80);
  EXPECT_EQ(got.denoise.rule, fog::ThresholdRule::heursure);
  EXPECT_EQ(got.denoise.mode, fog::ThresholdMode::hard);
  EXPECT_EQ(got.denoise.taps(), 2U);
  ASSERT_EQ(got.denoise.levels(), 1U);
  EXPECT_EQ(got.denoise.thresholds[0], 655);
  EXPECT_EQ(got.output, fog::OutputSelection::both);
  EXPECT_EQ(got.invalidating, fog::kRateInvalid | fog::Status::thermal_settling);
}

TEST(ModelLimits, ATableIsForAnyProcessorOrForOne) {
  const std::int32_t any[] = {0, 0, 0};
  EXPECT_FALSE(fog::is_bound_elsewhere(any, {0, 0, 0}));
  EXPECT_FALSE(fog::is_bound_elsewhere(any, {7, 8, 9}));
  const std::int32_t one[] = {7, -8, 9};
  EXPECT_FALSE(fog::is_bound_elsewhere(one, {7, static_cast<std::uint32_t>(-8), 9}));
  for (std::size_t i = 0; i < 96; ++i) {
    std::array<std::uint32_t, 3> other{7, static_cast<std::uint32_t>(-8), 9};
    other[i / 32] ^= 1U << (i % 32);
    EXPECT_TRUE(fog::is_bound_elsewhere(one, other)) << i;
  }
  EXPECT_TRUE(fog::is_bound_elsewhere(one, {0, 0, 0})) << "a processor that says no number";
}

TEST(ModelLimits, ASerialNumberEnds) {
  Table table = good_table();
  table["serial 3"] = 0x00FFFFFF;
  EXPECT_EQ(table.read(), ModelError::none);
  table["serial 3"] = 0x01000000;
  EXPECT_EQ(table.read(), ModelError::out_of_range);
  table["serial 3"] = INT32_MIN;
  EXPECT_EQ(table.read(), ModelError::out_of_range);
}

// Without a usable model a board answers silence at its fastest rate.
TEST(ModelLimits, ABoardWithoutAModelHasASamplePeriodThatALineTakes) {
  EXPECT_GE(ModelParameters().acquisition.sample_period_us, 1000U);
  EXPECT_EQ(ModelParameters().output_line().word(), fog::SerialLine().word());
}

TEST(ModelLimits, TheUsualFlagsAlwaysMakeARateNotValidAndOthersMayBeChosen) {
  const auto usual = static_cast<std::uint32_t>(fog::kRateInvalid);
  const auto chosen = static_cast<std::uint32_t>(fog::kMayInvalidate);
  for (unsigned bit = 0; bit < 32; ++bit) {
    Table table = good_table();
    const std::uint32_t flag = 1U << bit;
    table["invalidating"] = static_cast<std::int32_t>(usual & ~flag);
    EXPECT_EQ(table.read() == ModelError::none, (usual & flag) == 0) << bit;
    table["invalidating"] = static_cast<std::int32_t>(usual | flag);
    EXPECT_EQ(table.read() == ModelError::none, ((usual | chosen) & flag) != 0) << bit;
  }
}

TEST(ModelLimits, EveryNumberIsAcceptedUpToItsLimitsAndRefusedBeyond) {
  const struct {
    const char* name;
    std::int32_t min, max;
  } limits[] = {
      {"block", 1, INT32_MAX},
      {"multiplier", kHalf, INT32_MAX},
      {"shift", 0, 62},
      {"range", 1, INT32_MAX},
      {"step", 1, INT32_MAX},
      {"part", 1, 1000},
      {"stuck", 0, INT32_MAX},
      {"band", 0, INT32_MAX},
      {"decay", 1, INT32_MAX},
      {"gain", 1, INT32_MAX},
      {"min", -70 * kOneDegree, 60 * kOneDegree},
      {"max", -40 * kOneDegree, 130 * kOneDegree},
      {"hold", 0, INT32_MAX},
      {"accurate", 0, INT32_MAX},
      {"settle", 0, INT32_MAX},
      {"fraction", 10, 40},
      {"T decay", 0, 0},
      {"lagged decay", 1, INT32_MAX},
      {"T reach", 1, INT32_MAX >> 3},
      {"T shift", 0, 21},  // 1000 * 2^21 is the last below 2^31
      {"hidden shift", 0, 16},
      {"output shift", 0, 16},
      {"weight 2", 0, 0},  // of no input
      {"weight 3", 0, 0},
      {"linear", 0, 1},
      {"rule", 0, 2},
      {"mode", 0, 1},
      {"threshold", 0, (32766 << 15) - 1},  // what 16 bits of noise can hold at the largest shift
      {"output", 0, 2},
  };
  for (const auto& limit : limits) {
    const auto read_with = [&](std::int32_t value) {
      Table table = good_table();
      table[limit.name] = value;
      return table.read();
    };
    EXPECT_EQ(read_with(limit.min), ModelError::none) << limit.name;
    EXPECT_EQ(read_with(limit.max), ModelError::none) << limit.name;
    if (limit.min > INT32_MIN) {
      EXPECT_EQ(read_with(limit.min - 1), ModelError::out_of_range) << limit.name;
    }
    if (limit.max < INT32_MAX) {
      EXPECT_EQ(read_with(limit.max + 1), ModelError::out_of_range) << limit.name;
    }
  }
  Table table = good_table();
  table["T reach"] = 1;
  table["T shift"] = 30;
  EXPECT_EQ(table.read(), ModelError::none);
  table["T reach"] = INT32_MAX;
  table["T shift"] = 0;
  EXPECT_EQ(table.read(), ModelError::none);
}

// At 921600 Bd ten bits take 10.85 us.
TEST(ModelLimits, Period_ShorterThanItsFrames_Refused) {
  const struct {
    std::int32_t output;
    std::int32_t shortest_us;
  } frames[] = {{0, 391}, {1, 304}, {2, 695}};
  for (const auto& each : frames) {
    Table table = good_table();
    table["output"] = each.output;
    for (const std::int32_t period_us : {each.shortest_us, INT32_MAX}) {
      table["period"] = period_us;
      EXPECT_EQ(table.read(), ModelError::none) << each.output;
    }
    for (const std::int32_t period_us : {1, 200, each.shortest_us - 1}) {
      table["period"] = period_us;
      EXPECT_EQ(table.read(), ModelError::frames_too_long) << each.output;
    }
    for (const std::int32_t period_us : {0, -1, INT32_MIN}) {
      table["period"] = period_us;
      EXPECT_EQ(table.read(), ModelError::out_of_range) << each.output;
    }
  }
}

// 9600 to 2,000,000 Bd in and 4,147,200 out; formats 8N1, 8N2, 8E1, 8E2, 8O1, 8O2.
TEST(ModelLimits, Line_BeyondItsRatesAndFormats_Refused) {
  const struct {
    const char* name;
    std::int32_t fastest;
  } lines[] = {{"sensor line", 2'000'000}, {"output line", 4'147'200}};
  for (const auto& line : lines) {
    for (std::int32_t format = 0; format < 8; ++format) {
      Table table = good_table();
      table["period"] = 1'000'000;
      for (const std::int32_t baud : {9'600, line.fastest}) {
        table[line.name] = baud + (format << 24);
        EXPECT_EQ(table.read(), format < 6 ? ModelError::none : ModelError::out_of_range)
            << line.name << " " << baud << " " << format;
      }
      for (const std::int32_t baud : {0, 9'599, line.fastest + 1}) {
        table[line.name] = baud + (format << 24);
        EXPECT_EQ(table.read(), ModelError::out_of_range) << line.name << " " << baud;
      }
    }
    Table table = good_table();
    table[line.name] = INT32_MIN | 921600;
    EXPECT_EQ(table.read(), ModelError::out_of_range) << line.name;
  }
}

TEST(SerialLine, FormatsAndTimes_AsTheirWordSays) {
  const fog::SerialLine odd(9'600 + (5 << 24));
  EXPECT_TRUE(odd.has_odd_parity());
  EXPECT_FALSE(fog::SerialLine(9'600 + (3 << 24)).has_odd_parity());
  EXPECT_EQ(odd.us_of(36), 45'000U);
  EXPECT_EQ(fog::SerialLine().us_of(36), 391U) << "rounded up";
}

fog::ModelShape at_any_cost() {
  fog::ModelShape shape = fog::kAnyModel;
  shape.is_affordable = fog::was_affordable;
  return shape;
}

// 36, 28 and 64 bytes: of 12 bits at 9600 Bd, of 10 at 4,147,200 Bd.
TEST(ModelLimits, Period_OnAnotherLine_ShortestThatCarriesItsFrames) {
  const struct {
    std::int32_t line;
    std::int32_t shortest_us[3];
  } cases[] = {{9'600 + (5 << 24), {45'000, 35'000, 80'000}}, {4'147'200, {87, 68, 155}}};
  for (const auto& each : cases) {
    for (std::int32_t output = 0; output < 3; ++output) {
      Table table = good_table();
      table["output line"] = each.line;
      table["output"] = output;
      table["period"] = each.shortest_us[output];
      EXPECT_EQ(table.read(at_any_cost()), ModelError::none) << each.line << " " << output;
      --table["period"];
      EXPECT_EQ(table.read(at_any_cost()), ModelError::frames_too_long)
          << each.line << " " << output;
    }
  }
}

// An image whose header has the usual lines decides as any other does.
TEST(ModelLimits, UsualLines_CheckOfTheirOwn_Agrees) {
  fog::ModelShape usual = fog::kAnyModel;
  usual.lines_error = fog::usual_lines_error<fog::OutputSelection::both>;
  for (const std::int32_t period_us : {694, 695, 5000}) {
    Table table = good_table();
    table["period"] = period_us;
    EXPECT_EQ(table.read(usual), table.read()) << period_us;
    for (const char* line : {"sensor line", "output line"}) {
      Table other = table;
      other[line] = 921'601;
      EXPECT_EQ(other.read(usual), ModelError::not_in_image) << line;
    }
  }
}

// Cost by SPEC.md, "Cost of a sample". 70 instructions pass in 1 us.
struct Costly {
  const char* what;
  Table table;
  std::int32_t cost;
};

// A program of so many sines, which are one word each. Behind it are no network and no denoiser.
Table table_of_sines(std::int32_t sines) {
  Table table = table_begun();
  table.put("effects", 0).put("expressions", 1).put("factor", 5).put("program", sines + 4);
  table.put("signal", 0).put("least", INT32_MIN).put("most", INT32_MAX);
  for (std::int32_t i = 0; i < sines; ++i) table.put("sine " + std::to_string(i), 14 + (16 << 8));
  table.put("result", 20);
  for (const char* name : {"inputs", "neurons", "levels", "taps", "rule", "mode"}) {
    table.put(name, 0);
  }
  table.put("output", 1);
  put_end(table);
  return table;
}

std::vector<Costly> costly_tables() {
  constexpr std::int32_t kAlways = 4600;
  constexpr std::int32_t kHaar = 180 + 10 * 2;
  constexpr std::int32_t kStep = 400 + 800 + 2 * 100 + 6 * 6;
  constexpr std::int32_t kKeep = 3400;
  const auto amended = [](const char* name, std::int32_t value, std::int32_t neurons = 1) {
    Table table = good_table(neurons);
    table[name] = value;
    return table;
  };
  return {
      {"a step is less than keeping", amended("block", 62), kAlways + kHaar + kKeep},
      {"2 steps are less", amended("block", 61), kAlways + kHaar + kKeep},
      {"3 steps of a hold", amended("block", 30), kAlways + kHaar + 3 * kStep},
      {"a block a sample", amended("block", 1), kAlways + kHaar + 62 * kStep + kKeep},
      {"needs light", amended("T signal", 7), kAlways + kHaar + kKeep + 1300},
      {"32 neurons, 3 steps", amended("block", 30, 32), kAlways + kHaar + 3 * (kStep + 31 * 36)},
      {"64 steps at most",
       [&] {
         Table table = amended("block", 2);
         table["hold"] = INT32_MAX;
         return table;
       }(),
       kAlways + kHaar + 64 * kStep},
      {"sines", table_of_sines(100), kAlways + 400 + 104 * 100 + 100 * 100},
  };
}

TEST(ModelLimits, Period_ShorterThanTwiceItsCost_Refused) {
  for (Costly& each : costly_tables()) {
    each.table["output line"] = 4'147'200;
    each.table["output"] = 1;
    each.table["period"] = (each.cost + 69) / 70;
    ModelParameters got;
    EXPECT_EQ(each.table.read(got), ModelError::none) << each.what;
    EXPECT_EQ(fog::sample_cost(got), static_cast<std::uint32_t>(each.cost)) << each.what;
    --each.table["period"];
    EXPECT_EQ(each.table.read(), ModelError::sample_too_dear) << each.what;
  }
}

TEST(ModelLimits, DearTable_ImageOfItsOwn_IsTheExportersConcern) {
  Table table = table_of_sines(100);
  table["period"] = 304;  // what its frames take
  EXPECT_EQ(table.read(at_any_cost()), ModelError::none);
  EXPECT_EQ(table.read(), ModelError::sample_too_dear);
}

TEST(ModelLimits, SignalsOfTheNetworkAreTheInputsAndTheLaggedTemperature) {
  constexpr auto kSignals = static_cast<std::int32_t>(fog::kInputs) + 1;
  for (std::int32_t signal = -1; signal <= kSignals; ++signal) {
    Table table = good_table();
    table["T signal"] = signal;
    table["T decay"] = signal == 2 ? 1 : 0;
    ModelParameters got;
    EXPECT_EQ(table.read(got),
              signal >= 0 && signal < kSignals ? ModelError::none : ModelError::out_of_range)
        << signal;
    const bool beside = signal > 2 && signal < kSignals;
    const fog::InputMask needs =
        beside ? fog::bit_of(static_cast<fog::Input>(signal - 1)) : fog::InputMask{0};
    EXPECT_EQ(needs_of(got), needs) << signal;
  }
}

TEST(ModelLimits, ANetworkHasUpTo32NeuronsAndNoneWithoutInputs) {
  EXPECT_EQ(good_table(32).read(), ModelError::none);
  EXPECT_EQ(good_table(33).read(), ModelError::out_of_range);
  Table table = good_table();
  table["inputs"] = 5;
  EXPECT_EQ(table.read(), ModelError::out_of_range);
  Table without = table_begun();
  without.put("effects", 0).put("expressions", 0).put("program", 0).put("inputs", 0);
  without.put("neurons", 0).put("levels", 0).put("taps", 0).put("rule", 0).put("mode", 0);
  without.put("output", 1);
  put_end(without);
  ModelParameters got;
  ASSERT_EQ(without.read(got), ModelError::none);
  EXPECT_FALSE(got.network.present());
  EXPECT_EQ(got.denoise.levels(), 0U);
  EXPECT_EQ(got.output, fog::OutputSelection::compact);
}

TEST(ModelLimits, SumsOfANeuronAndOfTheOutputCannotOverflow) {
  const auto read_with = [](std::int32_t weight0, std::int32_t weight1, std::int32_t bias) {
    Table table = good_table();
    table["weight 0"] = weight0;
    table["weight 1"] = weight1;
    table["bias"] = bias;
    return table.read();
  };
  EXPECT_EQ(read_with(INT32_MAX, -INT32_MAX, 0), ModelError::none);  // 2^32 - 2
  EXPECT_EQ(read_with(INT32_MAX, INT32_MIN, 0), ModelError::out_of_range);
  EXPECT_EQ(read_with(INT32_MAX, INT32_MAX, -1), ModelError::out_of_range);
  EXPECT_EQ(read_with(INT32_MAX, 1, -kHalf + 1), ModelError::none);
  EXPECT_EQ(read_with(INT32_MAX, 1, kHalf), ModelError::out_of_range);
  for (const std::int32_t sign : {1, -1}) {
    Table table = good_table();
    table["output weight"] = sign * INT32_MAX;
    table["output bias"] = sign * (kHalf - 1);
    EXPECT_EQ(table.read(), ModelError::none);
    table["output bias"] = sign * kHalf;
    EXPECT_EQ(table.read(), ModelError::out_of_range);
  }
}

TEST(ModelLimits, AnEffectComesOnceWithItsOwnConstantsAndCoefficients) {
  for (const char* name : {"constants", "coefficients", "effects"}) {
    for (const std::int32_t off : {-1, 1}) {
      Table table = good_table();
      table[name] += off;
      EXPECT_EQ(table.read(), ModelError::out_of_range) << name << off;
    }
  }
  Table twice = table_begun();
  twice.put("effects", 2);
  for (const std::int32_t id : {0, 2}) {  // bias and the temperature's rate, one coefficient each
    twice.put("id " + std::to_string(id), id).put("constants", 0).put("coefficients", 1);
    twice.put("coefficient", 1);
  }
  for (const char* name : {"expressions", "program", "inputs", "neurons", "levels", "taps", "rule",
                           "mode", "output"}) {
    twice.put(name, 0);
  }
  put_end(twice);
  ModelParameters got;
  ASSERT_EQ(twice.read(got), ModelError::none);
  EXPECT_EQ(got.effects.enabled(), 0x5U);
  twice["id 2"] = 0;
  EXPECT_EQ(twice.read(), ModelError::out_of_range);
  twice["id 2"] = fog::kMaxEffects - 1;  // no effect has this number
  EXPECT_EQ(twice.read(), ModelError::out_of_range);
}

TEST(ModelLimits, LevelsAndTapsComeTogetherAndTapsInPairs) {
  for (const auto& [levels, taps] : {std::pair{0, 2}, {1, 0}, {11, 2}, {1, 3}, {1, 32}}) {
    Table table = good_table();
    table["levels"] = levels;
    table["taps"] = taps;
    EXPECT_EQ(table.read(), ModelError::out_of_range) << levels << " " << taps;
  }
}

// If any word is left out or inserted, the sections no longer end at the table's end, or a value is
// out of range. Words that contain only numbers shift the others all the same.
TEST(ModelLimits, ATableIsExactlyAsLongAsItsSections) {
  Table longer = good_table();
  longer.insert(longer.size() - 1);
  EXPECT_EQ(longer.read(), ModelError::out_of_range);
  Table shorter = good_table();
  shorter.erase(shorter.size() - 2);
  EXPECT_EQ(shorter.read(), ModelError::out_of_range);
  for (std::size_t at = good_table().size() - 1; at > 4; --at) {
    Table cut = good_table();
    while (cut.size() > at) cut.erase(cut.size() - 2);
    EXPECT_EQ(cut.read(), ModelError::out_of_range) << at;
  }
  for (const std::size_t size : {std::size_t{4}, fog::kMaxModelWords + 1}) {
    Table table = good_table();
    while (table.size() > size) table.erase(table.size() - 2);
    while (table.size() < size) table.insert(table.size() - 1);
    EXPECT_EQ(table.read(), ModelError::not_a_model) << size;
  }
  Table longest = good_table();
  while (longest.size() < fog::kMaxModelWords) longest.insert(longest.size() - 1);
  EXPECT_EQ(longest.read(), ModelError::out_of_range);
}

TEST(ModelLimits, ARefusedTableLeavesParametersOfABoardWithoutAModel) {
  Table table = good_table();
  ModelParameters parameters;
  ASSERT_EQ(table.read(parameters), ModelError::none);
  table["output"] = 3;
  ASSERT_EQ(table.read(parameters), ModelError::out_of_range);
  EXPECT_EQ(parameters.fault, fog::Status::model_refused);
  EXPECT_EQ(parameters.effects.enabled(), 0U);
  EXPECT_EQ(parameters.denoise.levels(), 0U);
  EXPECT_FALSE(parameters.network.present());
}

TEST(ModelLimits, OptionThatTheImageLacks_Refused) {
  fog::ModelShape plain = fog::kAnyModel;
  plain.output_options = 0;
  Table table = good_table();
  EXPECT_EQ(table.read(plain), ModelError::none);
  table["output"] |= fog::kRotationIsAngle;
  EXPECT_EQ(table.read(), ModelError::none);
  EXPECT_EQ(table.read(plain), ModelError::not_in_image);
}

TEST(ModelLimits, Filters_OneSumOff_Refused) {
  for (const char* const name : {"low 0", "low 1"}) {
    Table table = good_table();
    ++table[name];
    EXPECT_EQ(table.read(), ModelError::out_of_range) << name;
  }
  // Synthesis words whose high-pass half still belongs to the low-pass half.
  const auto read_with = [](std::int32_t even, std::int32_t odd) {
    Table table = good_table();
    table["synthesis 0"] = halves(-odd, even);
    table["synthesis 1"] = halves(even, odd);
    return table.read();
  };
  EXPECT_EQ(read_with(kSynthesisHalf, kSynthesisHalf), ModelError::none);
  EXPECT_EQ(read_with(kSynthesisHalf + 1, kSynthesisHalf), ModelError::out_of_range);
  EXPECT_EQ(read_with(kSynthesisHalf, kSynthesisHalf + 1), ModelError::out_of_range);
}

// The taps' magnitudes sum to less than 2, so that no sum of products leaves 64 bits.
TEST(ModelLimits, FiltersKeepTheirSumsWithin64Bits) {
  const auto fits = [](std::int32_t tap, std::int32_t next_tap) {
    Table table = table_begun();
    table.put("effects", 0).put("expressions", 0).put("program", 0).put("inputs", 0);
    table.put("neurons", 0).put("levels", 1).put("taps", 4).put("rule", 0).put("mode", 0);
    const std::int32_t low[] = {tap, next_tap, kHalf - tap, kHalf - next_tap};
    for (int i = 0; i < 4; ++i) table.put("low " + std::to_string(i), low[i]);
    const std::int32_t upper[] = {0, 0, -kSynthesisHalf, kSynthesisHalf};
    for (int i = 0; i < 4; ++i) {
      table.put("synthesis " + std::to_string(i), halves(upper[i], i < 2 ? kSynthesisHalf : 0));
    }
    table.put("threshold", 655).put("output", 2);
    put_end(table);
    return table.read() == ModelError::none;
  };
  EXPECT_TRUE(fits(kHalf, kHalf));
  EXPECT_TRUE(fits(INT32_MAX, kHalf));  // 2^32 - 2
  EXPECT_FALSE(fits(INT32_MAX, kHalf + 1));
  EXPECT_FALSE(fits(kHalf + 1, INT32_MAX));
}

}  // namespace
