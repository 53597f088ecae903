#pragma once

#include <string>

#include "fit/add_effect.hpp"
#include "report/report.hpp"

namespace fogcomp::report {

/// What `fogcomp add` found, with plots of every run before and after. `model`: the one that the
/// effect was to be added to; `written`: the file with it, "" where nothing was written.
Report add_report(const Addition& addition, const std::string& model, const std::string& written);

}  // namespace fogcomp::report
