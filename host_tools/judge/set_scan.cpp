#include "judge/set_scan.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace fogcomp::judge {
namespace {

class SetScan {
 public:
  SetScan(const Rivals& rivals, const Likelihood& likelihood, const Setting& setting,
          const std::vector<Part>& parts, const Eigen::MatrixXd& products)
      : rivals_(rivals), likelihood_(likelihood), setting_(setting), cross_(products) {
    for (const Part& part : parts) places_.push_back(rivals.shapes()[rivals.number_of(part)]);
    const std::vector<Eigen::Index> columns = rivals.columns_of(parts);
    if (setting.smooth_number > 0) {
      const Eigen::MatrixXd& in_effects = setting.noise->smooth_in_effects;
      const Eigen::MatrixXd shrunk = setting.shrink.asDiagonal() * in_effects(Eigen::all, columns);
      cross_ -= shrunk.transpose() * in_effects;
    }
    own_ = cross_(Eigen::all, columns);
    with_drift_ = setting.with_drift(columns);
  }

  void add(double floor, Evidence& of_shapes) const {
    const Eigen::ArrayXd least_left = left_of_any_sizes();
    if (likelihood_(setting_.log_density, least_left.minCoeff()) < floor) return;
    const std::vector<Sized> all = all_sizes();
    const auto likely = [&](const Sized& set) { return likelihood_(set.log_density, set.left); };
    double best = -HUGE_VAL;
    for (const Sized& set : all) best = std::max(best, likely(set));
    for (const Sized& set : all) {
      if (likely(set) >= best - kHopeless) add_to(set, least_left, floor, of_shapes);
    }
  }

 private:
  // The set with certain sizes.
  struct Sized {
    double largest = 0;
    Eigen::MatrixXd inverse_root;  // of its products
    Eigen::VectorXd coefficients;
    double log_density = 0;
    double left = 0;
  };
  std::vector<Sized> all_sizes() const {
    const std::vector<double>& values = likelihood_.sizes();
    std::size_t count = 1;
    for (std::size_t p = 0; p < places_.size(); ++p) count *= values.size();
    std::vector<Sized> all;
    for (std::size_t number = 0; number < count; ++number) {
      Eigen::VectorXd precision(own_.cols());
      double largest = 0;
      std::size_t sizes = number;  // of the parts, the first by its remainder
      Eigen::Index first = 0;
      for (const Place& place : places_) {
        const double size = values[sizes % values.size()];
        sizes /= values.size();
        precision.segment(first, place.count)
            .setConstant(static_cast<double>(place.count) / (size * size));
        largest = std::max(largest, size);
        first += place.count;
      }
      all.push_back(sized(precision, -precision.array().log().sum(), largest));
    }
    return all;
  }

  // `precision`: inverse of each coefficient's variance.
  Sized sized(const Eigen::VectorXd& precision, double log_determinant, double largest) const {
    Eigen::MatrixXd own = own_;
    own.diagonal() += precision;
    const Eigen::LLT<Eigen::MatrixXd> solved(own);
    const Eigen::MatrixXd root = solved.matrixL();
    const Eigen::VectorXd coefficients = solved.solve(with_drift_);
    return {largest,
            root.triangularView<Eigen::Lower>().solve(
                Eigen::MatrixXd::Identity(own.rows(), own.cols())),
            coefficients,
            setting_.log_density - log_determinant / 2 - root.diagonal().array().log().sum(),
            setting_.left - with_drift_.dot(coefficients)};
  }

  // What the set and each shape more leave at least, as with the largest sizes: columns together
  // explain at most a half more than each alone.
  Eigen::ArrayXd left_of_any_sizes() const {
    const double least = likelihood_.least_precision();
    const Sized set = sized(Eigen::VectorXd::Constant(own_.cols(), least), 0, 0);
    const Eigen::VectorXd with_drift =
        setting_.with_drift - cross_.transpose().lazyProduct(set.coefficients);
    const Eigen::MatrixXd in_effects = set.inverse_root.lazyProduct(cross_);
    const Eigen::ArrayXd square =
        setting_.square.array() - in_effects.colwise().squaredNorm().transpose().array();
    const Eigen::ArrayXd gain = with_drift.array().square() / (square.max(0) + least);
    Eigen::ArrayXd left(static_cast<Eigen::Index>(rivals_.shapes().size()));
    for (Eigen::Index i = 0; i < left.size(); ++i) {
      const auto [first, count] = rivals_.shapes()[static_cast<std::size_t>(i)];
      left[i] = set.left - (count == 1 ? 1 : 1.5) * gain.segment(first, count).sum();
    }
    return left;
  }

  void add_to(const Sized& set, const Eigen::ArrayXd& least_left, double floor,
              Evidence& of_shapes) const {
    const double log_density =
        set.log_density - static_cast<double>(places_.size()) *
                              std::log(static_cast<double>(likelihood_.sizes().size()));
    const double most_left = likelihood_.left_for(log_density, floor);
    const std::vector<Beside> priors =
        likelihood_.priors_of_sizes(setting_.smooth_number, set.largest);
    Eigen::MatrixXd in_set;
    Eigen::MatrixXd own;
    Eigen::VectorXd with_drift;
    for (std::size_t i = 0; i < of_shapes.size(); ++i) {
      if (least_left[static_cast<Eigen::Index>(i)] > most_left) continue;
      const Place& place = rivals_.shapes()[i];
      const auto cross = cross_.middleCols(place.first, place.count);
      in_set = set.inverse_root.lazyProduct(cross);
      own = place.within(setting_.own) - in_set.transpose().lazyProduct(in_set);
      with_drift = setting_.with_drift.segment(place.first, place.count) -
                   cross.transpose().lazyProduct(set.coefficients);
      likelihood_.add_average(priors, log_density, set.left, own, with_drift, of_shapes[i]);
    }
  }

  const Rivals& rivals_;
  const Likelihood& likelihood_;
  const Setting& setting_;
  std::vector<Place> places_;   // of the set's parts
  Eigen::MatrixXd cross_;       // set's columns x all
  Eigen::MatrixXd own_;         // set's columns
  Eigen::VectorXd with_drift_;  // set's columns
};

}  // namespace

void scan_set(const Rivals& rivals, const Likelihood& likelihood, const Setting& setting,
              const std::vector<Part>& parts, const Eigen::MatrixXd& products, double floor,
              Evidence& of_shapes) {
  SetScan(rivals, likelihood, setting, parts, products).add(floor, of_shapes);
}

}  // namespace fogcomp::judge
