#pragma once

#include "case/case.hpp"
#include "core/model.hpp"

namespace ligament {

/// What a generator said of its zone.
struct ZoneReport {
  std::string zone;
  std::vector<ReportEntry> entries;
};

/// Materials, laws, elements and particles of a case; the contacts come later, with the state. Errors are added to the
/// case file and thrown together.
struct BuiltModel {
  Model model;
  std::vector<ZoneReport> reports;
};
BuiltModel build_model(Case& input);

/// The row of a material of the model by its name, which must exist.
Index material_row(const Model& model, const std::string& name);

}  // namespace ligament
