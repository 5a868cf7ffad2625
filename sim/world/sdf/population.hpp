/// Models that Gazebo classic spreads over a region: `<population>`.
#pragma once

#include <vector>

#include <tinyxml.h>

#include <Eigen/Core>

#include "sim/common/random.hpp"

namespace castaway::sim {

/// The places of a population's models.
struct PopulationPlaces {
  std::vector<Eigen::Vector3d> p_world;  ///< [m]
  bool drawn = false;                    ///< Gazebo draws them anew at each start.
};

/// Places the models of a population: at random, evenly (clusters of samples), in a grid or in a
/// row, over a box or a cylinder, as Gazebo classic 11 does; what it draws is drawn from `rng`.
/// @throws std::runtime_error saying what is wrong with the population.
PopulationPlaces place_population(const TiXmlElement& population, Rng& rng);

}  // namespace castaway::sim
