#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "planning/search.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

/// What a programme of the chamber is planned for, or programmes are compared for.
struct PlanRequest {
  std::optional<std::string> model;    ///< file: its effects, its noise, the box of its runs
  std::optional<std::string> effects;  ///< instead; nothing: model::kFirstEffects
  std::vector<std::string> noise;      ///< `k=v,...`: white, flicker, random_walk of simulate
  std::optional<std::string> use;      ///< the box of use; nothing: the model's, or the chamber
  std::string chamber;                 ///< what it can do, as a box
  double hours = 8;
  std::uint64_t seed = 1;
};

struct PlanOutcome {
  PlanRequest request;
  planning::Question question;
  planning::OperatingBox chamber;
  planning::Plan plan;
  std::vector<planning::VisibleSize> visible;
};

/// Throws InputError for a box that the chamber does not reach, unknown effects, a model without
/// effects.
PlanOutcome plan(const PlanRequest& request, const Observer& observer = {});

/// What some programmes would tell.
struct PlanComparison {
  planning::Question question;
  struct One {
    std::string name;
    planning::Expectation expectation;
    std::vector<planning::VisibleSize> visible;
  };
  std::vector<One> programmes;
};

/// `programmes`: ready-made ones or files. The chamber and the hours of the request play no part.
PlanComparison compare_programmes(const PlanRequest& request,
                                  const std::vector<std::string>& programmes);

}  // namespace fogcomp::workflow
