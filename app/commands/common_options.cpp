#include "commands/common_options.hpp"

namespace ligament {

void add_set_option(CLI::App& command, std::vector<std::string>& overrides, const std::string& description) {
  command.add_option("--set", overrides, description)->type_name("KEY=VALUE")->take_all()->allow_extra_args(false);
}

void add_threads_option(CLI::App& command, int& n_threads) {
  command.add_option("--threads", n_threads, "number of threads; the results do not depend on it; default 1")
      ->check(CLI::Range(1, 1024));
}

}  // namespace ligament
