#pragma once

#include <vector>

#include "build/watched_bodies.hpp"

namespace ligament {

/// The displacement of `place` along an axis as a weighted sum (weights add up to 1) of the displacements of the
/// particles whose centres are under a foot of the diameter `foot` (m) about it and nearer to it than to `other`: they
/// are taken for one rigid body, by least squares weighted with their areas, so that one that hangs loose at the face
/// of a crack counts for little. Empty if there are none.
std::vector<WatchedBody> bodies_under_foot(const Model& model, const Vector& place, const Vector& other, double foot,
                                           int axis);

}  // namespace ligament
