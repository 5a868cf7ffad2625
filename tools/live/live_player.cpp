#include "tools/live/live_player.hpp"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/files/json_text.hpp"
#include "tools/live/checkpoints.hpp"
#include "tools/live/lines/live_line.hpp"
#include "tools/live/live_building.hpp"
#include "tools/live/live_clock.hpp"
#include "tools/live/live_feed.hpp"
#include "tools/live/live_loading.hpp"
#include "tools/live/live_report.hpp"
#include "tools/live/live_trial.hpp"
#include "tools/output/any_error.hpp"
#include "tools/output/file_name.hpp"
#include "tools/run/cpu_clock.hpp"
#include "tools/scenario/localizers/ros2_spec.hpp"

namespace castaway::testbed {
namespace {

using PlayerJson = nlohmann::ordered_json;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr nanoseconds kFramePeriod = milliseconds(25);
constexpr nanoseconds kBurst = milliseconds(10);  // Wall time between two looks at the commands.
constexpr double kCheckpointEvery = 10.0;         // [s] Of simulated time.
constexpr double kSlowest = 0.1;
constexpr double kFastest = 100.0;

/// An event of a hand.
struct Done {
  std::size_t step = 0;  ///< How many steps the run had taken before it.
  Stamp at{};            ///< When it takes place.
  std::string event;     ///< JSON.
};

/// A moment to go to: where a woken copy goes on.
struct GoTo {
  Stamp time{};
  double speed = 1.0;
  std::vector<Done> events{};  ///< To be done again on the way, in order.
};

std::string to_line(const GoTo& goal) {
  PlayerJson events = PlayerJson::array();
  for (const Done& done : goal.events) {
    if (done.at <= goal.time) events.push_back({done.step, done.at.count(), done.event});
  }
  return json_text(PlayerJson{
      {"time_ns", goal.time.count()}, {"speed", goal.speed}, {"events", std::move(events)}});
}

GoTo goal_of(const std::string& line) {
  const PlayerJson order = PlayerJson::parse(line);
  GoTo goal{Stamp(order.at("time_ns").get<std::int64_t>()), order.at("speed").get<double>(), {}};
  for (const PlayerJson& done : order.at("events")) {
    goal.events.push_back({done.at(0).get<std::size_t>(), Stamp(done.at(1).get<std::int64_t>()),
                           done.at(2).get<std::string>()});
  }
  return goal;
}

/// True if a localizer is a program. It cannot be copied, so that the run begins again to go back.
bool has_nodes(const LiveSetup& setup) { return std::ranges::any_of(setup.localizers(), is_node); }

bool has_programs(const LiveSetup& setup) {
  return std::ranges::any_of(setup.localizers(), [](const LocalizerSpec& localizer) {
    return std::holds_alternative<ProgramConfig>(localizer.config) || is_node(localizer);
  });
}

class LivePlayer {
 public:
  LivePlayer(LiveSetup setup, int socket)
      : setup_(std::move(setup)), line_(socket), has_programs_(has_programs(setup_)) {}
  ~LivePlayer() { end_run(); }

  void play() {
    keep_checkpoint();
    build();
    say_hello();
    if (!undone_) say_scene();
    if (setup_.playing && !goal_) clock_.play(wall_time(), run_->now());
    while (true) turn();
  }

 private:
  void build() {
    const LiveSinkMaker make = [this](const RunInfo& info, const RosMap& map, double radius) {
      auto feed = std::make_unique<LiveFeed>(info, map, radius);
      feed_ = feed.get();
      return feed;
    };
    run_ = build_live(setup_, *worlds_, make);
  }

  /// A copy that is woken goes on here, with a goal.
  void keep_checkpoint() {
    const Stamp now = run_ ? run_->now() : Stamp{};
    next_checkpoint_ = now + localization::from_seconds(kCheckpointEvery);
    while (const auto woken = checkpoints_.keep(now)) {
      goal_ = goal_of(*woken);
      undone_ = true;
      if (has_programs_ && run_) begin_again();
    }
  }

  /// The programs of the run start anew.
  void begin_again() {
    end_run();
    build();
  }

  void end_run() {
    if (run_) run_->finish_localizers();
    run_.reset();
  }

  void turn() {
    if (goal_) return reach_goal();
    listen();
    if (goal_) return;
    play_on();
    if (wall_time() >= next_frame_) tell();
  }

  /// Plays until now, as fast as it can, without telling.
  void reach_goal() {
    if (setup_.bridge) setup_.bridge->mute(true);
    do {
      do_again();
    } while (run_->now() < goal_->time && step());
    if (setup_.bridge) setup_.bridge->mute(false);
    feed_->forget();
    clock_.pause();
    clock_.set_speed(goal_->speed, wall_time(), run_->now());
    goal_.reset();
    say_hello();
    say_scene();  // Its doors and boxes are those of this moment.
    tell();
  }

  /// Events that were done at this step, but for those that this copy has seen.
  void do_again() {
    while (done_.size() < goal_->events.size() && goal_->events[done_.size()].step == steps_) {
      do_event(goal_->events[done_.size()].event);
    }
  }

  Stamp do_event(const std::string& event) {
    const Stamp at = run_->add(event);
    done_.push_back({steps_, at, event});
    return at;
  }

  bool step() {
    if (!run_->step()) return false;
    ++steps_;
    if (!goal_ && !has_programs_ && run_->now() >= next_checkpoint_) keep_checkpoint();
    return true;
  }

  void play_on() {
    const nanoseconds begin = wall_time();
    const Stamp due = clock_.due(begin, run_->now());
    while (run_->now() < due && wall_time() - begin < kBurst) {
      if (!step()) return clock_.pause();
      if (goal_) return;  // This is a copy that was woken.
    }
  }

  /// Waits for commands until there is something else to do, and carries them out.
  void listen() {
    nanoseconds patience = next_frame_ - wall_time();
    if (clock_.is_playing()) {
      patience = std::min(patience, clock_.until(run_->now() + Stamp(1), wall_time()));
    }
    for (const std::string& command : line_.hear(patience)) obey(command);
  }

  void obey(const std::string& text) {
    try {
      const PlayerJson command = PlayerJson::parse(text);
      obey(command.at("do").get<std::string>(), command);
    } catch (const PlayerJson::exception&) {
      line_.say({{"said", "error"}, {"text", "not a command"}});
    } catch (const LineCut&) {
      throw;
    } catch (...) {
      line_.say({{"said", "error"}, {"text", current_error_text()}});
    }
  }

  void obey(const std::string& what, const PlayerJson& command) {
    if (what == "play") {
      clock_.play(wall_time(), run_->now());
    } else if (what == "pause") {
      clock_.pause();
    } else if (what == "step") {
      clock_.pause();
      const std::size_t scans = feed_->scans();
      while (feed_->scans() == scans && step()) {
      }
    } else if (what == "speed") {
      const double speed = std::clamp(command.at("value").get<double>(), kSlowest, kFastest);
      clock_.set_speed(speed, wall_time(), run_->now());
    } else if (what == "event") {
      const Stamp at = do_event(json_text(command.at("event")));
      line_.say(
          {{"said", "done"}, {"event", command.at("event")}, {"at_s", localization::seconds(at)}});
    } else if (what == "back") {
      go_back(localization::from_seconds(command.at("to_s").get<double>()));
    } else if (what == "save") {
      line_.say({{"said", "scenario"}, {"yaml", run_->saved()}});
    } else if (what == "report") {
      begin_report();
    } else if (what == "load") {
      load(command.at("file").get<std::string>(), command.value("map", ""));
    } else {
      throw std::runtime_error("unknown command '" + what + "'");
    }
    say_status();
  }

  /// Hands over to a copy and ends.
  void go_back(Stamp time) {
    const GoTo goal{std::clamp(time, Stamp{}, run_->now()), clock_.speed(), done_};
    if (!checkpoints_.wake(goal.time, to_line(goal))) return;
    if (has_programs_) end_run();
    _exit(0);
  }

  void begin_report() {
    std::filesystem::path out;
    do {  // A run that went back has forgotten some.
      out = setup_.reports / std::to_string(++reports_);
    } while (std::filesystem::exists(out));
    report_.start([&] { make_report(YamlDocument::parse(run_->saved(), "live"), out); },
                  line_.socket());
  }

  /// Its localizers were accepted at the command line.
  void make_report(YamlDocument played, const std::filesystem::path& out) {
    if (setup_.session) {
      setup_.replay(read_session(std::move(played), {{}, FilePrograms::kAllowed}), out);
    } else {
      setup_.report(read_scenario(std::move(played), setup_.base, setup_.scenario.scenario.name,
                                  FilePrograms::kAllowed),
                    setup_.base, out);
    }
  }

  void tell_of_report() {
    const auto outcome = report_.outcome();
    if (!outcome) return;
    if (!outcome->empty())
      return line_.say({{"said", "error"}, {"text", "no report: " + *outcome}});
    line_.say({{"said", "report"},
               {"number", reports_},
               {"folder", (setup_.reports / std::to_string(reports_)).string()}});
  }

  /// Another run takes the place of this one, unless it cannot be built.
  void load(const std::string& name, const std::string& map) {
    for (const std::string& file : {name, map.empty() ? name : map}) {
      if (!file_path_error(file).empty()) throw std::runtime_error("no file of a page");
    }
    if (has_nodes(setup_)) {
      throw std::runtime_error(
          "a run with a node of ROS 2 loads nothing else: its domain is taken");
    }
    LiveSetup setup = with_file(setup_, name, map);
    try_in_copy([&] {
      checkpoints_.clear();
      // If this fails, the programs of the old run go on in the process that tried it.
      if (has_programs_) {
        replaced_ = std::move(run_);
      } else {
        end_run();
      }
      worlds_ = std::make_unique<SharedWorlds>();
      setup_ = std::move(setup);
      build();
    });
    if (replaced_) replaced_->finish_localizers();
    replaced_.reset();
    undone_ = false;
    done_.clear();
    steps_ = 0;
    clock_.pause();
    keep_checkpoint();
    line_.say({{"said", "loaded"}, {"file", name}});
    say_hello();
    if (!goal_) say_scene();
  }

  void tell() {
    tell_of_report();
    next_frame_ = wall_time() + kFramePeriod;
    const PlayerJson events = feed_->take_events();
    if (!events.empty()) line_.say({{"said", "events"}, {"events", events}});
    const bool changed = std::ranges::any_of(
        events, [](const PlayerJson& event) { return event.at("kind") == "world"; });
    if (changed) say_scene();
    if (run_->now() == told_ && !feed_->has_news()) return say_status_now_and_then();
    told_ = run_->now();
    line_.show(feed_->take_frame(
        {run_->now(), run_->true_pose(), run_->estimates(), run_->T_footprint_base()}));
    say_status_now_and_then();
  }

  void say_hello() {
    if (const sim::WorldSpec* world = run_->world()) feed_->set_doors(*world);
    if (const LevelMaps* levels = run_->levels()) feed_->set_levels(*levels);
    if (const auto scans = run_->recorded_scans()) feed_->set_recorded(*scans);
    line_.say({{"said", "hello"}, {"run", feed_->hello()}, {"undone", undone_}});
    say_status();
  }

  /// Pages keep the last one.
  void say_scene() {
    const std::string scene = run_->scene();
    if (!scene.empty()) line_.say_text(R"({"said":"scene","scene":)" + scene + "}");
  }

  void say_status_now_and_then() {
    if (wall_time() >= next_status_) say_status();
  }

  void say_status() {
    const nanoseconds wall = wall_time();
    const double elapsed = localization::seconds(wall - status_wall_);
    const double times_real =
        elapsed > 0.0 ? localization::seconds(run_->now() - status_now_) / elapsed : 0.0;
    line_.say({{"said", "status"},
               {"playing", clock_.is_playing()},
               {"speed", clock_.speed()},
               {"now_s", localization::seconds(run_->now())},
               {"times_real", times_real}});
    status_wall_ = wall;
    status_now_ = run_->now();
    next_status_ = wall + std::chrono::seconds(1);
  }

  LiveSetup setup_;
  LiveLine line_;
  bool has_programs_;  ///< All runs of a page have the localizers of the command line.
  std::unique_ptr<SharedWorlds> worlds_ = std::make_unique<SharedWorlds>();
  Checkpoints checkpoints_;
  LiveReport report_;
  int reports_ = 0;  ///< Begun so far.
  std::unique_ptr<LivePlay> run_;
  std::unique_ptr<LivePlay> replaced_;  ///< Until it is known that another one could be built.
  LiveFeed* feed_ = nullptr;
  LiveClock clock_;
  std::vector<Done> done_;  ///< Events of hands since the beginning,
  std::size_t steps_ = 0;   ///< and the steps that the run has taken.
  std::optional<GoTo> goal_;
  bool undone_ = false;
  Stamp next_checkpoint_{};
  Stamp told_{-1};
  nanoseconds next_frame_{};
  nanoseconds next_status_{};
  nanoseconds status_wall_{};
  Stamp status_now_{};
};

}  // namespace

void play_live(const LiveSetup& setup, int socket) {
  std::signal(SIGPIPE, SIG_IGN);  // A copy that has ended cannot be woken.
  try {
    LivePlayer(setup, socket).play();
  } catch (const LineCut&) {
  }
}

}  // namespace castaway::testbed
