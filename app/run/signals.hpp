#pragma once

namespace ligament {

/// Signals that came since the last question; they are acted on at step boundaries.
enum class Request { none, checkpoint, stop_by_interrupt, stop_by_termination };

/// From now on SIGINT and SIGTERM ask to stop, SIGUSR1 for a checkpoint.
void install_signal_handlers();

/// A file that grows too large is an error of its write, not a signal that kills.
void ignore_file_size_signal();

/// Whether a signal has asked to stop.
bool is_stop_requested();

/// What was asked for; a stop counts more than a checkpoint, and stays.
Request take_request();

}  // namespace ligament
