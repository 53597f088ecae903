#include "core/acquisition/sequence_monitor.hpp"

namespace fog {
namespace {

// Sequence numbers have 16 bits: a step of less than half the circle is samples lost, one of more
// is a sample that comes late or twice and does not move time.
constexpr std::uint32_t kMostMissing = 0x7FFF;

}  // namespace

SequenceMonitor::Verdict SequenceMonitor::judge(std::uint16_t sequence) {
  Verdict verdict;
  const auto skipped =
      static_cast<std::uint16_t>(static_cast<unsigned>(sequence) - newest_ - unsigned{!first_});
  const bool behind = !first_ && skipped > kMostMissing;
  verdict.status = status_if(!first_ && skipped != 0, Status::sequence_gap);
  if (behind && ++late_samples_ < kLateSamplesOfARestart) {
    verdict.late = true;
    return verdict;
  }
  // After a restart the samples that were taken for late ones turn out to have been time.
  if (!first_) verdict.missing = behind ? kLateSamplesOfARestart - 1 : skipped;
  late_samples_ = 0;
  newest_ = sequence;
  first_ = false;
  return verdict;
}

}  // namespace fog
