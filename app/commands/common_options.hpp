#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace ligament {

/// --set KEY=VALUE, repeatable.
void add_set_option(CLI::App& command, std::vector<std::string>& overrides,
                    const std::string& description = "key=value instead of what the case says; repeatable");

/// --threads N.
void add_threads_option(CLI::App& command, int& n_threads);

}  // namespace ligament
