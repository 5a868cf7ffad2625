/// The channels of a run's bag.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/ros/topic_writer.hpp"

namespace castaway::testbed {

/// Converts `name` to a part of a topic: letters, digits and underscores, not starting with a
/// digit.
std::string topic_part(const std::string& name);

/// Channel ids of a localizer's topics.
struct LocalizerChannels {
  std::uint16_t pose = 0;
  std::uint16_t hypotheses = 0;
  std::uint16_t particles = 0;  ///< Only with `OptionalTopics::particles`.
  std::uint16_t cloud = 0;      ///< Only with `OptionalTopics::clouds`.
};

/// Channel ids of the topics that a run has from its beginning. Those of lidars and pictures are
/// added when their first message arrives.
struct BagChannels {
  std::uint16_t map = 0;
  std::uint16_t tf_static = 0;
  std::uint16_t tf = 0;
  std::uint16_t odom = 0;
  std::uint16_t true_odom = 0;
  std::uint16_t true_pose = 0;
  std::uint16_t people = 0;
  std::uint16_t events = 0;
  std::uint16_t command = 0;  ///< Only with `OptionalTopics::drive`.
  std::uint16_t joints = 0;   ///< Only with `OptionalTopics::drive`.
  std::vector<LocalizerChannels> localizers;
};

/// Topics that not every run has.
struct OptionalTopics {
  std::vector<std::string> localizers;  ///< Names.
  bool drive = false;                   ///< Commands and wheel states.
  bool particles = true;                ///< The localizers' particles.
  bool clouds = false;                  ///< Their particles as clouds.
};

/// Adds the channels, always in the same order. Localizers whose topics would coincide get
/// underscores.
BagChannels add_channels(const OptionalTopics& wanted, TopicWriter& writer);

}  // namespace castaway::testbed
