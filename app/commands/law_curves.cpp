#include "commands/law_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/contact_stiffness.hpp"
#include "core/error.hpp"

namespace ligament {
namespace {

/// One bond and its law, moved once or in steps from rest.
class TestBond {
 public:
  TestBond(const ConstitutiveLaw& law, const ContactStiffness& springs) : law_(law), springs_(springs) {
    for (const HistoryVariable& variable : law.history()) history_.push_back(variable.initial_value);
  }

  void move(double opened, ShearVector slipped) {
    opening_ += opened;
    std::vector<double*> history;
    for (double& value : history_) history.push_back(&value);
    law_.evaluate({one(opening_), one(slipped), one(springs_.normal), one(springs_.shear), one(springs_.area),
                   one(normal_force_), one(shear_force_), one(bond_), history});
  }
  [[nodiscard]] bool is_broken() const { return bond_ == BondState::broken; }
  /// Against opening and slip (N).
  [[nodiscard]] double resistance() const { return std::abs(normal_force_) + std::abs(shear_force_); }

 private:
  template <class T>
  static std::span<T> one(T& value) {
    return {&value, 1};
  }

  const ConstitutiveLaw& law_;
  ContactStiffness springs_;
  double opening_ = 0.0;
  double normal_force_ = 0.0;
  ShearVector shear_force_ = 0.0;
  BondState bond_ = BondState::bonded;
  std::vector<double> history_;
};

/// A displacement of 1, as opening and as slip.
struct Direction {
  const char* name;
  double opening;
  double slip;
};

bool breaks(const TestBond& at_rest, const Direction& direction, double displacement) {
  TestBond bond = at_rest;
  bond.move(direction.opening * displacement, direction.slip * displacement);
  return bond.is_broken();
}

/// The displacement that breaks a bond, to 0.1 %; `longest` if that does not.
double breaking_displacement(const TestBond& at_rest, const Direction& direction, double longest) {
  if (!breaks(at_rest, direction, longest)) return longest;
  double low = 0.0;
  double high = longest;
  while (high - low > 1e-3 * high) {
    const double middle = 0.5 * (low + high);
    (breaks(at_rest, direction, middle) ? high : low) = middle;
  }
  return high;
}

void append_curve(std::string& text, const TestBond& at_rest, const Direction& direction, double longest) {
  constexpr int n_points = 200;
  const double step = breaking_displacement(at_rest, direction, longest) / n_points;
  TestBond bond = at_rest;
  text += fmt::format("{},0,0\n", direction.name);
  for (int i = 1; i <= n_points; ++i) {
    bond.move(direction.opening * step, direction.slip * step);
    text += fmt::format("{},{:.9g},{:.9g}\n", direction.name, i * step, bond.resistance());
  }
}

const MaterialTable& material_with_law(Case& input, const std::string& name) {
  const auto found = std::find_if(input.materials.begin(), input.materials.end(),
                                  [&](const auto& material) { return input.file.peek(material.view, "law") == name; });
  if (found != input.materials.end()) return found->table;
  throw InputError(fmt::format("no material of the case has law = \"{}\"", name));
}

}  // namespace

std::string law_curves(Case& input, const std::string& name, const CurveContact& contact) {
  const MaterialTable& table = material_with_law(input, name);
  Material material;
  material.young_modulus = table.young_modulus;
  material.poisson_ratio = table.poisson_ratio;
  material.stiffness = table.stiffness;
  const ContactStiffness springs =
      contact_stiffness(material, input.problem.plane, contact.height, contact.length, input.problem.thickness);
  if (const auto complaint = table.law->complaint({springs.normal, springs.shear, springs.area})) {
    throw InputError(
        fmt::format("a contact with H = {} m and L = {} m: {}", contact.height, contact.length, complaint->text));
  }
  const TestBond at_rest(*table.law, springs);
  std::string text = "curve,displacement_m,force_N\n";
  for (const Direction& direction : {Direction{"tension", 1.0, 0.0}, Direction{"shear", 0.0, 1.0}}) {
    append_curve(text, at_rest, direction, contact.length);
  }
  return text;
}

}  // namespace ligament
