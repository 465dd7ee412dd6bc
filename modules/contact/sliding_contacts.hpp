#pragma once

#include <optional>
#include <vector>

#include "contact/contact_rows.hpp"
#include "core/model.hpp"
#include "core/state.hpp"

namespace ligament {

/// Pairs at the ends of facets, and at corners, that a bond bars: a bond never changes its facet, so that a particle
/// which moved past the end of the facet it is bonded to, or came to a facet from the corner it is bonded to, makes no
/// contact there.
std::vector<SetupPair> barred_by_bonds(const Model& model, const State& state, const std::vector<SetupPair>& found,
                                       bool are_facets);

/// Interface contacts without bond that are dropped because the particle slid past the end of its facet, or away from a
/// corner. The contact of the same particle that takes over at the common node goes on with their reference distance
/// and shear force, and with their history if it has the same law.
class SlidingContacts {
 public:
  /// Collects the rows of both interface tables that are dropped while a new candidate of the same particle meets them
  /// at a node.
  SlidingContacts(const Model& model, const State& state, const std::vector<ContactCandidate>& facet_candidates,
                  const std::vector<ContactCandidate>& corner_candidates);

  /// What a dropped row leaves behind: nothing of what goes on elsewhere.
  [[nodiscard]] ContactEnergies left_behind(const Model& model, const ContactTable& contacts, std::size_t row) const;

  /// Gives a new row what its predecessor carried; returns the energy (J) that this stored where the bodies are now, or
  /// nothing if the row has no predecessor.
  std::optional<double> hand_over(const Model& model, ContactTable& contacts, std::size_t row, bool is_facet) const;

 private:
  struct Carried {
    const ContactTable* table = nullptr;
    std::size_t row = 0;
    Index law = 0;
    Index particle = 0;
    std::vector<Index> nodes;
    bool heir_is_facet = false;
    Index heir_law = -1;
    Index heir_second = -1;
    double reference_distance = 0.0;
    ShearVector shear_displacement = 0.0;
    ShearVector shear_force = 0.0;
    std::vector<double> history;
    double stored = 0.0;  ///< where the bodies are now (J)
  };
  template <class Pairing>
  void collect(const Model& model, const State& state, const std::vector<ContactCandidate>& candidates);
  void find_heirs(const Model& model, const std::vector<ContactCandidate>& candidates, bool are_facets);
  [[nodiscard]] const Carried* find(const ContactTable& contacts, std::size_t row) const;

  std::vector<Carried> carried_;
};

}  // namespace ligament
