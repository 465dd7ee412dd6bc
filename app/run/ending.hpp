#pragma once

namespace ligament {

/// How a run ended; summary.json says it in these words. Terminated is an interruption, too.
enum class Ending { converged, completed, stopped, interrupted, terminated, not_converged, diverged };

}  // namespace ligament
