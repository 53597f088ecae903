#include "workflow/export_header.hpp"

#include <cmath>

#include "board/table_files.hpp"
#include "model/catalogue.hpp"
#include "model/drift_model.hpp"
#include "model/model_file.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::workflow {
namespace {

// The bias that a model with this event has.
std::string bias_at(const model::EffectTerm& event) {
  const std::string step = format("the step of %+.2g deg/h at %.6g s",
                                  event.coefficients_dph[0].value, event.parameters[0].value);
  const std::string bias = event.bias_of_others();
  if (bias == "mean") return "mean bias of the recording with " + step;
  return "bias " + bias + " " + step;
}

// Parts of the model that the board cannot use, one sentence each.
std::vector<std::string> left_out(const model::Model& model,
                                  const fog::ModelParameters& parameters) {
  std::vector<std::string> notes;
  for (const model::EffectTerm& term : model.terms) {
    const char* reason = model::info_of(term).host_only;
    if (reason == nullptr) continue;
    notes.push_back(term.name + " is left out: " + reason);
    if (!model::is_event(term) || term.coefficients_dph.empty()) continue;
    notes.back() += "; the board has the " + bias_at(term);
  }
  for (const model::EffectTerm& term : model.terms) {
    if (!term.has_first_heat()) continue;
    notes.push_back(
        format("%s is taken at %.4g degC, the highest trained temperature: the board "
               "expects a gyro that has been there",
               term.name.c_str(), model.max_degc));
  }
  if (const std::string settling = board::settling_words(model); !settling.empty()) {
    notes.push_back(settling);
  }
  const fog::AcquisitionParameters& board = parameters.acquisition;
  const double step_dps = std::ldexp(board.rate.step.raw(), -fog::RateStep::fractional_bits) / 3600;
  const double range_dps = std::ldexp(board.rate.range.raw(), -fog::Rate::fractional_bits) / 3600;
  if (step_dps >= range_dps) {
    notes.push_back(
        format("a rate that folds at +-%g deg/s cannot be distinguished from a reversal: "
               "in a sample of %g ms it may change by %.4g deg/s; give "
               "--max-acceleration if it cannot",
               range_dps, board.sample_period_us * 1e-3, step_dps));
  }
  return notes;
}

// A board has no clock that runs without power.
void require_time_since_power_on(const model::Model& model, const std::string& file) {
  constexpr double kDayS = 86400;
  for (const model::EffectTerm& term : model.terms) {
    if (!model::info_of(term).outlives_power) continue;
    model::Model alone = model;
    alone.terms = {term};
    alone.network = {};
    model::RealDriftModel drift(alone, 1);
    model::RealBlock block;
    drift.start(block);
    const double begun_dph = drift.drift_dph();
    block.elapsed = kDayS;
    drift.step(block);
    throw InputError(
        file, format("effect '%s' goes on while the power is off, and a board knows the time since "
                     "power-on alone: each power cycle would set it back, by %.2g deg/h after a "
                     "day; fit without it, or give --allow-error for a board that is never "
                     "switched off",
                     term.name.c_str(), std::abs(drift.drift_dph() - begun_dph)));
  }
}

void require_determined(const model::Model& model, const std::string& file) {
  if (!model.uncertain) return;
  throw InputError(file, "these recordings did not determine it: " + model.uncertain->words() +
                             "; --allow-error writes it all the same");
}

}  // namespace

BoardErrors verify_board(const model::Model& model, const fog::ModelParameters& parameters,
                         const std::string& file, bool allow_error) {
  if (!allow_error) {
    require_time_since_power_on(model, file);
    require_determined(model, file);
  }
  const BoardErrors errors{board::verify_quantization(model, parameters),
                           board::verify_network(model, parameters)};
  const auto& [error, network] = errors;
  if (network.worst_dph > board::kQuantizationLimitDph && !allow_error) {
    throw InputError(
        file,
        format("the network's integers would be %.4f deg/h off somewhere among its inputs (limit "
               "%.4f); train it with fewer neurons or another --seed, or give --allow-error",
               network.worst_dph, board::kQuantizationLimitDph));
  }
  if (error.worst_dph > board::kQuantizationLimitDph && !allow_error) {
    throw InputError(
        file, format("the board's integers would be %.4f deg/h off at %.1f degC, %.1f degC/min "
                     "(limit %.4f); lower the drift's size or give --allow-error",
                     error.worst_dph, error.at_temperature_degc, error.at_temperature_rate,
                     board::kQuantizationLimitDph));
  }
  return errors;
}

ExportOutcome board_header(const model::Model& model, const std::string& file,
                           const board::BoardSettings& board, bool allow_error) {
  const board::BoardTable table = board::make_board_table(model, board);
  const fog::ModelParameters parameters = board::read_board_table(table, file);
  const BoardErrors errors = verify_board(model, parameters, file, allow_error);
  const std::uint32_t data_hash = model.history.empty() ? 0 : model.history.back().data_hash;
  return {board::header_text(table, file.substr(file.rfind('/') + 1), data_hash),
          table,
          errors.quantization,
          errors.network,
          board::denoised_response(parameters),
          board::rate_words(parameters),
          left_out(model, parameters)};
}

std::string export_refusal(const model::Model& model, const std::string& file, bool extension) {
  board::BoardSettings settings;
  settings.extension = extension;
  try {
    require_time_since_power_on(model, file);
    require_determined(model, file);
    board::make_board_table(model, settings);
  } catch (const InputError& refusal) {
    return refusal.what();
  }
  return "";
}

ExportOutcome export_header(const ExportRequest& request) {
  model::Model model = model::load_model(request.model);
  if (request.denoiser) model.denoise = request.denoiser(model.denoise);
  return board_header(model, request.model, request.board, request.allow_error);
}

}  // namespace fogcomp::workflow
