/// Player of a run in its report, with its data.
#pragma once

#include <string>

#include "tools/pages/run/run_folder.hpp"

namespace castaway::testbed {

/// True if the page has a player: the build bundles it and the run has a recording.
bool has_player(const RunFolder& run);

/// Element of the player, hidden until the script has started. Without a player, a sentence that
/// explains why.
std::string player_section(const RunFolder& run);

/// Element of the player's curves; empty if there is no player.
std::string player_curves(const RunFolder& run);

/// Recording and events for the player; empty if there is no player.
std::string player_data(const RunFolder& run);

}  // namespace castaway::testbed
