#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// All fields of the state as a Boost.Serialization archive: flat arrays, no pointers, no tracking. The archive takes
/// the memory of `used`: that of an earlier one spares the system from finding as much anew.
std::string save_state(const State& state, std::string used = {});

/// Number of entries of every array of the state, in the order of visit_fields().
using ArrayLengths = std::vector<std::pair<std::string, std::uint64_t>>;
ArrayLengths array_lengths(const State& state);

/// Reads an archive into a state that was built from the same case. The lengths are compared with the model before the
/// archive is touched, and its contents afterwards. Throws FileError, saying what does not fit.
void load_state(const std::string& archive, const ArrayLengths& lengths, const Model& model, State& state);

/// Reads an archive whose case is not known, to look at the state or to compare it.
State load_unknown_state(const std::string& archive, const ArrayLengths& lengths);

}  // namespace ligament
