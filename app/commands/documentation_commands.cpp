#include <fmt/format.h>

#include <memory>

#include "case/case.hpp"
#include "commands/commands.hpp"
#include "commands/law_curves.hpp"
#include "constitutive/register_laws.hpp"

namespace ligament {
namespace {

ExitCode list_laws() {
  const auto laws = contact_laws();
  for (const std::string& name : laws.names()) fmt::print("{:<24} {}\n", name, laws.description(name));
  return ExitCode::done;
}

struct LawsOptions {
  std::string law;
  std::string case_path;
  CurveContact contact;
};

void add_laws_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<LawsOptions>();
  CLI::App* command = app.add_subcommand("laws", "the contact laws there are, or the curves of one");
  auto* case_option = command->add_option("case", options->case_path, "case file (TOML)")->type_name("FILE");
  auto* curve = command->add_option("--curve", options->law, "force over opening and over slip, as CSV, of a bond")
                    ->type_name("LAW")
                    ->needs(case_option);
  case_option->needs(curve);
  command->add_option("--height", options->contact.height, "height H of the contact (m)")
      ->check(CLI::PositiveNumber)
      ->needs(curve)
      ->capture_default_str();
  command->add_option("--length", options->contact.length, "length L of the contact (m)")
      ->check(CLI::PositiveNumber)
      ->needs(curve)
      ->capture_default_str();
  command->callback([options, &action] {
    action = [options] {
      if (options->law.empty()) return list_laws();
      Case input = read_case(options->case_path, {});
      fmt::print("{}", law_curves(input, options->law, options->contact));
      return ExitCode::done;
    };
  });
}

}  // namespace

void add_documentation_commands(CLI::App& app, Action& action) {
  add_laws_command(app, action);

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
