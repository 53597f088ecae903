#pragma once

#include <string>

#include "cli/option.hpp"
#include "fit/fit_model.hpp"

namespace fogcomp::cli {

/// --network, --trainer and their options.
struct TrainingOptions : OptionGroup {
  using OptionGroup::OptionGroup;
  network::TrainerSettings value() const;

  Integer<int> network{this,
                       {"network", "N", "hidden neurons, 0 for none, at most 32", "0"},
                       0,
                       network::kMaxTrainedHidden};
  Choice<std::string> trainer{this,
                              {"trainer", "NAME", trainer_summaries(), "lm", kRare},
                              as_named(network::trainer_names())};
  Integer<std::uint64_t> seed{
      this, {"seed", "N", "of all that training draws", "1", kRare}, 0, 1LL << 53};
  Choice<fog::Activation> activation{
      this,
      {"activation", "NAME", "of the hidden neurons: logsig or tansig", "logsig", kRare},
      {{"logsig", fog::Activation::logsig}, {"tansig", fog::Activation::tansig}}};
  Integer<int> epochs{
      this,
      {"epochs", "N", "of traingdx, pso-bp and ga-bp; steps of lm, at most 200", "5000", kRare},
      1,
      1'000'000};
  Number goal{this,
              {"goal", "MSE", "training ends at this mean square of the normalised target (not lm)",
               "0", kRare},
              {0, 1}};
  Number learning_rate{
      this,
      {"learning-rate", "R", "of the gradient trainers at their start", "0.05", kRare},
      {1e-6, 10}};
  Integer<int> particles{
      this, {"particles", "N", "of pso-bp; population of ga-bp", "20", kRare}, 3, 1000};
  Integer<int> iterations{
      this,
      {"iterations", "N", "of the swarm or the population, before backpropagation", "300", kRare},
      0,
      100'000};
  Flag force_network{this, "force-network",
                     "keep the network even if it does not help out of sample", kRare};

 private:
  static std::string trainer_summaries();
};

}  // namespace fogcomp::cli
