#include "io/unit_system.hpp"

#include <udunits2.h>

#include "core/error.hpp"

namespace ligament {

namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};

using Unit = std::unique_ptr<ut_unit, FreeUnit>;
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

Unit parsed(const ut_system* system, std::string_view text) {
  return Unit(ut_parse(system, std::string(text).c_str(), UT_ASCII));
}

// UDUNITS calls a unit convertible to its reciprocal too (Hz to s), which would hide mistakes.
bool have_same_dimension(const Unit& a, const Unit& b) {
  const Unit quotient(ut_divide(a.get(), b.get()));
  return quotient && ut_is_dimensionless(quotient.get()) != 0;
}

}  // namespace

struct UnitSystem::Handles {
  struct FreeSystem {
    void operator()(ut_system* freed) const { ut_free_system(freed); }
  };
  std::unique_ptr<ut_system, FreeSystem> system;
};

UnitSystem::UnitSystem() : handles_(std::make_unique<Handles>()) {
  ut_set_error_message_handler(ut_ignore);
  handles_->system.reset(ut_read_xml(nullptr));
  if (!handles_->system) throw FileError("the unit database of UDUNITS-2 could not be read");
  // UDUNITS knows the degree of arc only by longer names.
  const Unit degree = parsed(handles_->system.get(), "arc_degree");
  if (degree) ut_map_symbol_to_unit("deg", UT_ASCII, degree.get());
}

UnitSystem::~UnitSystem() = default;

const UnitSystem& UnitSystem::instance() {
  static const UnitSystem system;
  return system;
}

bool UnitSystem::knows(std::string_view unit) const { return parsed(handles_->system.get(), unit) != nullptr; }

bool UnitSystem::same_dimension(std::string_view a, std::string_view b) const {
  return have_same_dimension(parsed(handles_->system.get(), a), parsed(handles_->system.get(), b));
}

std::optional<double> UnitSystem::factor(std::string_view from, std::string_view to) const {
  const Unit source = parsed(handles_->system.get(), from);
  const Unit target = parsed(handles_->system.get(), to);
  if (!source || !target || !have_same_dimension(source, target)) return std::nullopt;
  const Converter converter(ut_get_converter(source.get(), target.get()));
  if (!converter || cv_convert_double(converter.get(), 0.0) != 0.0) return std::nullopt;
  return cv_convert_double(converter.get(), 1.0);
}

}  // namespace ligament
