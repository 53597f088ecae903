#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fogcomp::denoise {

/// Names and decomposition low-pass filters of a family.
using FilterTable = std::vector<std::pair<std::string, std::vector<double>>>;

extern const FilterTable kDaubechies;
extern const FilterTable kSymlets;
extern const FilterTable kCoiflets;

}  // namespace fogcomp::denoise
