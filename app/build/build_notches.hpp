#pragma once

#include <vector>

#include "case/case.hpp"
#include "core/model.hpp"

namespace ligament {

/// The notches of a case. Errors, notches that cut into elements among them, are added to the case file.
std::vector<Notch> build_notches(Case& input);

/// The elements inside of slits, which have them on their account from now on.
std::vector<Rectangle> take_elements(const Case& input, std::vector<Notch>& notches);

/// Adds an error to the case file for every notch that neither cut a contact of the model nor took anything away.
void refuse_idle_notches(Case& input, const Model& model);

}  // namespace ligament
