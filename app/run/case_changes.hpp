#pragma once

#include <string>
#include <vector>

namespace ligament {

/// A key of a case that has another value than before.
struct CaseChange {
  std::string key;     ///< as --set names it
  std::string before;  ///< TOML; "not given" where there is none
  std::string now;
};

/// What differs between two cases, given as CaseFile::resolved_text() writes them, in the order of the second.
std::vector<CaseChange> case_changes(const std::string& before, const std::string& now);

/// Keys that may differ between run and resume: they decide what is written, and when the run ends, but no bit of any
/// state of it.
const std::vector<std::string>& changeable_keys();

/// Throws InputError, naming each other key with both values, if more than those differ.
void require_same_run(const std::string& before, const std::string& now);

}  // namespace ligament
