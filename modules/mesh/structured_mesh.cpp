#include "mesh/structured_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace ligament {
namespace {

bool is_line(const std::vector<double>& lines, double position) {
  const double tolerance = 1e-9 * (lines.back() - lines.front());
  return std::any_of(lines.begin(), lines.end(), [&](double line) { return std::abs(line - position) <= tolerance; });
}

bool is_inside(const Rectangle& rectangle, const Vector& point) {
  return point.x > rectangle.from.x && point.x < rectangle.to.x && point.y > rectangle.from.y &&
         point.y < rectangle.to.y;
}

/// Numbers of the full grid.
class Grid {
 public:
  explicit Grid(const GridLines& lines) : lines_(lines), n_columns_(lines.x.size() - 1) {}

  [[nodiscard]] std::size_t n_nodes() const { return lines_.x.size() * lines_.y.size(); }
  [[nodiscard]] std::size_t n_elements() const { return n_columns_ * (lines_.y.size() - 1); }
  [[nodiscard]] Vector node_position(std::size_t node) const {
    return {lines_.x[node % lines_.x.size()], lines_.y[node / lines_.x.size()]};
  }
  [[nodiscard]] std::array<std::size_t, 4> element_nodes(std::size_t element) const {
    const std::size_t bottom_left = element / n_columns_ * lines_.x.size() + element % n_columns_;
    const std::size_t top_left = bottom_left + lines_.x.size();
    return {bottom_left, bottom_left + 1, top_left + 1, top_left};
  }
  [[nodiscard]] Vector element_centre(std::size_t element) const {
    const auto nodes = element_nodes(element);
    return 0.5 * (node_position(nodes[0]) + node_position(nodes[2]));
  }

 private:
  const GridLines& lines_;
  std::size_t n_columns_;
};

std::vector<std::size_t> kept_elements(const Grid& grid, const std::vector<Rectangle>& holes) {
  std::vector<std::size_t> kept;
  for (std::size_t element = 0; element < grid.n_elements(); ++element) {
    const Vector centre = grid.element_centre(element);
    const bool in_hole =
        std::any_of(holes.begin(), holes.end(), [&](const Rectangle& hole) { return is_inside(hole, centre); });
    if (!in_hole) kept.push_back(element);
  }
  return kept;
}

}  // namespace

bool is_block_of_grid(const GridLines& lines, const Rectangle& rectangle) {
  return is_line(lines.x, rectangle.from.x) && is_line(lines.x, rectangle.to.x) && is_line(lines.y, rectangle.from.y) &&
         is_line(lines.y, rectangle.to.y);
}

StructuredMesh build_structured_mesh(const GridLines& lines, const std::vector<Rectangle>& holes) {
  for (const Rectangle& hole : holes) {
    if (!is_block_of_grid(lines, hole)) throw InputError("a zone does not replace whole elements of the mesh");
  }
  const Grid grid(lines);
  const std::vector<std::size_t> kept = kept_elements(grid, holes);

  std::vector<Index> row_of_node(grid.n_nodes(), -1);
  for (const std::size_t element : kept) {
    for (const std::size_t node : grid.element_nodes(element)) row_of_node[node] = 0;
  }
  StructuredMesh mesh;
  for (std::size_t node = 0; node < grid.n_nodes(); ++node) {
    if (row_of_node[node] < 0) continue;
    row_of_node[node] = static_cast<Index>(mesh.nodes.size());
    mesh.nodes.position.push_back(grid.node_position(node));
    mesh.nodes.id.push_back(static_cast<Index>(node + 1));
  }
  mesh.nodes.free.assign(mesh.nodes.size(), uniform_vector(1.0));
  for (const std::size_t element : kept) {
    std::array<Index, 4> rows{};
    const auto nodes = grid.element_nodes(element);
    std::transform(nodes.begin(), nodes.end(), rows.begin(), [&](std::size_t node) { return row_of_node[node]; });
    mesh.elements.nodes.push_back(rows);
    mesh.elements.id.push_back(static_cast<Index>(element + 1));
  }
  return mesh;
}

}  // namespace ligament
