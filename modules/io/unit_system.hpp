#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ligament {

/// The one UDUNITS-2 database of the program, read when first asked. UDUNITS prints nothing.
class UnitSystem {
 public:
  /// Throws FileError if the database of UDUNITS cannot be read.
  [[nodiscard]] static const UnitSystem& instance();

  ~UnitSystem();
  UnitSystem(const UnitSystem&) = delete;
  UnitSystem& operator=(const UnitSystem&) = delete;

  [[nodiscard]] bool knows(std::string_view unit) const;
  /// Whether the units measure the same thing; both must be known.
  [[nodiscard]] bool same_dimension(std::string_view a, std::string_view b) const;
  /// Number of `to` in one `from`; nothing if the dimensions differ or the scales have different zeros (degC).
  [[nodiscard]] std::optional<double> factor(std::string_view from, std::string_view to) const;

 private:
  UnitSystem();
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace ligament
