/// The player of a run on its page, and its data.
#pragma once

#include <string>

#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// True if the page has a player: the build bundled it and the run left a recording.
bool has_player(const RunFolder& run);

/// The elements of player and curves, hidden until the script has started; without a player, a line
/// that says why.
std::string player_section(const RunFolder& run);

/// The recording and the events; empty without a player.
std::string player_data(const RunFolder& run);

}  // namespace castaway::testbed
