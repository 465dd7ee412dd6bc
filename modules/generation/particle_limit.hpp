#pragma once

namespace ligament {

/// Throws InputError if a generator is asked for more particles than a machine of today could step: a radius in the
/// wrong unit is the usual reason, and is better told than tried.
void check_particle_count(double count);

}  // namespace ligament
