#include <fmt/format.h>

#include <memory>

#include "case/case.hpp"
#include "commands/commands.hpp"
#include "constitutive/register_laws.hpp"

namespace ligament {
namespace {

ExitCode list_laws() {
  const auto laws = contact_laws();
  for (const std::string& name : laws.names()) fmt::print("{:<24} {}\n", name, laws.description(name));
  return ExitCode::done;
}

}  // namespace

void add_documentation_commands(CLI::App& app, Action& action) {
  app.add_subcommand("laws", "the contact laws there are")->callback([&action] { action = list_laws; });

  auto key = std::make_shared<std::string>();
  CLI::App* explain_command = app.add_subcommand("explain", "what a key of the case file means");
  explain_command->add_option("key", *key, "such as zone.radius, solver or young_modulus")
      ->required()
      ->type_name("KEY");
  explain_command->callback([key, &action] {
    action = [key] {
      fmt::print("{}\n", explain(describe_case(), *key));
      return ExitCode::done;
    };
  });

  app.add_subcommand("schema", "JSON Schema of case files")->callback([&action] {
    action = [] {
      fmt::print("{}\n", json_schema(describe_case()));
      return ExitCode::done;
    };
  });
  app.add_subcommand("reference", "all keys of case files, as Markdown")->callback([&action] {
    action = [] {
      fmt::print("{}", markdown_reference(describe_case()));
      return ExitCode::done;
    };
  });
}

}  // namespace ligament
