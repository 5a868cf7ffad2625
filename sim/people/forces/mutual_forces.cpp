#include "sim/people/forces/mutual_forces.hpp"

#include "sim/people/forces/cell_list.hpp"
#include "sim/people/forces/packed_force.hpp"

namespace castaway::sim {
namespace {

constexpr int kRings = 2;  // Cells within reach, on each side.

/// People by place in a cell list, relative to the first of them.
PackedPeople pack(const Crowding& people, const std::vector<std::size_t>& order) {
  PackedPeople packed;
  for (const std::size_t i : order) {
    const Eigen::Vector2f p = (people.positions[i] - people.positions[order[0]]).cast<float>();
    const Eigen::Vector2f v = people.velocities[i].cast<float>();
    packed.push_back({p.x(), p.y(), v.x(), v.y()});
  }
  return packed;
}

/// Forces of pairs of people, with memory that is used again for each person.
class NeighbourForces {
 public:
  NeighbourForces(const SocialForceConfig& config, const Crowding& people)
      : config_(config),
        cells_(people.positions, config.reach / kRings),
        people_(pack(people, cells_.order())) {}

  /// Adds the forces between the person at a place and all at later ones.
  void add(std::size_t place, std::vector<Eigen::Vector2d>& sums) {
    const PackedPerson person = people_[place];
    select(place, person);
    near_.gather(people_, near_places_);
    packed_forces(config_, person, near_, forces_);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < near_places_.size(); ++k) {
      const Eigen::Vector2d force(forces_.x[k], forces_.y[k]);
      sum += force;
      sums[cells_.order()[near_places_[k]]] -= force;
    }
    sums[cells_.order()[place]] += sum;
  }

 private:
  /// Finds those whose force is not zero. Without branches, which could not be predicted.
  void select(std::size_t place, PackedPerson person) {
    std::size_t count = 0;
    cells_.visit_later(place, kRings, [&](std::size_t begin, std::size_t end) {
      cut_off(config_, person, people_, begin, end, margins_);
      near_places_.resize(count + end - begin);
      for (std::size_t k = begin; k < end; ++k) {
        near_places_[count] = k;
        count += margins_[k - begin] >= 0.0F ? 1 : 0;
      }
    });
    near_places_.resize(count);
  }

  const SocialForceConfig& config_;
  CellList cells_;
  PackedPeople people_;  ///< By place.
  PackedPeople near_;
  std::vector<std::size_t> near_places_;
  std::vector<float> margins_;
  PackedForces forces_;
};

}  // namespace

std::vector<Eigen::Vector2d> mutual_forces(const SocialForceConfig& config,
                                           const Crowding& people) {
  return people.positions.size() <= kFewPeople ? forces_of_pairs(config, people)
                                               : forces_of_neighbours(config, people);
}

std::vector<Eigen::Vector2d> forces_of_pairs(const SocialForceConfig& config,
                                             const Crowding& people) {
  const auto& [p, v] = people;
  std::vector<Eigen::Vector2d> sums(p.size(), Eigen::Vector2d::Zero());
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = i + 1; j < p.size(); ++j) {
      const Eigen::Vector2d force = social_force(config, p[j] - p[i], v[i] - v[j]);
      sums[i] += force;
      sums[j] -= force;
    }
  }
  return sums;
}

std::vector<Eigen::Vector2d> forces_of_neighbours(const SocialForceConfig& config,
                                                  const Crowding& people) {
  std::vector<Eigen::Vector2d> sums(people.positions.size(), Eigen::Vector2d::Zero());
  NeighbourForces forces(config, people);
  for (std::size_t place = 0; place < sums.size(); ++place) forces.add(place, sums);
  return sums;
}

}  // namespace castaway::sim
