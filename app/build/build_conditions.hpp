#pragma once

#include "case/case.hpp"
#include "core/model.hpp"
#include "integrator/loads.hpp"
#include "integrator/prescribed_motion.hpp"

namespace ligament {

/// What supports, motions and loads of a case ask of its bodies.
struct Conditions {
  std::vector<PrescribedFreedom> freedoms;
  std::vector<PointLoad> loads;
  /// Of every stage, the times at which its loads and motions change their course (s after its beginning, ascending).
  /// From the last one on they no longer change; it is infinite if a motion never stops.
  std::vector<std::vector<double>> corners{{0.0}};
  std::vector<std::string> warnings;
};

/// The last corner of every stage.
std::vector<double> ends_of_loading(const std::vector<std::vector<double>>& corners);

/// Finds the bodies; those that do not exist, and freedoms prescribed twice, become errors of the case file.
Conditions build_conditions(Case& input, const Model& model);

}  // namespace ligament
