// random_faults [FIRST COUNT]: schedules of random faults of 10^6 samples and more each, by seed;
// prints those after which a rate was trusted though its drift was off by more than 0.05 deg/h, or
// though the gyro stood or leapt, or a denoised rate was valid though it was another sample's than
// its delay says, and how many. One takes 0.3 to 0.6 s of CPU, 10^4 an hour or two.
#include <cstdio>
#include <cstdlib>

#include "support/fault_schedule.hpp"

int main(int argc, char** argv) {
  const std::uint64_t first = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1;
  const std::uint64_t count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 10'000;
  std::uint64_t wrong = 0;
  double trusted = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const fog::test::FaultSchedule schedule = fog::test::FaultScheduler(seed).draw();
    const fog::test::DriftVerdict verdict = run(schedule, seed);
    trusted += static_cast<double>(verdict.trusted) / static_cast<double>(verdict.samples);
    if (complaint(verdict).empty()) continue;
    ++wrong;
    std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed),
                complaint(verdict).c_str());
    print(schedule);
    std::fflush(stdout);
  }
  std::printf("%llu of %llu schedules wrong, %.1f %% of the rates trusted\n",
              static_cast<unsigned long long>(wrong), static_cast<unsigned long long>(count),
              100 * trusted / static_cast<double>(count));
  return wrong == 0 ? 0 : 1;
}
