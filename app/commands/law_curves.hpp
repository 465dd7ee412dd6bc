#pragma once

#include <string>

#include "case/case.hpp"

namespace ligament {

/// The contact whose curves are asked for (m); the thickness is that of the case.
struct CurveContact {
  double height = 1e-3;  ///< H
  double length = 1e-3;  ///< L
};

/// Force over opening and force over slip of a bond, from nothing to its break (CSV: curve, displacement_m, force_N),
/// with the first material of the case that has the law called `name`. Bonds that a displacement of L does not break
/// are drawn to there. Throws InputError if no material has the law, or if such a contact would snap back.
std::string law_curves(Case& input, const std::string& name, const CurveContact& contact);

}  // namespace ligament
