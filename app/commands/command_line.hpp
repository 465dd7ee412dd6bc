#pragma once

namespace ligament {

/// Reads the command line, carries it out, and turns what goes wrong into a message and an exit code.
int run_command_line(int argc, char** argv);

}  // namespace ligament
