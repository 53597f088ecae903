#include "research/figures.hpp"

#include <vector>

#include "support/output_file.hpp"
#include "support/text.hpp"

namespace fogcomp::research {
namespace {

struct Curve {
  const char* name;
  Eigen::VectorXd values;
};

void write_figure(const std::string& path, const Study& study, const std::vector<Curve>& curves) {
  const series::Rows& rows = study.run.series.rows();
  OutputFile file(path);
  std::string line = "time_s";
  for (const Curve& curve : curves) line += std::string(",") + curve.name;
  file.write(line + "\n");
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    line = format("%.1f", rows.time_s[static_cast<std::size_t>(i)]);
    for (const Curve& curve : curves) line += format(",%.6f", curve.values[i]);
    file.write(line + "\n");
  }
  file.commit();
}

}  // namespace

std::string figure_path(const std::string& folder, int figure) {
  return folder + format("/figure_%d.csv", figure);
}

void write_figures(const Study& study, const std::string& folder) {
  const series::Rows& rows = study.run.series.rows();
  Eigen::VectorXd temperature(rows.size());
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    temperature[i] = rows.signals[static_cast<std::size_t>(i)].temperature;
  }
  const Eigen::VectorXd& raw = rows.drift_dph;
  const Eigen::VectorXd& bp = study.model("bp").own_dph;
  const Eigen::VectorXd& pso_bp = study.model("pso-bp").own_dph;
  const auto path = [&](int figure) { return figure_path(folder, figure); };
  write_figure(path(1), study, {{"temperature_degc", temperature}, {"raw_dph", raw}});
  write_figure(path(3), study, {{"raw_dph", raw}, {"denoised_dph", study.denoised_dph}});
  write_figure(path(4), study, {{"hard_dph", study.hard_dph}, {"soft_dph", study.denoised_dph}});
  write_figure(path(8), study,
               {{"denoised_dph", study.denoised_dph}, {"bp_dph", bp}, {"pso_bp_dph", pso_bp}});
  write_figure(path(9), study, {{"raw_dph", raw}, {"after_bp_dph", raw - bp}});
  write_figure(path(10), study, {{"raw_dph", raw}, {"after_pso_bp_dph", raw - pso_bp}});
}

}  // namespace fogcomp::research
