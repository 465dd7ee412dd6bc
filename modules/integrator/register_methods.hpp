#pragma once

#include "core/integrator.hpp"
#include "core/registry.hpp"

namespace ligament {

/// The ways of stepping, by the name of the solver method.
Registry<Integrator> solver_methods();

}  // namespace ligament
