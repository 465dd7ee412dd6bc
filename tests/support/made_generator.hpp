#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/parameters.hpp"
#include "generation/register_generators.hpp"

namespace ligament::support {

/// A generator with these parameters, in SI units, unchecked.
inline std::unique_ptr<Generator> made_generator(const std::string& name,
                                                 const std::vector<std::pair<std::string, ParameterValue>>& values) {
  auto generator = generators().create(name);
  Parameters parameters;
  generator->declare(parameters);
  for (const auto& value : values) {
    const auto found = std::find_if(parameters.list().begin(), parameters.list().end(),
                                    [&](const Parameter& parameter) { return parameter.name == value.first; });
    REQUIRE_MESSAGE(found != parameters.list().end(), value.first);
    found->assign(value.second);
  }
  return generator;
}

inline const ReportEntry& entry_of(const std::vector<ReportEntry>& report, const std::string& name) {
  const auto found =
      std::find_if(report.begin(), report.end(), [&](const ReportEntry& entry) { return entry.name == name; });
  REQUIRE_MESSAGE(found != report.end(), name);
  return *found;
}

inline double value_of(const std::vector<ReportEntry>& report, const std::string& name) {
  return entry_of(report, name).value;
}

}  // namespace ligament::support
