#include "findings/json.hpp"

namespace fogcomp::findings {

Json batch_json(const batch::Summary& summary, const std::string& output, std::size_t calibrated,
                std::size_t already_done) {
  using batch::Outcome;
  Json gyros = json_array(summary.gyros, [&](const batch::Summary::Gyro& gyro) {
    return Json::object()
        .set("gyro", gyro.result.gyro)
        .set("outcome", name_of(gyro.outcome))
        .set("reason", gyro.reason);
  });
  Json result = Json::object();
  result.set("table", output + "/gyros.csv").set("index", output + "/index.html");
  result.set("pass", summary.count(Outcome::pass)).set("fail", summary.count(Outcome::fail));
  result.set("error", summary.count(Outcome::error));
  result.set("calibrated", calibrated).set("already_done", already_done);
  result.set("gyros", std::move(gyros));
  return result;
}

}  // namespace fogcomp::findings
