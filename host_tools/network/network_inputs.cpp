#include "network/network_inputs.hpp"

#include <algorithm>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::network {
namespace {

constexpr const char* kWhere = "--inputs";
constexpr double kMinTau_s = 1;
constexpr double kMaxTau_s = 1e5;

fog::NetworkInput input_named(const std::string& name) {
  const std::vector<std::string> names = model::network_input_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end())
    return model::kEveryNetworkInput[static_cast<std::size_t>(found - names.begin())];
  throw InputError(kWhere, "'" + name + "' is no input of a network" + did_you_mean(name, names) +
                               "; there are " + join(names, ", "));
}

model::RealInput parse_input(const std::string& text) {
  const std::size_t colon = text.find(':');
  model::RealInput input;
  input.signal = input_named(text.substr(0, colon));
  const bool lagged = input.signal == fog::NetworkInput::lagged_temperature;
  const std::string setting = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (!lagged) {
    if (setting.empty()) return input;
    throw InputError(kWhere, "'" + text + "': only lagged_temperature has a setting, tau");
  }
  const auto tau_s = setting.rfind("tau=", 0) == 0 ? parse_number(setting.substr(4)) : std::nullopt;
  if (!tau_s || *tau_s < kMinTau_s || *tau_s > kMaxTau_s) {
    throw InputError(kWhere, format("lagged_temperature needs its time constant: "
                                    "lagged_temperature:tau=300, from %g to %g s",
                                    kMinTau_s, kMaxTau_s));
  }
  input.tau_s = *tau_s;
  return input;
}

}  // namespace

std::vector<model::RealInput> parse_network_inputs(const std::string& list) {
  std::vector<model::RealInput> inputs;
  for (const std::string& text : split(list, ',')) {
    const model::RealInput input = parse_input(text);
    const bool twice =
        std::any_of(inputs.begin(), inputs.end(), [&](const model::RealInput& other) {
          return other.signal == input.signal && other.tau_s == input.tau_s;
        });
    if (twice) throw InputError(kWhere, "'" + text + "' is listed twice");
    inputs.push_back(input);
  }
  if (inputs.empty() || inputs.size() > fog::kMaxNetworkInputs) {
    throw InputError(
        kWhere, format("takes 1 to %zu inputs, not %zu", fog::kMaxNetworkInputs, inputs.size()));
  }
  return inputs;
}

}  // namespace fogcomp::network
