#pragma once

#include <span>
#include <vector>

#include "core/cell_grid.hpp"

namespace ligament {

/// Two discs, the first of lower number.
struct DiscPair {
  Index first;
  Index second;
};

/// Pairs of discs that overlap, or may before one of them has moved far.
class NearDiscs {
 public:
  /// Of discs of these radii (m), pairs nearer than the skin (m).
  NearDiscs(const Field<double>& radii, double skin);

  /// Largest component (m) of what a disc may have moved since the last update, for no pair that overlaps to be
  /// missing.
  [[nodiscard]] double most_moved() const { return most_moved_in(skin_); }

  /// To be called before the first use, and when a disc has moved too far.
  void update(const Field<Vector>& centres);

  /// First discs ascend. The second ones of each are in the order in which a grid had them at the last update, with
  /// cells as wide as two of the largest discs and the skin: the order in which a disc sums its forces, and so the bits
  /// of a packing, depend on it.
  [[nodiscard]] std::span<const DiscPair> pairs() const { return pairs_; }

 private:
  /// Two discs approach each other by at most 2√2 times the largest component. When a list is renewed decides the order
  /// of sums: the bits of a packing hang on this number, and on the skin that it is given.
  static double most_moved_in(double skin) { return 0.35 * skin; }

  [[nodiscard]] bool is_exhausted(const Field<Vector>& centres) const;
  void search(const Field<Vector>& centres, const CellGrid& grid);
  void list(const Field<Vector>& centres, const CellGrid& grid);
  void sort(std::span<DiscPair> pairs) const;

  Field<double> radii_;
  double largest_radius_;
  double skin_;
  double wide_skin_;
  /// Discs of higher number nearer than the wide skin, and where those of each disc begin. Pairs are taken from here,
  /// and new candidates searched for only when a disc has moved by a part of the wide skin.
  std::vector<Index> candidates_;
  std::vector<std::size_t> begin_;
  Field<Vector> centres_when_searched_;
  std::vector<Index> rank_;  ///< of each disc in the order of the grid
  std::vector<DiscPair> pairs_;
};

}  // namespace ligament
