#include "version.hpp"

namespace ligament {

std::string program_version() { return LIGAMENT_VERSION; }

std::string program_build() {
#ifdef LIGAMENT_AUDIT
  return std::string(LIGAMENT_BUILD) + "+audit";
#else
  return LIGAMENT_BUILD;
#endif
}

std::string program_compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

}  // namespace ligament
