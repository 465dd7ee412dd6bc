#pragma once

#include <string>

#include "core/parameters.hpp"
#include "io/case_errors.hpp"
#include "io/case_node.hpp"

namespace ligament {

/// Reads the parameters from the entries of a table into their members. What is wrong is added to the errors and leaves
/// the member as it was. Entries that are no parameter are not looked at.
///
/// `where` ends the messages: "in [problem]"; `position` is the table's, for what is missing.
void read_entries(const CaseNode& table, Parameters& parameters, const std::string& where,
                  const SourcePosition& position, CaseErrors& errors);

/// Adds an error for every entry of the table that is not among the known names.
void report_unknown_keys(const CaseNode& table, const std::vector<std::string>& known, const std::string& where,
                         CaseErrors& errors);

/// `missing key 'law' in [material.concrete]`.
[[nodiscard]] std::string missing_key(const std::string& key, const std::string& where);

}  // namespace ligament
