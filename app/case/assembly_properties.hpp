#pragma once

#include "case/case.hpp"

namespace ligament {

/// Turns a case of the kind "assembly_properties" into walls, motions and gauges: the zone between four smooth walls
/// that hold it along their normals, compressed along x in stage 1 and along y as well in stage 2. Errors are added to
/// the case file.
void set_up_assembly_properties(Case& input);

/// What the test measures.
struct AssemblyProperties {
  double young_modulus_x = 0.0;  ///< E_x (Pa)
  double young_modulus_y = 0.0;  ///< E_y (Pa)
  double poisson_ratio_x = 0.0;  ///< ν_x = -ε_y/ε_x under σ_x alone
  double poisson_ratio_y = 0.0;  ///< ν_y = -ε_x/ε_y under σ_y alone
};
/// From the forces and displacements of the walls.
AssemblyProperties wall_properties(const Case& input, const std::vector<double>& readings);
/// From mean stress and strain of the gauge region. `readings` are those of all gauges at the ends of both stages.
AssemblyProperties region_properties(const std::vector<double>& readings);

}  // namespace ligament
