// Particle swarm (Kennedy & Eberhart, ICNN 1995; inertia: Shi & Eberhart, ICEC 1998) over all
// weights and biases, then gradient descent from the best particle.
#include <algorithm>
#include <vector>

#include "network/trainer_parts.hpp"

namespace fogcomp::network {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kOwn = 2;              // c1
constexpr double kSocial = 2;           // c2
constexpr double kFirstInertia = 0.9;   // decreases linearly ...
constexpr double kLastInertia = 0.4;    // ... to this
constexpr double kMaxVelocity = 0.3;    // per weight and iteration
constexpr double kFirstVelocity = 0.1;  // per weight, at most

struct Particle {
  VectorXd place;
  VectorXd velocity;
  VectorXd best_place;
  double best = 0;
};

std::vector<Particle> first_swarm(const TrainingProblem& problem, const TrainerSettings& settings,
                                  Uniform& uniform) {
  std::vector<Particle> swarm(static_cast<std::size_t>(settings.particles));
  for (std::size_t i = 0; i < swarm.size(); ++i) {
    Particle& particle = swarm[i];
    // The first particle starts like traingdx, so that the swarm starts no worse.
    particle.place = problem.shape.first_weights(settings.seed + i);
    particle.velocity.resize(particle.place.size());
    for (double& v : particle.velocity) v = uniform.within(kFirstVelocity);
    particle.best_place = particle.place;
    particle.best = problem.rows->mean_square(problem.shape, particle.place);
  }
  return swarm;
}

void move(Particle& particle, const VectorXd& leader, double inertia, Uniform& uniform) {
  for (Index d = 0; d < particle.place.size(); ++d) {
    const double own = kOwn * uniform.unit() * (particle.best_place[d] - particle.place[d]);
    const double social = kSocial * uniform.unit() * (leader[d] - particle.place[d]);
    particle.velocity[d] =
        std::clamp(inertia * particle.velocity[d] + own + social, -kMaxVelocity, kMaxVelocity);
  }
  particle.place += particle.velocity;
}

const Particle& leader_of(const std::vector<Particle>& swarm) {
  return *std::min_element(swarm.begin(), swarm.end(),
                           [](const Particle& a, const Particle& b) { return a.best < b.best; });
}

}  // namespace

TrainerResult train_particle_swarm(const TrainingProblem& problem,
                                   const TrainerSettings& settings) {
  Uniform uniform(settings.seed);
  std::vector<Particle> swarm = first_swarm(problem, settings, uniform);
  for (int iteration = 0; iteration < settings.iterations; ++iteration) {
    const double done = static_cast<double>(iteration) / settings.iterations;
    if (settings.go_on && !settings.go_on(done)) break;
    const double inertia = kFirstInertia + (kLastInertia - kFirstInertia) * done;
    const VectorXd leader = leader_of(swarm).best_place;
    for (Particle& particle : swarm) {
      move(particle, leader, inertia, uniform);
      const double cost = problem.rows->mean_square(problem.shape, particle.place);
      if (!(cost < particle.best)) continue;
      particle.best = cost;
      particle.best_place = particle.place;
    }
  }
  return descend(problem, settings, leader_of(swarm).best_place);
}

}  // namespace fogcomp::network
