/// Nodes of ROS 2 as localizers of a live run.
#pragma once

#include <vector>

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {

/// Throws std::invalid_argument for a node that is to drive: it would go back with the run.
void check_nodes(const std::vector<LocalizerSpec>& localizers);

/// Makes programs of them: threads of DDS do not survive that the run's process is copied, so that
/// `castaway serve` speaks to the node. `settings`: the effective ones, with the list `localizers`.
void serve_nodes(const YamlNode& settings, std::vector<LocalizerSpec>& localizers);

}  // namespace castaway::testbed
