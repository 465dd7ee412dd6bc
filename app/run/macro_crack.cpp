#include "run/macro_crack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>

#include "run/plane_meeting.hpp"

namespace ligament {
namespace {

constexpr double damage_of_cracks = 0.9;
constexpr double share_outside = 0.05;  // of the band, on either side
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A plane that another one is connected to.
struct Link {
  std::size_t plane = 0;
  double distance = 0.0;  ///< of the contact points (m)
};
using Links = std::vector<std::vector<Link>>;

std::vector<CrackPlane> cracked(std::span<const CrackPlane> planes) {
  std::vector<CrackPlane> found;
  std::copy_if(planes.begin(), planes.end(), std::back_inserter(found),
               [](const CrackPlane& plane) { return plane.damage > damage_of_cracks; });
  return found;
}

bool are_connected(const CrackPlane& a, const CrackPlane& b) {
  return meeting(a, b).gap <= 0.5 * std::min(a.length, b.length);
}

Links connect(const std::vector<CrackPlane>& planes) {
  double longest = 0.0;
  for (const CrackPlane& plane : planes) longest = std::max(longest, plane.length);
  // Along one axis no two connected planes are further apart than one and a half of the longest.
  std::vector<std::size_t> order(planes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](std::size_t i) { return component(planes[i].centre, 0); };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return place(a) != place(b) ? place(a) < place(b) : a < b; });
  Links links(planes.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && place(order[j]) - place(order[i]) <= 1.5 * longest; ++j) {
      const std::size_t a = order[i];
      const std::size_t b = order[j];
      const double distance = norm(planes[b].centre - planes[a].centre);
      if (distance > 1.5 * longest || !are_connected(planes[a], planes[b])) continue;
      links[a].push_back({b, distance});
      links[b].push_back({a, distance});
    }
  }
  return links;
}

/// Sets of planes that are connected, directly or through others.
std::vector<std::vector<std::size_t>> connected_sets(const Links& links) {
  std::vector<std::vector<std::size_t>> sets;
  std::vector<bool> is_seen(links.size(), false);
  for (std::size_t first = 0; first < links.size(); ++first) {
    if (is_seen[first]) continue;
    is_seen[first] = true;
    std::vector<std::size_t> set{first};
    for (std::size_t i = 0; i < set.size(); ++i) {
      for (const Link& link : links[set[i]]) {
        if (is_seen[link.plane]) continue;
        is_seen[link.plane] = true;
        set.push_back(link.plane);
      }
    }
    sets.push_back(std::move(set));
  }
  return sets;
}

/// Two ends of planes and the distance between them.
struct Span {
  std::size_t first = 0;
  std::size_t last = 0;
  Vector from;
  Vector to;
  double distance = -1.0;
};

Span widest_span(const std::vector<CrackPlane>& planes, const std::vector<std::size_t>& set) {
  Span widest;
  for (std::size_t i = 0; i < set.size(); ++i) {
    for (std::size_t j = i; j < set.size(); ++j) {
      for (const Vector& from : planes[set[i]].ends()) {
        for (const Vector& to : planes[set[j]].ends()) {
          const double distance = norm(to - from);
          if (distance > widest.distance) widest = {set[i], set[j], from, to, distance};
        }
      }
    }
  }
  return widest;
}

/// The shortest chain of planes from the first to the last (Dijkstra 1959).
std::vector<std::size_t> shortest_chain(const Links& links, std::size_t first, std::size_t last) {
  std::vector<double> distance(links.size(), infinite);
  std::vector<std::size_t> next(links.size(), last);
  using Visit = std::pair<double, std::size_t>;
  std::priority_queue<Visit, std::vector<Visit>, std::greater<>> visits;
  distance[last] = 0.0;
  visits.emplace(0.0, last);
  while (!visits.empty()) {
    const auto [reached, plane] = visits.top();
    visits.pop();
    if (reached > distance[plane]) continue;
    for (const Link& link : links[plane]) {
      if (reached + link.distance >= distance[link.plane]) continue;
      distance[link.plane] = reached + link.distance;
      next[link.plane] = plane;
      visits.emplace(distance[link.plane], link.plane);
    }
  }
  std::vector<std::size_t> chain{first};
  while (chain.back() != last) chain.push_back(next[chain.back()]);
  return chain;
}

/// Width of the band along the path in which most of the energy was spent, the rest on either side of it in equal
/// parts; what lies beyond the ends is left out.
double damaged_width(const Field<Vector>& path, std::span<const CrackPlane> planes) {
  std::vector<std::pair<double, double>> spent;  // signed distance, energy
  double total = 0.0;
  for (const CrackPlane& plane : planes) {
    const std::optional<double> distance = distance_beside(path, plane.centre);
    if (!distance) continue;
    spent.emplace_back(*distance, plane.spent_energy);
    total += plane.spent_energy;
  }
  std::sort(spent.begin(), spent.end());
  const auto distance_at = [&](double share) {
    double sum = 0.0;
    for (const auto& [distance, energy] : spent) {
      sum += energy;
      if (sum >= share * total) return distance;
    }
    return spent.empty() ? 0.0 : spent.back().first;
  };
  return distance_at(1.0 - share_outside) - distance_at(share_outside);
}

}  // namespace

std::optional<MacroCrack> find_macro_crack(std::span<const CrackPlane> all_planes) {
  const std::vector<CrackPlane> planes = cracked(all_planes);
  if (planes.empty()) return {};
  const Links links = connect(planes);
  Span widest;
  for (const std::vector<std::size_t>& set : connected_sets(links)) {
    const Span span = widest_span(planes, set);
    if (span.distance > widest.distance) widest = span;
  }
  const std::vector<std::size_t> chain = shortest_chain(links, widest.first, widest.last);
  MacroCrack crack{.path = {widest.from}, .span = widest.distance};
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    crack.path.push_back(meeting(planes[chain[i]], planes[chain[i + 1]]).point);
  }
  crack.path.push_back(widest.to);
  for (std::size_t i = 0; i + 1 < crack.path.size(); ++i) crack.length += norm(crack.path[i + 1] - crack.path[i]);
  crack.tortuosity = crack.length / widest.distance;
  crack.damaged_width = damaged_width(crack.path, all_planes);
  return crack;
}

std::string path_table(const MacroCrack& crack) {
  std::string table = "x_m,y_m\n";
  for (const Vector& point : crack.path) table += fmt::format("{},{}\n", component(point, 0), component(point, 1));
  return table;
}

}  // namespace ligament
