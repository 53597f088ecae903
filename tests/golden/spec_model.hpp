#pragma once

#include <cstdint>
#include <vector>

#include "core/expression/expression_program.hpp"
#include "core/pipeline/model_parameters.hpp"

// A model that has a part of everything that a table can hold, word by word: nothing but the core
// is needed to make it, so nothing but the core can change it.
namespace fog::test {

struct SpecEffect {
  std::int32_t id;
  std::vector<std::int32_t> constants;
  std::vector<std::int32_t> coefficients;  ///< 20 fractional bits
};

/// Every effect that a board can have.
inline std::vector<SpecEffect> spec_effects() {
  return {{0, {}, {734003}},
          {1, {4}, {-30000, 250000, 40000, -9000}},
          {2, {}, {155000}},
          {3, {17821123}, {700000}},
          {4, {7145397}, {150000}},
          {5, {}, {90000}},
          {6, {70402888, 33001354}, {120000, 200000}},
          {7, {165191050, 447392427, 274877907}, {21000, -31000, 5200, 4100}},
          {8, {12582912, 178956971, 25165824, 89478485}, {31000, 21000}},
          {9, {125829120, 134217728, 9000000}, {104858, 140000}},
          {10, {3, 1310720, 20000000}, {9000000, -2000000, 700000}},
          {11, {1788823}, {314573}},
          {12, {1843200, 56342297, 1174510}, {80000}},
          {13, {}, {60000, -20000}},
          {14, {}, {250000}},
          {15, {}, {100000}},
          {17, {}, {80000000}},
          {18, {5, 368640000}, {1500000, -9000000, 800000, 2500000}},
          {19, {36864, 116508}, {5000000}}};
}

constexpr std::int32_t spec_op(ExpressionOp op, std::int32_t argument = 0) {
  return static_cast<std::int32_t>(op) + argument * 256;
}

/// Three expressions with every operation.
inline std::vector<std::int32_t> spec_program() {
  using Op = ExpressionOp;
  return {spec_op(Op::signal, 0),
          -655360,
          3276800,  // T' F 16
          spec_op(Op::duplicate),
          spec_op(Op::lag),
          120000000,
          spec_op(Op::subtract),
          spec_op(Op::play),
          20000,  //
          spec_op(Op::shift, -6),
          spec_op(Op::signal, 1),
          -1073741824,
          1073741824,
          spec_op(Op::over),
          spec_op(Op::multiply, 27),
          spec_op(Op::sine, 20),
          spec_op(Op::add),
          spec_op(Op::output, 3),  //
          spec_op(Op::signal, 3),
          -30000000,
          30000000,
          spec_op(Op::absolute),
          spec_op(Op::signal, 7),
          65536,
          1000000,
          spec_op(Op::divide, 14),
          spec_op(Op::constant),
          1 << 22,
          spec_op(Op::min),
          spec_op(Op::cosine, 18),
          spec_op(Op::signal, 2),
          0,
          2000,
          spec_op(Op::shift, -18),
          spec_op(Op::decay),
          spec_op(Op::max),
          spec_op(Op::output, 2),  //
          spec_op(Op::signal, 4),
          -10000000,
          10000000,
          spec_op(Op::negate),
          spec_op(Op::signal, 8),
          0,
          100000000,
          spec_op(Op::nip),
          spec_op(Op::shift, -5),
          spec_op(Op::tanh),
          spec_op(Op::output, 2)};
}

namespace detail {

inline void append(std::vector<std::int32_t>& words, const std::vector<std::int32_t>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

inline void append_counted(std::vector<std::int32_t>& words,
                           const std::vector<std::int32_t>& more) {
  words.push_back(static_cast<std::int32_t>(more.size()));
  append(words, more);
}

inline std::vector<std::int32_t> acquisition_words() {
  constexpr std::int32_t kOne = 65536;
  std::vector<std::int32_t> words{200000, 80, 5, 1 << 30, 30, 40'000'000, 1'000'000, 6, 1000};
  append(words, {70402888, 33001354, -5 * kOne, 45 * kOne, 6, 3, 8});
  append(words, {5, -70 * kOne, 130 * kOne, 2 * kOne, -400 * kOne, 400 * kOne, 50 * kOne});
  append(words, {0, 2000 * kOne, 10 * kOne, 0, 12 * kOne, kOne, 0, 40 * kOne, 8 * kOne});
  return words;
}

inline std::vector<std::int32_t> network_words() {
  return {4,         3,         0,          0,          1310720,    1638400,    10,      1,
          0,         109922,    17086383,   6,          2,          23739000,   1300000, 1500000,
          10,        4,         0,          100000,     20000000,   6,          1,       2,  //
          91516528,  938572471, -12508845,  500000000,  90000000,   -398097356,              //
          46781222,  940056463, 300000000,  -167763328, -297189348, 838550537,               //
          -96145695, 606256323, -519279039, 446850807,  159770191,  610242242,               //
          16367260,  0,         200,        9106};
}

}  // namespace detail

inline std::vector<std::int32_t> spec_filters() {
  return {-196508392, 340362520, 1270250216,  733379304,
          196488118,  340413366, -1270213558, 733410378};
}

/// The whole table.
inline std::vector<std::int32_t> spec_table() {
  std::vector<std::int32_t> words{
      kModelMagic, kModelLayout, 0, 0x12345678, 0x43455053, 0x312D, 0, 0, 0, 0, 0};
  detail::append(words, detail::acquisition_words());
  const std::vector<SpecEffect> effects = spec_effects();
  detail::append(words, {20, static_cast<std::int32_t>(effects.size())});
  for (const SpecEffect& effect : effects) {
    words.push_back(effect.id);
    detail::append_counted(words, effect.constants);
    detail::append_counted(words, effect.coefficients);
  }
  detail::append_counted(words, {52000, -31000, 24000});
  detail::append_counted(words, spec_program());
  detail::append(words, detail::network_words());
  detail::append(words, {3, 4, 2, 0});
  detail::append(words, spec_filters());
  detail::append(words, {50000000, 35355339, 25000000});
  detail::append(words, {2 | kRotationIsAngle, 4929415, 921600, 921600, 0});
  words[2] = static_cast<std::int32_t>(words.size());
  words.back() = static_cast<std::int32_t>(model_table_crc({words.data(), words.size()}));
  return words;
}

}  // namespace fog::test
