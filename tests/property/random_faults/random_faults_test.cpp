// drift_under_faults_test.cpp tests every fault once; here they come at random and overlap.
#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <vector>

#include "support/drift_under_faults.hpp"
#include "support/typical_effects.hpp"

namespace {

using fog::test::DriftUnderFaults;
using fog::test::DriftVerdict;
using fog::test::Fault;
using Kind = Fault::Kind;

constexpr double kBoundDph = 0.05;
constexpr double kSamples = 1e6;
constexpr double kRunS = kSamples / 200;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  double uniform(double a, double b) { return std::uniform_real_distribution(a, b)(random_); }
  /// From milliseconds to many minutes, each order of magnitude as often as the others.
  double duration_s() { return std::pow(10, uniform(-2.3, 2.9)); }

  Fault fault(double from_s) {
    const auto kind = static_cast<Kind>(random_() % (static_cast<unsigned>(Kind::pin_reset) + 1));
    Fault fault{kind, from_s, from_s + duration_s()};
    // The watchdog expires after 0.1 s; a start takes another 0.1 s.
    if (kind == Kind::board_restart) fault.to_s = from_s + uniform(0.05, 1);
    if (kind == Kind::restart) fault.value = uniform(0, 65536);
    if (kind == Kind::wrong_temperature) fault.value = uniform(-80, 140);
    if (kind == Kind::temperature_offset) fault.value = uniform(-30, 30);
    if (kind == Kind::sample_period) fault.value = 5000 * std::exp(uniform(-1, 1));
    if (kind == Kind::sparse) fault.value = std::floor(std::pow(10, uniform(0.3, 3)));
    return fault;
  }

 private:
  std::mt19937_64 random_;
};

// Random faults, with overlapping ones, and intervals long enough for trusted rates in between.
std::vector<Fault> schedule(std::uint64_t seed) {
  Draw draw(seed);
  std::vector<Fault> faults;
  if (draw.uniform(0, 1) < 0.3) faults.push_back(draw.fault(0));
  for (double time_s = draw.uniform(0, 800); time_s < kRunS; time_s += draw.uniform(0, 800)) {
    do {
      faults.push_back(draw.fault(time_s + draw.uniform(0, 100)));
    } while (draw.uniform(0, 1) < 0.4);
  }
  return faults;
}

void print(std::uint64_t seed, const std::vector<Fault>& faults, const DriftVerdict& verdict) {
  std::printf(
      "seed %3llu: %2zu faults, %4.1f %% of the rates trusted, off by %.3f deg/h at %.2f s\n",
      static_cast<unsigned long long>(seed), faults.size(),
      100.0 * static_cast<double>(verdict.trusted) / static_cast<double>(verdict.samples),
      verdict.worst_dph, verdict.worst_at_s);
  if (verdict.worst_dph <= kBoundDph) return;
  for (const Fault& fault : faults) {
    std::printf("  kind %d from %.3f to %.3f s, %g\n", static_cast<int>(fault.kind), fault.from_s,
                fault.to_s, fault.value);
  }
}

TEST(RandomFaults, LeaveNoTrustedRateWithAWrongDrift) {
  const DriftUnderFaults board(fog::test::paper_like_model());
  double trusted = 0;
  double samples = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::vector<Fault> faults = schedule(seed);
    const DriftVerdict verdict = board.run(faults, kRunS, seed);
    print(seed, faults, verdict);
    EXPECT_LE(verdict.worst_dph, kBoundDph) << "seed " << seed;
    trusted += static_cast<double>(verdict.trusted);
    samples += static_cast<double>(verdict.samples);
  }
  EXPECT_GT(trusted, samples / 4) << "or the test says little";
}

}  // namespace
