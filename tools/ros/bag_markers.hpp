/// People and hypotheses as markers for RViz and Foxglove.
#pragma once

#include "castaway/localizer.hpp"
#include "tools/ros/ros_visualization.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// A cylinder for each person; namespace "people", id of the person.
ros::MarkerArray people_markers(Stamp stamp, const std::vector<PersonTruth>& people);

/// Clears all markers, then adds an arrow for each population: id of the population, colour by id,
/// opacity by its share, larger for the selected one. `heights`: at their heights, else at z = 0.
ros::MarkerArray hypothesis_markers(Stamp stamp,
                                    const std::vector<localization::PopulationView>& populations,
                                    bool heights = false);

}  // namespace castaway::testbed
