/// People and hypotheses as markers for RViz and Foxglove.
#pragma once

#include "tools/ros/ros_visualization.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// A cylinder for each person, namespace "people", id the person's.
ros::MarkerArray people_markers(Stamp stamp, const std::vector<PersonTruth>& people);

/// Empties the picture, then an arrow for each population: id the population's, colour by id,
/// more opaque the larger its share; the selected one is larger.
ros::MarkerArray hypothesis_markers(Stamp stamp,
                                    const std::vector<localization::PopulationView>& populations);

}  // namespace castaway::testbed
