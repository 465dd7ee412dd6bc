#pragma once

#include "integrator/increment.hpp"

namespace ligament {

/// Lines of the ledger that increments of loading book on.
inline constexpr const char* released_line = "released";

/// Books what an increment that has come to its equilibrium has done. Work of platens and loads is booked along states
/// of equilibrium, as of a load-displacement curve. The work of resultants on free bodies along the line from the last
/// equilibrium to this one, above all the energy that is set free at a jump, is a line of its own, "released".
/// `fewest_intervals`: of that line.
void book_increment_work(Increment& increment, std::size_t fewest_intervals);

}  // namespace ligament
