#pragma once

#include <memory>
#include <vector>

#include "fit/addition.hpp"
#include "fit/effect_change.hpp"
#include "runs/runs.hpp"

namespace fogcomp::fit {

/// `model` refitted to the training runs without any change, in rows of runs::row_length().
/// `series`: theirs, if there is one of a model with the same derivative. Throws InputError like
/// add_effect().
RefittedModel refitted(const model::Model& model, const runs::Runs& runs,
                       const AddSettings& settings,
                       std::shared_ptr<const KnownRegressors> series = nullptr);

/// Applies `change` to `model`, for whose terms it was made, and refits everything on the training
/// runs: all effects together, then, if the model has a network, a new one of the same size on
/// their residual. "Before" is the model without the change, refitted on the same runs, so that
/// refitting alone is no improvement.
///
/// The change is accepted if all of this holds. The effects alone improve the prediction out of
/// sample (OutOfSample::helps): on the holdouts or, without any, by cross-validation. The whole
/// model's rms on the holdouts has not risen by more than chance. With stretches of one run, a
/// random walk of the bias is unlikely (rules::kMaxChanceOfWalk). The data determine the new parts:
/// no shape at a bound or anywhere in its range, coefficients larger than their uncertainty, a
/// drift in the soaks that is not less certain than it is large (Model::uncertain). In a set, each
/// effect helps beside the others. A cut belongs to one run: stretches of the training runs judge
/// it, holdouts or not; `runs` are cut already. A network replaces the model's own; it is compared
/// with the effects alone.
///
/// The verdict is on fits in rows of runs::row_length(), so that it does not depend on those of the
/// model; the model that is returned is fitted in its own. Throws InputError for a run without an
/// input of the effect, and for data that cannot determine it.
Addition add_effect(const model::Model& model, const EffectChange& change, const runs::Runs& runs,
                    const AddSettings& settings);

/// The first half of add_effect(): the verdict, with model, fit and errors in its rows.
Addition judge_addition(const model::Model& model, const EffectChange& change,
                        const runs::Runs& runs, const AddSettings& settings);

/// The second half: model, fit and errors in the model's own rows, if those of the verdict are
/// others. Throws InputError like add_effect().
void take_own_rows(const model::Model& model, const EffectChange& change, const runs::Runs& runs,
                   const AddSettings& settings, Addition& addition);

}  // namespace fogcomp::fit
