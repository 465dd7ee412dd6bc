#include "case/all_generators.hpp"

#include "case/loaded_assembly.hpp"
#include "generation/register_generators.hpp"

namespace ligament {

Registry<Generator> all_generators(const std::shared_ptr<InputFiles>& files, const std::string& zone) {
  Registry<Generator> all = generators();
  all.add("file", "discs from a file", [files, zone] { return std::make_unique<LoadedAssembly>(files, zone); });
  return all;
}

}  // namespace ligament
