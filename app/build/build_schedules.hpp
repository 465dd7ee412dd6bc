#pragma once

#include "case/case.hpp"
#include "integrator/piecewise_linear.hpp"

namespace ligament {

/// The schedules of a motion (m) and of a load (1); what is wrong with them becomes errors of the case file. Both have
/// corners only where they are right.
PiecewiseLinear build_schedule(Case& input, const MotionTable& table, const TableView& view);
PiecewiseLinear build_schedule(Case& input, const LoadTable& table, const TableView& view);

}  // namespace ligament
