#pragma once

#include "core/constitutive_law.hpp"
#include "core/registry.hpp"

namespace ligament {

/// All contact laws by name. The list is explicit: statics that register themselves are dropped from static libraries.
Registry<ConstitutiveLaw> contact_laws();

}  // namespace ligament
