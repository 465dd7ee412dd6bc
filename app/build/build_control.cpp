#include "build/build_control.hpp"

#include <fmt/format.h>

#include "build/find_gauge.hpp"

namespace ligament {

void set_control(Case& input, const std::vector<Gauge>& gauges, IncrementalLoading& loading) {
  if (!loading.control()) return;
  const TableView view = input.file.table("solver");
  const Gauge* gauge = find_gauge(input, gauges, *loading.control(), view, "control");
  if (gauge != nullptr && gauge->displacements.empty()) {
    input.file.add_error(
        input.file.position(view, "control"),
        fmt::format("the gauge '{}' {} measures no displacement or opening, and no other can be followed", gauge->name,
                    view.where()));
  }
  if (input.motions.empty()) {
    input.file.add_error(
        input.file.position(view, "control"),
        fmt::format("nothing can drive the gauge '{}' {}: there is no [[motion]]", *loading.control(), view.where()));
  }
  if (gauge != nullptr) loading.set_control(gauge->displacements);
}

}  // namespace ligament
