#include "findings/thinning.hpp"

#include <algorithm>
#include <limits>

#include "recording/segments.hpp"

namespace fogcomp::findings {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

using Columns = std::vector<const std::vector<double>*>;

// Rows [first, end) as two points: minimum and maximum of each curve, in their order.
void append_extremes(Curves& curves, const std::vector<double>& x, const Columns& y,
                     recording::RowRange rows) {
  const bool single = rows.size() == 1;
  curves.x.push_back(x[rows.first]);
  if (!single) curves.x.push_back(x[rows.end - 1]);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const auto begin = y[i]->begin();
    const auto [min, max] = std::minmax_element(begin + static_cast<std::ptrdiff_t>(rows.first),
                                                begin + static_cast<std::ptrdiff_t>(rows.end));
    curves.y[i].push_back(min < max ? *min : *max);
    if (!single) curves.y[i].push_back(min < max ? *max : *min);
  }
}

// Rows [first, end) as one point: the mean of each curve.
void append_means(Curves& curves, const std::vector<double>& x, const Columns& y,
                  recording::RowRange rows) {
  const auto mean = [&](const std::vector<double>& values) {
    double sum = 0;
    for (std::size_t row = rows.first; row < rows.end; ++row) sum += values[row];
    return sum / static_cast<double>(rows.size());
  };
  curves.x.push_back(mean(x));
  for (std::size_t i = 0; i < y.size(); ++i) curves.y[i].push_back(mean(*y[i]));
}

void append_gap(Curves& curves, double x) {
  curves.x.push_back(x);
  for (std::vector<double>& values : curves.y) values.push_back(kGap);
}

// Divides the rows into columns without visible gaps.
template <class Append>
Curves cut(const std::vector<double>& x, const Columns& y,
           const std::vector<std::size_t>& stretch_starts, Append append) {
  Curves curves;
  curves.y.resize(y.size());
  if (x.empty()) return curves;
  const std::size_t rows = x.size();
  const bool all = rows <= 2 * kColumns;
  const double column_width = (x.back() - x.front()) / static_cast<double>(kColumns);
  const auto column = [&](std::size_t row) {
    return all ? row : static_cast<std::size_t>((x[row] - x.front()) / column_width);
  };
  auto next_start = stretch_starts.begin();
  for (std::size_t first = 0; first < rows;) {
    bool gap = false;
    while (next_start != stretch_starts.end() && *next_start <= first) {
      gap = first > 0;
      ++next_start;
    }
    // A gap narrower than a column is invisible.
    if (gap && (all || x[first] - x[first - 1] > column_width)) {
      append_gap(curves, (x[first - 1] + x[first]) / 2);
    }
    std::size_t end = first + 1;
    while (end < rows && column(end) == column(first) &&
           (next_start == stretch_starts.end() || end < *next_start ||
            x[end] - x[end - 1] <= column_width)) {
      ++end;
    }
    append(curves, x, y, recording::RowRange{first, end});
    first = end;
  }
  return curves;
}

}  // namespace

Curves min_and_max(const std::vector<double>& x, const Columns& y,
                   const std::vector<std::size_t>& stretch_starts) {
  return cut(x, y, stretch_starts, append_extremes);
}

Curves column_means(const std::vector<double>& x, const Columns& y,
                    const std::vector<std::size_t>& stretch_starts) {
  return cut(x, y, stretch_starts, append_means);
}

Cloud thinned(const std::vector<double>& x, const std::vector<double>& y,
              const std::vector<compare::Branch>& branch, compare::Branch wanted,
              std::size_t rows_per_point) {
  Cloud cloud;
  double sum_x = 0;
  double sum_y = 0;
  std::size_t rows = 0;
  const auto flush = [&] {
    if (rows == 0) return;
    cloud.x.push_back(sum_x / static_cast<double>(rows));
    cloud.y.push_back(sum_y / static_cast<double>(rows));
    sum_x = sum_y = 0;
    rows = 0;
  };
  for (std::size_t row = 0; row < x.size(); ++row) {
    if (branch[row] != wanted) {
      flush();
      continue;
    }
    sum_x += x[row];
    sum_y += y[row];
    if (++rows == rows_per_point) flush();
  }
  flush();
  return cloud;
}

std::size_t rows_per_point(std::size_t rows) {
  return std::max<std::size_t>(1, (rows + kCloudPoints - 1) / kCloudPoints);
}

}  // namespace fogcomp::findings
