#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "board/host_compensator.hpp"
#include "core/pipeline/compensator.hpp"
#include "support/sample_models.hpp"

namespace fog::test {

constexpr std::int32_t kDegree = 65536;
constexpr int kConfirmed = 100;  // samples after the first until its temperature is confirmed

// The whole pipeline with the sample model at 200 Hz.
class CompensatorTest : public testing::Test {
 protected:
  CompensatorTest() { restart(); }

  void restart() {
    table_ = fogcomp::board::make_board_table(model_, settings_);
    parameters_ = fogcomp::board::read_board_table(table_, "test");
    pipeline_ = std::make_unique<fogcomp::board::HostCompensator>(
        parameters_, fog::IntegrityToken::not_needed());
  }

  OutputSample send(SensorSample sample) { return pipeline_->process(sample); }

  /// A good sample of a gyro with noise.
  SensorSample sample() {
    ++sequence_;
    return {sequence_, 700 + (sequence_ * 37) % 11 * 100, 25 * kDegree, true, true};
  }
  OutputSample run(int samples) {
    OutputSample last;
    for (int i = 0; i < samples; ++i) last = send(sample());
    return last;
  }

  fogcomp::model::Model model_ = paper_like_model();
  fogcomp::board::BoardSettings settings_ = lenient_board();
  fogcomp::board::BoardTable table_;
  ModelParameters parameters_;
  std::unique_ptr<fogcomp::board::HostCompensator> pipeline_;
  std::uint16_t sequence_ = 65000;  // wraps soon
};

}  // namespace fog::test
