#include "core/acquisition/sample_monitor.hpp"

namespace fog {

SampleMonitor::Verdict SampleMonitor::judge(const SensorSample& sample, Rate measured,
                                            SampleTime now) {
  Verdict verdict{sequence_.judge(sample.sequence, now)};
  verdict.status |= status_if(!sample.gyro_valid, Status::gyro_invalid);
  verdict.status |= status_if(stuck_.judge(sample.rate_counts), Status::gyro_stuck);
  const std::uint32_t elapsed = verdict.missing + 1;
  verdict.status |= sample_rate_.judge(verdict.late ? 0 : elapsed, now);
  const bool gyro_good = !has_any(verdict.status, Status::gyro_invalid | Status::gyro_stuck);
  verdict.status |= rate_.judge(measured, gyro_good, elapsed);
  verdict.status |= temperature_.judge(Temperature::from_raw(sample.temperature_q16),
                                       sample.temperature_valid, elapsed);
  verdict.temperature = temperature_.use();
  verdict.temperature_confirmed = temperature_.confirmed();
  return verdict;
}

}  // namespace fog
