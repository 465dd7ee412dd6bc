#pragma once

#include "case/case.hpp"
#include "core/model.hpp"

namespace ligament {

/// Adds the beams of a case, whose materials the model has already. What is wrong becomes an error of the case file.
void add_beams(Case& input, Model& model);

}  // namespace ligament
