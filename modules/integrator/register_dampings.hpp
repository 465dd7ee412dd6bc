#pragma once

#include "core/integrator.hpp"
#include "core/registry.hpp"

namespace ligament {

/// The ways of damping, by the name of the solver method that uses them.
Registry<Damping> dampings();

}  // namespace ligament
