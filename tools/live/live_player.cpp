// Over 400 lines: its steps share the state of one process, which copies of it go on with.
#include "tools/live/live_player.hpp"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <deque>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/any_error.hpp"
#include "tools/base/output/file_name.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/live/checkpoints.hpp"
#include "tools/live/lines/live_line.hpp"
#include "tools/live/live_building.hpp"
#include "tools/live/live_clock.hpp"
#include "tools/live/live_feed.hpp"
#include "tools/live/live_goal.hpp"
#include "tools/live/live_loading.hpp"
#include "tools/live/live_report.hpp"
#include "tools/live/live_trial.hpp"
#include "tools/scenario/localizers/ros2_yaml.hpp"

namespace castaway::testbed {
namespace {

using PlayerJson = nlohmann::ordered_json;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

constexpr nanoseconds kFramePeriod = milliseconds(25);
constexpr nanoseconds kBurst = milliseconds(10);  // Wall time between two looks at the commands.
constexpr double kCheckpointEvery = 10.0;         // [s] Of simulated time.
constexpr double kOpening = 1.0;                  // [s] In which the first scan should come.
constexpr std::size_t kMostUntold = 1000;         // Scans that are told at once.
constexpr double kSlowest = 0.1;
constexpr double kFastest = 100.0;

/// Thrown where a copy of the run goes on that was woken: it drops what it was doing.
struct Woken {
  LiveGoal goal;
};

bool has_nodes(const LiveSetup& setup) { return std::ranges::any_of(setup.localizers(), is_node); }

/// True if a localizer is a program. It cannot be copied, so that the run begins again to go back.
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
    awake([&] { begin(); });
    while (true) awake([&] { turn(); });
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

  /// Does something in which this process may turn out to be a copy that was woken.
  template <typename Work>
  void awake(Work work) {
    try {
      work();
    } catch (const Woken& woken) {
      reach_goal(woken.goal);
    }
  }

  void begin() {
    keep_checkpoint();
    build();
    open();
    if (setup_.playing) clock_.play(wall_time(), run_->now());
  }

  /// Tells of a run at its beginning, with a first scan to look at.
  void open() {
    to_first_scan();
    say_hello();
    say_scene();
  }

  /// Of a run with a node, which may come late, pages are told at once.
  void to_first_scan() {
    if (has_nodes(setup_)) return;
    const Stamp end = run_->now() + localization::from_seconds(kOpening);
    while (feed_->scans() == 0 && run_->now() < end && step()) {
    }
  }

  /// Throws Woken in a copy that is woken.
  void keep_checkpoint() {
    const Stamp now = run_ ? run_->now() : Stamp{};
    next_checkpoint_ = now + localization::from_seconds(kCheckpointEvery);
    std::optional<LiveGoal> goal;
    while (const auto woken = checkpoints_.keep(now)) goal = goal_of(*woken);
    if (goal) throw Woken{*std::move(goal)};
  }

  void end_run() {
    if (run_) run_->finish_localizers();
    run_.reset();
  }

  void turn() {
    listen();
    play_on();
    if (wall_time() >= next_frame_) tell();
  }

  /// Plays to the moment to go on from, as fast as it can, and tells anew what happened on the way.
  void reach_goal(const LiveGoal& goal) {
    undone_ = true;
    heard_.assign(goal.commands.begin(), goal.commands.end());
    if (!run_ || has_programs_) build_anew();
    if (setup_.bridge) setup_.bridge->mute(true);
    play_to(goal);
    if (setup_.bridge) setup_.bridge->mute(false);
    clock_.pause();
    clock_.set_speed(goal.speed, wall_time(), run_->now());
    if (goal.playing) clock_.play(wall_time(), run_->now());
    tell_all();
  }

  /// Its programs start anew.
  void build_anew() {
    end_run();
    build();
  }

  void play_to(const LiveGoal& goal) {
    const bool keeps = std::exchange(keeps_, false);
    do_again(goal.events);
    while (run_->now() < goal.time && step()) {
      do_again(goal.events);
      if (feed_->untold_scans() >= kMostUntold) line_.say(feed_->take_scans());
    }
    to_first_scan();
    keeps_ = keeps;
  }

  void tell_all() {
    say_hello();
    say_scene();  // Its doors and boxes are those of this moment.
    line_.say(feed_->take_events());
    told_ = Stamp{-1};
    tell();
  }

  /// Events that were done at this step, but for those that this copy has seen.
  void do_again(const std::vector<HandEvent>& events) {
    while (done_.size() < events.size() && events[done_.size()].step == steps_) {
      do_event(events[done_.size()].event);
    }
  }

  Stamp do_event(const std::string& event) {
    const Stamp at = run_->add(event);
    done_.push_back({steps_, at, event});
    const PlayerJson json = PlayerJson::parse(event);
    if (json.contains("drive")) feed_->on_drive(at, json.at("drive"));
    return at;
  }

  bool step() {
    if (!run_->step()) return false;
    ++steps_;
    if (keeps_ && !has_programs_ && run_->now() >= next_checkpoint_) keep_checkpoint();
    return true;
  }

  void play_on() {
    const nanoseconds begin = wall_time();
    const Stamp due = clock_.due(begin, run_->now());
    while (run_->now() < due && wall_time() - begin < kBurst) {
      if (!step()) return clock_.pause();
    }
  }

  /// Waits for commands until there is something else to do, and carries them out.
  void listen() {
    nanoseconds patience = next_frame_ - wall_time();
    if (clock_.is_playing()) {
      patience = std::min(patience, clock_.until(run_->now() + Stamp(1), wall_time()));
    }
    if (!heard_.empty()) patience = nanoseconds(0);
    for (std::string& command : line_.hear(patience)) heard_.push_back(std::move(command));
    while (!heard_.empty()) {
      const std::string command = std::move(heard_.front());
      heard_.pop_front();
      obey(command);
    }
  }

  void obey(const std::string& text) {
    try {
      const PlayerJson command = PlayerJson::parse(text);
      obey(command.at("do").get<std::string>(), command);
    } catch (const PlayerJson::exception&) {
      line_.say({{"said", "error"}, {"text", "not a command"}});
    } catch (const LineCut&) {
      throw;
    } catch (const Woken&) {
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
    const LiveGoal goal{std::clamp(time, Stamp{}, run_->now()),
                        clock_.speed(),
                        clock_.is_playing(),
                        done_,
                        {heard_.begin(), heard_.end()}};
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
    open();
  }

  void tell() {
    tell_of_report();
    next_frame_ = wall_time() + kFramePeriod;
    tell_of_events();
    if (run_->now() == told_ && feed_->untold_scans() == 0) return say_status_now_and_then();
    told_ = run_->now();
    line_.show(feed_->take_frame(
        {run_->now(), run_->true_pose(), run_->estimates(), run_->T_footprint_base()}));
    say_status_now_and_then();
  }

  void tell_of_events() {
    if (!feed_->has_events()) return;
    const bool changed = feed_->has_world_news();
    line_.say(feed_->take_events());
    if (changed) say_scene();
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
  std::vector<HandEvent> done_;    ///< Events of hands since the beginning,
  std::size_t steps_ = 0;          ///< and the steps that the run has taken.
  std::deque<std::string> heard_;  ///< Commands to be carried out.
  bool keeps_ = true;              ///< Leaves copies behind.
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
