#include "integrator/spring_equilibrium.hpp"

// One thread: others would only wait for each other.
#define EIGEN_DONT_PARALLELIZE
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "integrator/adaptive_momenta.hpp"

namespace ligament {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr int most_iterations = 500;

/// Iterations with one mass, unless a spring becomes stiffer by more than this share of k.
constexpr int most_uses = 20;
constexpr double stiffer = 0.3;

/// Springs that have lost less than this share of k are left with k.
constexpr double least_change = 0.05;

/// Of the mean k: less is taken for nothing, since what has come apart may touch again.
constexpr double least_share = 0.01;

Eigen::Map<const Vector> view(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// A sum is that of eight, each of every eighth term: the same with any width of vectors.
[[gnu::target_clones("avx512f", "avx2", "default")]] void find_stretches(const double* flexibility, Eigen::Index size,
                                                                         const double* pulls, const Eigen::Index* rows,
                                                                         std::size_t n_rows, double* stretches) {
  constexpr Eigen::Index n_lanes = 8;
  for (std::size_t k = 0; k < n_rows; ++k) {
    const double* row = flexibility + rows[k] * size;
    double sums[n_lanes] = {};
    Eigen::Index j = 0;
    for (; j + n_lanes <= size; j += n_lanes) {
      for (Eigen::Index lane = 0; lane < n_lanes; ++lane) sums[lane] += row[j + lane] * pulls[j + lane];
    }
    for (Eigen::Index lane = 0; j < size; ++j, ++lane) sums[lane] += row[j] * pulls[j];
    double sum = 0.0;
    for (const double part : sums) sum += part;
    stretches[rows[k]] = -sum;
  }
}

class SpringRelaxation {
 public:
  explicit SpringRelaxation(const SpringProblem& problem)
      : problem_(problem),
        size_(static_cast<Eigen::Index>(problem.aim.size())),
        flexibility_(problem.flexibility.data(), size_, size_),
        reference_(view(problem.reference)),
        least_(least_share * reference_.mean()),
        excess_(Vector::Zero(size_)),
        stretch_(view(problem.aim)),
        secants_(size_),
        forces_(problem.aim.size()),
        momenta_(problem.aim.size(), 0.0),
        all_(problem.aim.size()) {
    std::iota(all_.begin(), all_.end(), Eigen::Index{0});
    evaluate();
  }

  [[nodiscard]] double largest_force() const {
    double largest = 0.0;
    for (const double force : forces_) {
      if (!std::isfinite(force)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, std::abs(force));
    }
    return largest;
  }
  [[nodiscard]] std::vector<double> excess() const { return {excess_.data(), excess_.data() + size_}; }

  void step() {
    if (n_uses_ == most_uses || n_uses_ == 0 ||
        (n_uses_ > 0 && (secants_ - used_ - stiffer * reference_).maxCoeff() > 0.0)) {
      make_mass();
    }
    ++n_uses_;
    update_momenta(momenta_, forces_, damping_);
    Vector change = -2.0 * view(momenta_);
    // Springs that keep to k answer by themselves.
    Vector others = change;
    for (const Eigen::Index i : changed_) others[i] = 0.0;
    Vector motion(size_);
    if (!changed_.empty()) {
      answer_to(others, changed_, motion);
      const Vector found = mass_.solve(change(changed_) + in_mass_.cwiseProduct(motion(changed_)));
      change(changed_) = found;
    }
    answer_to(change, all_, motion);
    excess_ += change;
    stretch_ += motion;
    const std::vector<double> before = forces_;
    evaluate();
    damping_ = adaptive_damping({motion.data(), motion.data() + size_}, momenta_, forces_, before, DampingBounds{});
  }

 private:
  /// Stretches of some springs by the pulls of all.
  void answer_to(const Vector& pulls, const std::vector<Eigen::Index>& springs, Vector& stretches) const {
    find_stretches(flexibility_.data(), size_, pulls.data(), springs.data(), springs.size(), stretches.data());
  }

  void evaluate() {
    for (Eigen::Index i = 0; i < size_; i += 2) {
      const SpringAnswer answer = problem_.answer(static_cast<std::size_t>(i / 2), {stretch_[i], stretch_[i + 1]});
      for (std::size_t side = 0; side < 2; ++side) {
        const Eigen::Index k = i + static_cast<Eigen::Index>(side);
        const auto row = static_cast<std::size_t>(k);
        secants_[k] = std::max(answer.secant[side], least_);
        forces_[row] = excess_[k] -
                       (answer.pull[side] - problem_.pull[row] - reference_[k] * (stretch_[k] - problem_.stretch[row]));
      }
    }
  }

  void make_mass() {
    changed_.clear();
    for (Eigen::Index i = 0; i < size_; ++i) {
      const double change = secants_[i] - reference_[i];
      if (change > 0.1 * least_ || change < -least_change * reference_[i]) changed_.push_back(i);
    }
    used_ = secants_;
    in_mass_ = (secants_ - reference_)(changed_);
    const auto count = static_cast<Eigen::Index>(changed_.size());
    mass_.compute(Matrix::Identity(count, count) + in_mass_.asDiagonal() * Matrix(flexibility_(changed_, changed_)));
    n_uses_ = 0;
  }

  const SpringProblem& problem_;
  Eigen::Index size_;
  Eigen::Map<const Matrix> flexibility_;
  Vector reference_;
  double least_;
  Vector excess_;   ///< q
  Vector stretch_;  ///< e
  Vector secants_;
  std::vector<double> forces_;  ///< f
  std::vector<double> momenta_;
  std::vector<Eigen::Index> all_;  ///< springs
  double damping_ = 2.0;           // at rest the first half of the step has no time to act
  // The mass: that of k but for the springs that have changed.
  std::vector<Eigen::Index> changed_;
  Vector in_mass_;  ///< Δ of these
  Eigen::PartialPivLU<Matrix> mass_;
  Vector used_;  ///< secants when it was made
  int n_uses_ = 0;
};

}  // namespace

std::optional<std::vector<double>> solve_springs(const SpringProblem& problem, double tolerance) {
  SpringRelaxation relaxation(problem);
  for (int i = 0; i < most_iterations; ++i) {
    const double largest = relaxation.largest_force();
    if (largest <= tolerance) return relaxation.excess();
    // Far from any force that a contact can bear it will not come back.
    if (!(largest < 1e12 * tolerance)) break;
    relaxation.step();
  }
  return {};
}

}  // namespace ligament
