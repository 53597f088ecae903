#pragma once

#include <string>

#include "batch/summary.hpp"
#include "findings/document.hpp"

namespace fogcomp::findings {

/// The index page of a batch: who passes, who fails and why, and the distribution of every value
/// over the gyros. `input`: folder of recordings; `output`: folder of results and of this page.
/// `reports`: each gyro has SERIAL/report.html.
Document batch_findings(const batch::Summary& summary, const std::string& input,
                        const std::string& output, bool reports);

}  // namespace fogcomp::findings
