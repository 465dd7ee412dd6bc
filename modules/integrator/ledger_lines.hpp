#pragma once

/// Lines of the ledger that more than one class books on.
namespace ligament::ledger_lines {

inline constexpr const char* damping = "damping";
inline constexpr const char* applied_loads = "applied_loads";
inline constexpr const char* prescribed_motions = "prescribed_motions";

}  // namespace ligament::ledger_lines
