/// Plays a live run in a process of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "tools/live/lines/bridge_link.hpp"
#include "tools/play/replay/replay_session.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {

/// What is played.
struct LiveSetup {
  LoadedScenario scenario;
  std::filesystem::path base;  ///< Folder of the scenario's file.
  bool playing = false;        ///< From the beginning on.
  /// Where files lie that pages brought (`LiveFiles`).
  std::filesystem::path files{};
  /// Plays a scenario and leaves a run folder with a report in `out`, which must not exist. `base`:
  /// the folder of the scenario's file. Throws std::exception if it fails.
  std::function<void(const LoadedScenario& scenario, const std::filesystem::path& base,
                     const std::filesystem::path& out)>
      report{};
  std::filesystem::path reports{};  ///< Folder for them: "1", "2"...
  /// The same as `report` for a recorded log.
  std::function<void(const ReplaySession& session, const std::filesystem::path& out)> replay{};
  /// Played in place of the scenario, which then serves for the worlds and robots of pages.
  std::optional<ReplaySession> session{};
  std::shared_ptr<BridgeLink> bridge{};  ///< To nodes of ROS 2 that look on; null: none do.
  /// Takes a warning about the log that is played, in one sentence.
  std::function<void(const std::string&)> warn{};

  /// Of what is played.
  [[nodiscard]] const std::vector<LocalizerSpec>& localizers() const {
    return session ? session->localizers : scenario.scenario.localizers;
  }
};

/// Plays until the other end of `socket` is closed: takes commands, as JSON, and says what happens
/// (`wire.hpp`). The process must have a single thread. Commands:
///   {"do": "play" | "pause" | "step"}        step: to the next scan
///   {"do": "speed", "value": 2}              0.1 to 100 times real time
///   {"do": "event", "event": {...}}          `read_live_event`
///   {"do": "back", "to_s": 12.5}             events after that time are undone
///   {"do": "save"}                           the scenario that repeats the run until now; of a
///                                            log, the session
///   {"do": "report"}                         plays that and makes a report
///   {"do": "load", "file": "map.yaml"}       another run, in this world or with this robot; a log,
///                                            with "map": its map
/// It says
///   {"said": "hello", "run": {...}}          `LiveFeed::hello`; also at the start and after "back"
///   {"said": "scene", "scene": {...}}        `page_scene_json`; after a hello, and when
///                                            the world changed
///   {"said": "status", "playing", "speed", "now_s", "times_real"}
///   {"said": "events", "events": [...]}      `LiveFeed::take_events`
///   {"said": "done", "event": {...}, "at_s"} an event of a hand took place
///   {"said": "scenario", "yaml": "..."}
///   {"said": "report", "number": 1, "folder": "..."}
///   {"said": "loaded", "file": "map.yaml"}   the hello of another run follows
///   {"said": "error", "text": "..."}         of one line
/// A run that cannot be built or played is an error, and the end.
void play_live(const LiveSetup& setup, int socket);

}  // namespace castaway::testbed
