// fogcomp calibrate: one gyro of a production line.

#include <cstdio>

#include "batch/summary.hpp"
#include "cli/command.hpp"
#include "cli/gyro_calibration.hpp"
#include "support/input_error.hpp"
#include "support/output_file.hpp"
#include "support/parallel.hpp"

namespace fogcomp::cli {
namespace {

struct CalibrateCommand : Command {
  LotOptions common{this};
  Integer<std::size_t> threads{
      this, {"threads", "N", "processors to use (default: all)", "", kRare}, 1, 1024};

  CalibrateCommand()
      : Command("calibrate", {"DIR/SERIAL", 1, 1},
                "fit, compare, export one gyro of a folder; why it fails",
                "fogcomp calibrate gyros/G1 -o results --effects bias,temperature_rate") {
    needs = common.needs();
  }
  int run() const override;
};

int CalibrateCommand::run() const {
  const batch::GyroFolder gyro = batch::find_gyro(arguments[0], common.patterns());
  const GyroCalibration calibration(common, gyro.parent);
  const std::string folder = calibration.folder_of(gyro);
  check_output(*this, batch::result_path(folder));
  if (threads.given()) set_max_threads(threads.value());
  make_folder(folder);
  std::optional<batch::GyroResult> result = calibration.result_of(gyro);
  const bool is_new = !result;
  if (is_new || calibration.lacks_diagnosis(gyro, *result)) {
    const std::string log = folder + "/log.txt";
    if (std::freopen(log.c_str(), is_new ? "w" : "a", stderr) == nullptr) {
      throw InputError(log, "cannot be written");
    }
  }
  if (is_new) result = calibration.calibrate(gyro);
  if (!result->error.empty()) std::fprintf(stderr, "%s\n", result->error.c_str());
  if (calibration.lacks_diagnosis(gyro, *result)) calibration.diagnose(gyro, *result);
  const batch::Summary summary = batch::summarise({*result}, calibration.limits(), {});
  const batch::Summary::Gyro& judged = summary.gyros.front();
  std::printf("%s: %s%s%s%s\n", gyro.name.c_str(), batch::name_of(judged.outcome),
              judged.reason.empty() ? "" : ", ", judged.reason.c_str(),
              is_new ? "" : " (calibrated before)");
  return judged.outcome == batch::Outcome::pass ? 0 : 1;
}

}  // namespace

CommandPointer calibrate_command() {
  return std::make_unique<CalibrateCommand>();
}

}  // namespace fogcomp::cli
