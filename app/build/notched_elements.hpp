#pragma once

#include <vector>

#include "core/notch.hpp"
#include "core/rectangle.hpp"
#include "mesh/structured_mesh.hpp"

namespace ligament {

/// What a notch does to the elements of a grid with holes.
struct NotchedElements {
  std::vector<Rectangle> taken;  ///< elements inside the slit
  bool cuts_into_one = false;    ///< an element lies in the way, and not wholly inside
  bool parts_two = false;        ///< a notch without width runs along an edge that two elements share
};
NotchedElements notched_elements(const Notch& notch, const GridLines& lines, const std::vector<Rectangle>& holes);

}  // namespace ligament
