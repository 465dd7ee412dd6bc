#pragma once

#include "core/integrator.hpp"
#include "core/registry.hpp"
#include "integrator/incremental_loading.hpp"

namespace ligament {

/// The ways of stepping, by the name of the solver method.
Registry<Integrator> solver_methods();
/// The ways of quasi-static loading in increments, likewise.
Registry<IncrementalLoading> loading_methods();

}  // namespace ligament
