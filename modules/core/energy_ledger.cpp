#include "core/energy_ledger.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ligament {

void EnergyBalance::add(const EnergyTerm& term) {
  switch (term.kind) {
    case EnergyKind::kinetic:
      kinetic += term.value;
      break;
    case EnergyKind::elastic:
      elastic += term.value;
      break;
    case EnergyKind::dissipated:
      dissipated += term.value;
      break;
    case EnergyKind::work:
      work += term.value;
      break;
  }
}

Index EnergyLedger::open(std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<Index>(found - names.begin());
  names.emplace_back(name);
  sums.emplace_back();
  return static_cast<Index>(sums.size() - 1);
}

double EnergyLedger::total(std::string_view name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? 0.0 : sums[static_cast<std::size_t>(found - names.begin())].total();
}

double EnergyLedger::audit(const EnergyBalance& balance) {
  const double defect = std::abs(balance.defect());
  // A balance that is not a number must not pass for a small one, nor make all later ones look small.
  if (!std::isfinite(defect)) return largest_error = std::numeric_limits<double>::infinity();
  scale = std::max({scale, std::abs(balance.work), balance.elastic, balance.kinetic});
  if (scale == 0.0) return 0.0;
  const double error = defect / scale;
  largest_error = std::max(largest_error, error);
  return error;
}

}  // namespace ligament
