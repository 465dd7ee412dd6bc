#pragma once

#include <stdexcept>
#include <string>

namespace ligament {

/// What the program answers to the shell.
enum class ExitCode : int {
  done = 0,
  comparison_differs = 1,
  wrong_input = 2,
  audit_failed = 3,
  diverged = 4,
  file_error = 5,
  not_converged = 6,
  unreachable_target = 7,
  interrupted = 130,
  terminated = 143,
};

/// A failure the user can act on. The message says what is wrong and what would do; the code goes to the shell.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  [[nodiscard]] ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// The case file or the command line asks for something that cannot be done.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(ExitCode::wrong_input, message) {}
};

/// A file could not be read or written, or its content is damaged.
class FileError : public Error {
 public:
  explicit FileError(const std::string& message) : Error(ExitCode::file_error, message) {}
};

/// The motion left the range in which the model means anything.
class DivergenceError : public Error {
 public:
  explicit DivergenceError(const std::string& message) : Error(ExitCode::diverged, message) {}
};

}  // namespace ligament
