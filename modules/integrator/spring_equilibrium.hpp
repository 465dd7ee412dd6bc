#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/contact_trial.hpp"

namespace ligament {

/// Contacts in a structure that is linear but for them. Their springs come in pairs.
struct SpringProblem {
  std::vector<double> reference;    ///< stiffness k that the structure takes the springs to have (N/m)
  std::vector<double> stretch;      ///< e_0: where they are (m)
  std::vector<double> pull;         ///< t_0: their forces there (N)
  std::vector<double> aim;          ///< where they would come if they kept to k (m)
  std::vector<double> flexibility;  ///< F, row by row: how far they come back from there if they pull more (m/N)
  /// The law of a pair, from its stretch.
  std::function<SpringAnswer(std::size_t pair, const SpringPair& stretch)> answer;
};

/// What the springs pull more at equilibrium than k makes of it (N),
///   q = t(e) - t_0 - k (e - e_0) with e = aim - F q,
/// to a tolerance. Found with momenta π of the out-of-balance forces f = q - [t(e) - t_0 - k (e - e_0)],
///   π ← [(2 - c) π + 2 f]/(2 + c),   (1 + Δ F) δq = -2 π,
/// where Δ are the secants of the springs less k: the mass is half of the stiffness that they show. Damping c as in
/// MomentumRelaxation. Nothing if it does not settle.
std::optional<std::vector<double>> solve_springs(const SpringProblem& problem, double tolerance);

}  // namespace ligament
