// A genetic algorithm with real genes (Eshelman & Schaffer's blend crossover, FOGA 1993) over all
// weights and biases, then gradient descent from the fittest.
#include <algorithm>
#include <vector>

#include "network/trainer_parts.hpp"

namespace fogcomp::network {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t kElite = 2;       // survive unchanged
constexpr std::size_t kTournament = 3;  // a parent is the best of so many
constexpr double kBlend = 0.5;  // a child's gene may lie so far outside its parents' interval
constexpr double kMutationChance = 0.05;  // of a gene
constexpr double kMutation = 0.5;         // at most, at the start; falls to a tenth
constexpr double kCalm = 0.9;

struct Individual {
  VectorXd genes;
  double cost = 0;
};

bool fitter(const Individual& a, const Individual& b) {
  return a.cost < b.cost;
}

// The population is sorted, so the smallest index drawn is the best.
const Individual& parent(const std::vector<Individual>& sorted, Uniform& uniform) {
  std::size_t best = sorted.size() - 1;
  for (std::size_t i = 0; i < kTournament; ++i) best = std::min(best, uniform.index(sorted.size()));
  return sorted[best];
}

VectorXd child(const VectorXd& a, const VectorXd& b, double mutation, Uniform& uniform) {
  VectorXd genes(a.size());
  for (Index d = 0; d < genes.size(); ++d) {
    const double share = -kBlend + (1 + 2 * kBlend) * uniform.unit();
    genes[d] = a[d] + share * (b[d] - a[d]);
    if (uniform.unit() < kMutationChance) genes[d] += uniform.within(mutation);
  }
  return genes;
}

}  // namespace

TrainerResult train_genetic(const TrainingProblem& problem, const TrainerSettings& settings) {
  Uniform uniform(settings.seed);
  const auto judged = [&](VectorXd genes) {
    const double cost = problem.rows->mean_square(problem.shape, genes);
    return Individual{std::move(genes), cost};
  };
  std::vector<Individual> population;
  for (int i = 0; i < settings.particles; ++i) {
    population.push_back(
        judged(problem.shape.first_weights(settings.seed + static_cast<std::uint64_t>(i))));
  }
  std::sort(population.begin(), population.end(), fitter);
  for (int generation = 0; generation < settings.iterations; ++generation) {
    const double done = static_cast<double>(generation) / settings.iterations;
    if (settings.go_on && !settings.go_on(done)) break;
    const std::size_t kept = std::min(kElite, population.size());
    std::vector<Individual> next(population.begin(),
                                 population.begin() + static_cast<std::ptrdiff_t>(kept));
    while (next.size() < population.size()) {
      const Individual& a = parent(population, uniform);
      const Individual& b = parent(population, uniform);
      next.push_back(judged(child(a.genes, b.genes, kMutation * (1 - kCalm * done), uniform)));
    }
    population = std::move(next);
    std::sort(population.begin(), population.end(), fitter);
  }
  return descend(problem, settings, population.front().genes);
}

}  // namespace fogcomp::network
