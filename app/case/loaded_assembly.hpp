#pragma once

#include <memory>
#include <string>

#include "case/input_files.hpp"
#include "core/generator.hpp"

namespace ligament {

/// Discs from a file: one that `ligament generate` has written, or a list from elsewhere.
class LoadedAssembly : public Generator {
 public:
  /// `zone` is the name of the zone to be filled.
  LoadedAssembly(std::shared_ptr<InputFiles> files, std::string zone)
      : files_(std::move(files)), zone_(std::move(zone)) {}

  void declare(Parameters& parameters) override;
  [[nodiscard]] bool depends_on_seed() const override { return false; }
  /// Throws InputError if the file cannot be read, or holds what is no disc of the region.
  [[nodiscard]] Packing generate(const Rectangle& region, std::uint64_t seed) const override;
  [[nodiscard]] double default_detection_gap() const override { return 0.0; }
  [[nodiscard]] double default_interface_gap() const override { return 0.0; }

 private:
  std::shared_ptr<InputFiles> files_;
  std::string zone_;
  std::string path_;
};

}  // namespace ligament
