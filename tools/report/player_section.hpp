/// The player of a run on its page, and what it plays.
#pragma once

#include <string>

#include "tools/report/run_folder.hpp"

namespace castaway::testbed {

/// True if the page has a player: the build bundled it and the run left a recording.
bool has_player(const RunFolder& run);

/// The places of player and curves, hidden until the script has started; without a player, a line
/// that says why.
std::string player_section(const RunFolder& run);

/// The recording, the events and the script; empty without a player.
std::string player_scripts(const RunFolder& run);

/// The player's style sheet; empty without a player.
std::string player_style(const RunFolder& run);

}  // namespace castaway::testbed
