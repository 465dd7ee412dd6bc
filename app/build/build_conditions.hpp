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
  /// Of every stage, from when on its loads and motions no longer change (s after its beginning); infinite if a motion
  /// never stops.
  std::vector<double> end_of_loading{0.0};
  std::vector<std::string> warnings;
};

/// Finds the bodies; those that do not exist, and freedoms prescribed twice, become errors of the case file.
Conditions build_conditions(Case& input, const Model& model);

}  // namespace ligament
