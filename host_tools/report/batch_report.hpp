#pragma once

#include <string>

#include "batch/summary.hpp"
#include "report/report.hpp"

namespace fogcomp::report {

/// The index page of a batch: who passes, who does not and why, how every figure is spread over the
/// gyros. `input`: the folder of recordings. `reports`: each gyro has SERIAL/report.html beside it.
Report batch_report(const batch::Summary& summary, const std::string& input, bool reports);

}  // namespace fogcomp::report
