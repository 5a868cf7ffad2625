/// Where a live run goes on that goes back.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "castaway/stamp.hpp"

namespace castaway::testbed {

/// An event of a hand.
struct HandEvent {
  std::size_t step = 0;      ///< How many steps the run had taken before it.
  localization::Stamp at{};  ///< When it takes place.
  std::string event;         ///< JSON.
};

/// A moment of the past, and what a copy of the run must know that is woken to go on there.
struct LiveGoal {
  localization::Stamp time{};
  double speed = 1.0;
  bool playing = false;                 ///< The run goes on playing.
  std::vector<HandEvent> events{};      ///< To be done again on the way, in order.
  std::vector<std::string> commands{};  ///< That the run has heard and not carried out.
};

/// One line of text, without the events after the time.
std::string to_line(const LiveGoal& goal);

LiveGoal goal_of(const std::string& line);

}  // namespace castaway::testbed
