#include "generation/soft_discs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/block_sum.hpp"

namespace ligament {
namespace {

/// Force on a disc from a pair of walls, one component.
double push_of_walls(double position, double radius, double width) {
  // The mirror image comes nearer by twice what the disc does.
  const double low = std::max(0.0, radius - position);
  const double high = std::max(0.0, position + radius - width);
  return 2.0 * (low - high);
}

}  // namespace

SoftDiscs::SoftDiscs(Field<Vector> centres, const Vector& size)
    : centres_(std::move(centres)), velocities_(centres_.size()), forces_(centres_.size()), size_(size) {}

int SoftDiscs::relax(const Field<double>& radii, double tolerance, int most_steps) {
  if (centres_.empty()) return 0;
  radii_ = radii;
  const double mean_radius = std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
  near_.emplace(radii_, 0.3 * mean_radius);
  list_neighbours();
  std::fill(velocities_.begin(), velocities_.end(), Vector{});

  // Discs of mass 1 with a dozen springs of stiffness 1: at most 2/√24.
  constexpr double longest_time_step = 0.4;
  constexpr double first_steering = 0.1;
  double time_step = 0.1;
  double steering = first_steering;
  int n_downhill = 0;
  for (int step = 0; step < most_steps; ++step) {
    find_forces();
    const Motion now = motion();
    if (now.largest <= tolerance * mean_radius) return step;
    if (now.power > 0.0) {
      const double steer = steering * std::sqrt(now.velocity / now.force);
      move(time_step, 1.0 - steering, steer);
      if (++n_downhill > 5) {
        time_step = std::min(1.1 * time_step, longest_time_step);
        steering *= 0.99;
      }
    } else {
      if (step > 0) time_step *= 0.5;
      n_downhill = 0;
      steering = first_steering;
      move(time_step, 0.0, 0.0);
    }
  }
  return most_steps;
}

void SoftDiscs::list_neighbours() {
  centres_when_listed_ = centres_;
  near_->update(centres_);
}

void SoftDiscs::find_forces() {
  for (std::size_t i = 0; i < centres_.size(); ++i) {
    forces_[i] = {push_of_walls(centres_[i].x, radii_[i], size_.x), push_of_walls(centres_[i].y, radii_[i], size_.y)};
  }
  for (const DiscPair& pair : near_->pairs()) {
    const Vector apart = centres_[pair.second] - centres_[pair.first];
    const double reach = radii_[pair.first] + radii_[pair.second];
    const double squared_distance = dot(apart, apart);
    if (squared_distance >= reach * reach) continue;
    const double distance = std::sqrt(squared_distance);
    const Vector push = (reach - distance) / distance * apart;
    forces_[pair.first] -= push;
    forces_[pair.second] += push;
  }
}

SoftDiscs::Motion& SoftDiscs::Motion::operator+=(const Motion& other) {
  power += other.power;
  force += other.force;
  velocity += other.velocity;
  largest = std::max(largest, other.largest);
  return *this;
}

SoftDiscs::Motion SoftDiscs::motion() const {
  return block_sum(centres_.size(), [&](std::size_t i) {
    const Vector& force = forces_[i];
    const Vector& velocity = velocities_[i];
    return Motion{dot(force, velocity), dot(force, force), dot(velocity, velocity), largest_component(force)};
  });
}

void SoftDiscs::move(double time_step, double keep, double steer) {
  double farthest = 0.0;
  for (std::size_t i = 0; i < centres_.size(); ++i) {
    velocities_[i] = keep * velocities_[i] + (steer + time_step) * forces_[i];
    centres_[i] += time_step * velocities_[i];
    farthest = std::max(farthest, largest_component(centres_[i] - centres_when_listed_[i]));
  }
  if (farthest > near_->most_moved()) list_neighbours();
}

}  // namespace ligament
