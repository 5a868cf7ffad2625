/// Builds what a live run plays.
#pragma once

#include <memory>

#include "tools/build/shared_worlds.hpp"
#include "tools/live/live_play.hpp"
#include "tools/live/live_player.hpp"

namespace castaway::testbed {

/// The run or the log of the setup; nodes of ROS 2 among its localizers are served by programs.
/// Throws as `LiveRun` and `LiveLog`.
std::unique_ptr<LivePlay> build_live(const LiveSetup& setup, SharedWorlds& worlds,
                                     const LiveSinkMaker& make_sink);

}  // namespace castaway::testbed
