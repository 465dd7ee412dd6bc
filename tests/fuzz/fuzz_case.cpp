#include <cstddef>
#include <cstdint>
#include <string>

#include "case/case.hpp"
#include "core/error.hpp"

/// Any text as a case file: it is read, or refused with an Error; what is read is written out and reads back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ligament;
  const InputFiles no_files("/nonexistent");
  std::string resolved;
  try {
    const std::string text(reinterpret_cast<const char*>(data), size);
    resolved = read_case(CaseFile::parse(text, "case.toml"), no_files).file.resolved_text();
  } catch (const Error&) {
    return 0;
  }
  // An Error here is a finding, and ends the harness.
  const Case again = read_case(CaseFile::parse(resolved, "resolved.toml"), no_files);
  if (again.file.resolved_text() != resolved) __builtin_trap();
  return 0;
}
