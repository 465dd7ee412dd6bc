#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "constitutive/frictional.hpp"
#include "constitutive/point_law.hpp"
#include "core/block_sum.hpp"

namespace ligament {

/// The one loop over contacts that all point laws share.
template <PointLaw Law>
class BatchLaw final : public ConstitutiveLaw {
 public:
  BatchLaw() = default;
  explicit BatchLaw(Law law) : law_(std::move(law)) {}

  void declare(Parameters& parameters) override { law_.declare(parameters); }

  [[nodiscard]] std::vector<HistoryVariable> history() const override {
    const auto variables = Law::history();
    return {variables.begin(), variables.end()};
  }

  [[nodiscard]] std::unique_ptr<ConstitutiveLaw> contact_law() const override {
    return std::make_unique<BatchLaw<Frictional>>(Frictional{law_.friction_coefficient});
  }

  [[nodiscard]] std::optional<LawComplaint> complaint(const ContactSample& contact) const override {
    if constexpr (requires { law_.complaint(contact); }) return law_.complaint(contact);
    return {};
  }

  void evaluate(const ContactBatch& batch) const override {
    std::array<double, Law::n_history> history;
    for (std::size_t i = 0; i < batch.opening.size(); ++i) {
      const ContactInput input{batch.opening[i], batch.slip_increment[i], batch.normal_stiffness[i],
                               batch.shear_stiffness[i], batch.area[i]};
      ContactForce force{batch.normal_force[i], batch.shear_force[i], batch.bond[i]};
      for (std::size_t k = 0; k < Law::n_history; ++k) history[k] = batch.history[k][i];
      law_.evaluate(input, force, history);
      batch.normal_force[i] = force.normal;
      batch.shear_force[i] = force.shear;
      batch.bond[i] = force.bond;
      for (std::size_t k = 0; k < Law::n_history; ++k) batch.history[k][i] = history[k];
    }
  }

  [[nodiscard]] ContactEnergies energies(const ContactBatchView& batch) const override {
    return block_sum(batch.opening.size(), [&](std::size_t i) {
      const ContactInput input{batch.opening[i], 0.0, batch.normal_stiffness[i], batch.shear_stiffness[i],
                               batch.area[i]};
      const ContactForce force{batch.normal_force[i], batch.shear_force[i], batch.bond[i]};
      std::array<double, Law::n_history> history;
      for (std::size_t k = 0; k < Law::n_history; ++k) history[k] = batch.history[k][i];
      return law_.energies(input, force, history);
    });
  }

  [[nodiscard]] ContactDamage damage(std::span<const double> history) const override {
    if constexpr (requires(const std::array<double, Law::n_history>& values) { law_.damage(values); }) {
      std::array<double, Law::n_history> values;
      std::copy_n(history.begin(), Law::n_history, values.begin());
      return law_.damage(values);
    }
    return {};
  }

 private:
  Law law_;
};

}  // namespace ligament
