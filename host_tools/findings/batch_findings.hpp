#pragma once

#include <string>

#include "batch/summary.hpp"
#include "findings/document.hpp"

namespace fogcomp::findings {

/// The index page of a batch: who passes, who does not and why, how every figure is spread over the
/// gyros. `input`: the folder of recordings, `output`: of results and of this page. `reports`: each
/// gyro has SERIAL/report.html beside it.
Document batch_findings(const batch::Summary& summary, const std::string& input,
                        const std::string& output, bool reports);

}  // namespace fogcomp::findings
