#include "recording/unknown_input_rate.hpp"

#include "support/text.hpp"

namespace fogcomp::recording {

void mask_unknown_input_rate(Recording& recording, const std::vector<Mask>& unknown,
                             const std::string& which, const std::string& remedy,
                             const ReadWatch& watch) {
  if (unknown.empty()) return;
  watch.say(recording.file,
            format("input_rate_dph: fits and comparisons leave out %.4g s ", length_s(unknown)) +
                which + format(", the first at %.6g s; ", unknown.front().from_s) + remedy);
  recording.masks.insert(recording.masks.end(), unknown.begin(), unknown.end());
}

}  // namespace fogcomp::recording
