#include "findings/json.hpp"

namespace fogcomp::findings {
namespace {

Json brief_json(const std::optional<batch::GyroDiagnosis>& diagnosis) {
  if (!diagnosis) return Json();
  return Json::object()
      .set("verdict", text_or_null(diagnosis->verdict))
      .set("effects", diagnosis->effects)
      .set("size_dph", diagnosis->size_dph)
      .set("probability", diagnosis->probability)
      .set("sentence", diagnosis->sentence)
      .set("next", text_or_null(diagnosis->next));
}

Json outliers_json(const batch::Lot& lot, const std::string& gyro) {
  Json all = Json::array();
  for (const batch::Outlier& outlier : lot.outliers) {
    if (outlier.gyro != gyro) continue;
    all.push(Json::object()
                 .set("figure", outlier.figure)
                 .set("value", outlier.value)
                 .set("spreads", outlier.score));
  }
  return all;
}

Json lot_json(const batch::Lot& lot) {
  Json figures = json_array(lot.figures, [](const batch::LotFigure& figure) {
    return Json::object()
        .set("figure", figure.name)
        .set("gyros", figure.gyros)
        .set("median", figure.median)
        .set("spread", figure.spread)
        .set("of_ratios", figure.ratios);
  });
  return Json::object()
      .set("bound", lot.figures.empty() ? Json() : Json(lot.bound))
      .set("figures", std::move(figures));
}

}  // namespace

Json batch_json(const batch::Summary& summary, const std::string& output, std::size_t calibrated,
                std::size_t already_done) {
  using batch::Outcome;
  Json gyros = json_array(summary.gyros, [&](const batch::Summary::Gyro& gyro) {
    return Json::object()
        .set("gyro", gyro.result.gyro)
        .set("outcome", name_of(gyro.outcome))
        .set("reason", gyro.reason)
        .set("notes", gyro.result.notes)
        .set("diagnosis", brief_json(gyro.diagnosis))
        .set("outliers", outliers_json(summary.lot, gyro.result.gyro));
  });
  Json result = Json::object();
  result.set("table", output + "/gyros.csv").set("index", output + "/index.html");
  result.set("pass", summary.count(Outcome::pass)).set("fail", summary.count(Outcome::fail));
  result.set("error", summary.count(Outcome::error));
  result.set("calibrated", calibrated).set("already_done", already_done);
  result.set("gyros", std::move(gyros));
  result.set("lot", lot_json(summary.lot));
  return result;
}

}  // namespace fogcomp::findings
