#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "constitutive/frictional.hpp"
#include "constitutive/intact_bonds.hpp"
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
    if constexpr (requires { law_.intact_limits(); }) {
      evaluate_damaged(batch);
    } else {
      for (std::size_t i = 0; i < batch.opening.size(); ++i) evaluate_one(batch, i);
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
  /// Intact bonds all together, the others one by one.
  void evaluate_damaged(const ContactBatch& batch) const {
    LeftToLaw left;
    for (std::size_t begin = 0; begin < batch.opening.size(); begin += intact_chunk) {
      const std::size_t count = std::min(intact_chunk, batch.opening.size() - begin);
      if (carry_intact(law_.intact_limits(), batch, begin, count, left) == 0) continue;
      for (std::size_t i = 0; i < count; ++i) {
        if (left[i] != 0) evaluate_one(batch, begin + i);
      }
    }
  }

  void evaluate_one(const ContactBatch& batch, std::size_t i) const {
    const ContactInput input{batch.opening[i], batch.slip_increment[i], batch.normal_stiffness[i],
                             batch.shear_stiffness[i], batch.area[i]};
    ContactForce force{batch.normal_force[i], batch.shear_force[i], batch.bond[i]};
    const auto remembered = [&](std::size_t k) { return batch.history[k][i]; };
    if constexpr (requires { law_.keeps_history(input, force, remembered); }) {
      if (law_.keeps_history(input, force, remembered)) {
        batch.normal_force[i] = force.normal;
        batch.shear_force[i] = force.shear;
        return;
      }
    }
    std::array<double, Law::n_history> history;
    for (std::size_t k = 0; k < Law::n_history; ++k) history[k] = remembered(k);
    law_.evaluate(input, force, history);
    batch.normal_force[i] = force.normal;
    batch.shear_force[i] = force.shear;
    batch.bond[i] = force.bond;
    for (std::size_t k = 0; k < Law::n_history; ++k) batch.history[k][i] = history[k];
  }

  Law law_;
};

}  // namespace ligament
