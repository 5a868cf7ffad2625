// Over 400 lines: all tests take the same player behind a socket.
#include "tools/live/live_player.hpp"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/live/lines/wire.hpp"
#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

namespace fs = std::filesystem;

/// In place of a report: the scenario.
void note_scenario(const LoadedScenario& scenario, const fs::path&, const fs::path& out) {
  fs::create_directories(out);
  write_file(out / "made", scenario.effective);
}

LiveSetup in_the_lab(bool playing, const fs::path& files) {
  return {read_scenario(YamlDocument::parse("world: lab\nlidar: {rate_hz: 10, range_max: 12}\n"
                                            "localizers: [mh_amcl]\n",
                                            "live.yaml"),
                        data_root(), "live"),
          data_root(),
          playing,
          files,
          note_scenario,
          files};
}

/// A player in a process of its own, and the line to it.
class Player {
 public:
  explicit Player(bool playing = false, const fs::path& files = {}) {
    std::array<int, 2> ends{};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
    std::fflush(nullptr);  // Buffered output would be written twice.
    process_ = fork();
    if (process_ == 0) {
      close(ends[0]);
      play_live(in_the_lab(playing, files), ends[1]);
      _exit(0);
    }
    close(ends[1]);
    line_ = ends[0];
  }
  ~Player() {
    close(line_);
    waitpid(process_, nullptr, 0);
  }
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  void tell(const Json& command) const {
    const std::string bytes = to_wire(WireKind::kCommand, command.dump());
    EXPECT_EQ(send(line_, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
  }

  /// The next message that `wanted` accepts; null if the line ends.
  Json wait_for(const std::function<bool(const Json&)>& wanted) {
    while (true) {
      while (const auto message = reader_.next()) {
        const Json json = message->kind == WireKind::kSaid ? Json::parse(message->body)
                                                           : frame_head(message->body);
        if (wanted(json)) return json;
      }
      std::array<char, 65536> buffer{};
      const ssize_t count = recv(line_, buffer.data(), buffer.size(), 0);
      if (count <= 0) return nullptr;
      reader_.take({buffer.data(), static_cast<std::size_t>(count)});
    }
  }
  Json wait_for_said(const std::string& said) {
    return wait_for([&](const Json& json) { return json.value("said", "") == said; });
  }
  /// The first frame at or after this time.
  Json wait_for_frame(double at_s) {
    return wait_for([&](const Json& json) { return json.value("now", -1.0) >= at_s; });
  }

 private:
  static Json frame_head(const std::string& bytes) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      size |= static_cast<std::size_t>(static_cast<unsigned char>(bytes.at(i))) << (8 * i);
    }
    return Json::parse(bytes.substr(4, size));
  }

  pid_t process_ = -1;
  int line_ = -1;
  WireReader reader_;
};

TEST(LivePlayer, SaysHelloAndPlays) {
  Player player;
  const Json hello = player.wait_for_said("hello");
  EXPECT_EQ(hello.at("run").at("localizers"), Json({"mh_amcl"}));
  EXPECT_EQ(player.wait_for_said("status").at("playing"), false);
  player.tell({{"do", "speed"}, {"value", 50}});
  player.tell({{"do", "play"}});
  const Json frame = player.wait_for_frame(3.0);
  EXPECT_EQ(frame.at("truth").size(), 3U);
  player.tell({{"do", "pause"}});
  const auto paused = [](const Json& json) {
    return json.value("said", "") == "status" && !json.at("playing").get<bool>();
  };
  EXPECT_GE(player.wait_for(paused).at("now_s"), 3.0);
}

TEST(LivePlayer, SaysWhatCanBeSeenAndAgainWhenItWentBack) {
  Player player;
  player.wait_for_said("hello");
  EXPECT_FALSE(player.wait_for_said("scene")
                   .at("scene")
                   .at("world")
                   .at("indices")
                   .get<std::string>()
                   .empty());
  player.tell({{"do", "back"}, {"to_s", 0.0}});
  bool told = false;
  player.wait_for([&](const Json& json) {
    told = told || json.value("said", "") == "scene";
    return json.value("undone", false);
  });
  player.tell({{"do", "step"}});
  player.wait_for([&](const Json& json) {
    told = told || json.value("said", "") == "scene";
    return json.contains("scans") && !json.at("scans").empty();
  });
  EXPECT_TRUE(told);
}

TEST(LivePlayer, StepsFromScanToScan) {
  Player player;
  player.tell({{"do", "step"}});
  player.tell({{"do", "step"}});
  const auto has_scan = [](const Json& json) {
    return json.contains("scans") && !json.at("scans").empty();
  };
  const double first = player.wait_for(has_scan).at("scans").back().at(0);
  player.tell({{"do", "step"}});
  const double next = player.wait_for(has_scan).at("scans").back().at(0);
  EXPECT_GT(next, first);
  EXPECT_LE(next - first, 0.2 + 1e-9);
}

TEST(LivePlayer, DoesWhatHandsDoAndSaysWhatIsWrong) {
  Player player;
  player.tell({{"do", "event"}, {"event", {{"kidnap", {{"pose", {900, 0, 0}}}}}}});
  EXPECT_THAT(player.wait_for_said("error").at("text").get<std::string>(), HasSubstr("900"));
  player.tell({{"do", "dance"}});
  EXPECT_THAT(player.wait_for_said("error").at("text").get<std::string>(), HasSubstr("dance"));
  player.tell({{"do", 3}});
  EXPECT_EQ(player.wait_for_said("error").at("text"), "not a command");
  player.tell({{"do", "event"}, {"event", {{"kidnap", {{"min_distance_m", 1}}}}}});
  EXPECT_LT(player.wait_for_said("done").at("at_s").get<double>(), 0.25);
  player.tell({{"do", "step"}});
  EXPECT_EQ(player.wait_for_said("events").at("events").at(0).at("kind"), "kidnap");
  player.tell({{"do", "save"}});
  EXPECT_THAT(player.wait_for_said("scenario").at("yaml").get<std::string>(),
              HasSubstr("min_distance_m: 1"));
}

TEST(LivePlayer, TakesAnotherWorldOfItsFiles) {
  const TemporaryFolder temporary;
  const fs::path& files = temporary.path();
  write_file(files / "room.yaml",
             "name: room\nextent: {min: [-3, -3], max: [3, 3]}\nobjects:\n"
             "  - wall: {closed: true, points: [[-3, -3], [3, -3], [3, 3], [-3, 3]]}\n");
  write_file(files / "broken.yaml", "objects: [3");
  write_file(files / "note.txt", "");
  Player player(false, files);
  player.wait_for_said("hello");
  const auto refused = [&](const char* file) {
    player.tell({{"do", "load"}, {"file", file}});
    return player.wait_for_said("error").at("text").get<std::string>();
  };
  EXPECT_THAT(refused("broken.yaml"), HasSubstr("broken.yaml"));
  EXPECT_THAT(refused("note.txt"), HasSubstr("no world"));
  EXPECT_THAT(refused("none.sdf"), HasSubstr("no file"));
  EXPECT_THAT(refused("../broken.yaml"), HasSubstr("no file of a page"));
  player.tell({{"do", "step"}});  // The run is unharmed.
  player.wait_for_frame(0.05);
  player.tell({{"do", "load"}, {"file", "room.yaml"}});
  EXPECT_EQ(player.wait_for_said("hello").at("run").at("world"), "room");
  player.tell({{"do", "speed"}, {"value", 100}});
  player.tell({{"do", "play"}});
  player.wait_for_frame(3.0);
  player.tell({{"do", "back"}, {"to_s", 1.0}});
  player.wait_for_said("hello");
  EXPECT_NEAR(player.wait_for_frame(0.0).at("now").get<double>(), 1.0, 0.02);
}

TEST(LivePlayer, MakesReportsOfTheRunUntilNow) {
  const TemporaryFolder temporary;
  const fs::path& files = temporary.path();
  Player player(false, files);
  player.tell({{"do", "step"}});
  player.wait_for_frame(0.05);
  for (const int number : {1, 2}) {
    player.tell({{"do", "report"}});
    const Json said = player.wait_for_said("report");
    EXPECT_EQ(said.at("number"), number);
    EXPECT_THAT(read_file(fs::path(said.at("folder").get<std::string>()) / "made"),
                HasSubstr("duration_s"));
  }
}

TEST(LivePlayer, GoesBackToAnyMomentAndOnFromThere) {
  Player player;
  player.wait_for_said("hello");
  player.tell({{"do", "speed"}, {"value", 100}});
  player.tell({{"do", "play"}});
  player.wait_for_frame(5.0);
  player.tell({{"do", "event"}, {"event", {{"kidnap", {{"min_distance_m", 1}}}}}});
  player.wait_for_frame(25.0);
  player.tell({{"do", "back"}, {"to_s", 12.5}});
  EXPECT_EQ(player.wait_for_said("hello").at("undone"), true);
  const Json frame = player.wait_for_frame(0.0);
  EXPECT_NEAR(frame.at("now").get<double>(), 12.5, 0.02);
  player.tell({{"do", "back"}, {"to_s", 2.0}});
  player.wait_for_said("hello");
  EXPECT_NEAR(player.wait_for_frame(0.0).at("now").get<double>(), 2.0, 0.02);
  player.tell({{"do", "save"}});
  EXPECT_THAT(player.wait_for_said("scenario").at("yaml").get<std::string>(),
              testing::Not(HasSubstr("min_distance_m: 1\n")));
}

TEST(LivePlayer, GoingBackKeepsWhatHandsDidBefore) {
  Player player;
  player.wait_for_said("hello");
  player.tell({{"do", "speed"}, {"value", 100}});
  const auto play_until = [&](double time_s) {
    player.tell({{"do", "play"}});
    player.wait_for_frame(time_s);
  };
  const auto kidnap = [&](double min_distance_m) {
    player.tell({{"do", "event"}, {"event", {{"kidnap", {{"min_distance_m", min_distance_m}}}}}});
    return player.wait_for_said("done").at("at_s").get<double>();
  };
  play_until(12.0);  // After the copy at 10 s.
  const double kept_at_s = kidnap(1.25);
  play_until(std::max(16.0, kept_at_s + 4.0));  // However late the first one was.
  kidnap(1.5);
  const auto go_back = [&] {
    player.tell({{"do", "pause"}});
    player.tell({{"do", "back"}, {"to_s", kept_at_s + 1.0}});
    player.wait_for_said("hello");
    player.tell({{"do", "save"}});
    return player.wait_for_said("scenario").at("yaml").get<std::string>();
  };
  const std::string saved = go_back();
  EXPECT_THAT(saved, HasSubstr("min_distance_m: 1.25\n"));
  EXPECT_THAT(saved, testing::Not(HasSubstr("min_distance_m: 1.5\n")));
  play_until(25.0);
  EXPECT_EQ(go_back(), saved);
}

/// What a page knows of a run: its scans and events, by the numbers that it is told.
class Known {
 public:
  void take(const Json& told) {
    take_rows(told, "scans", scans_);
    take_rows(told, "events", events_);
  }
  [[nodiscard]] const std::vector<Json>& scans() const { return scans_; }
  [[nodiscard]] const std::vector<Json>& events() const { return events_; }

 private:
  static void take_rows(const Json& told, const char* key, std::vector<Json>& rows) {
    if (!told.contains(key)) return;
    const auto first = told.at("first").get<std::size_t>();
    ASSERT_LE(first, rows.size()) << key;
    rows.resize(first);
    for (const Json& row : told.at(key)) rows.push_back(row);
  }

  std::vector<Json> scans_;
  std::vector<Json> events_;
};

/// A player with somebody who listens to it.
class WatchedPlayer {
 public:
  void tell(const Json& command) { player_.tell(command); }
  void until(const std::function<bool(const Json&)>& wanted) {
    (void)player_.wait_for([&](const Json& json) {
      known_.take(json);
      now_s_ = json.value("now", now_s_);
      return wanted(json);
    });
  }
  void play_until(double time_s) {
    tell({{"do", "play"}});
    until([&](const Json& json) { return json.value("now", 0.0) >= time_s; });
    tell({{"do", "pause"}});
    until_status([](const Json& status) { return !status.at("playing").get<bool>(); });
  }
  void kidnap() {
    tell({{"do", "event"}, {"event", {{"kidnap", {{"min_distance_m", 1}}}}}});
    until([](const Json& json) { return json.value("said", "") == "done"; });
  }
  /// Until the frame there has been told.
  void go_back(double time_s) {
    tell({{"do", "back"}, {"to_s", time_s}});
    until([](const Json& json) { return json.value("undone", false); });
    until([](const Json& json) { return json.contains("now"); });
  }
  void until_status(const std::function<bool(const Json&)>& wanted) {
    until([&](const Json& json) { return json.value("said", "") == "status" && wanted(json); });
  }
  [[nodiscard]] const Known& known() const { return known_; }
  /// Of the last frame.
  [[nodiscard]] double now() const { return now_s_; }

 private:
  Player player_;
  Known known_;
  double now_s_ = 0.0;
};

TEST(LivePlayer, GoingBackTellsTheWayThereAnew) {
  WatchedPlayer player;
  player.tell({{"do", "speed"}, {"value", 100}});
  player.play_until(12.0);
  player.kidnap();
  player.play_until(player.now() + 2.0);
  const Known before = player.known();
  const double moment = player.now();
  ASSERT_EQ(before.events().size(), 1U);
  player.play_until(moment + 11.0);
  player.go_back(moment);
  const std::size_t common = std::min(before.scans().size(), player.known().scans().size());
  EXPECT_GE(common + 1, before.scans().size());
  EXPECT_LE(player.known().scans().size(), before.scans().size() + 1);
  for (std::size_t i = 0; i < common; ++i) {
    ASSERT_EQ(player.known().scans()[i], before.scans()[i]) << i;
  }
  EXPECT_EQ(player.known().events(), before.events());
  player.go_back(11.0);
  EXPECT_TRUE(player.known().events().empty());
}

TEST(LivePlayer, ARunThatPlaysGoesOnPlayingAfterItWentBack) {
  WatchedPlayer player;
  player.play_until(1.0);
  player.go_back(0.5);
  player.until_status([](const Json& status) { return !status.at("playing").get<bool>(); });
  player.tell({{"do", "play"}});
  player.until([](const Json& json) { return json.value("now", 0.0) > 1.0; });
  player.go_back(0.5);
  player.until_status([](const Json& status) { return status.at("playing").get<bool>(); });
  player.until([](const Json& json) { return json.value("now", 0.0) > 1.0; });
}

TEST(LivePlayer, OpensWithAScan) {
  WatchedPlayer player;
  player.until([](const Json& json) { return json.contains("now"); });
  EXPECT_EQ(player.known().scans().size(), 1U);
  player.play_until(1.0);
  player.go_back(0.0);
  EXPECT_EQ(player.known().scans().size(), 1U);
}

TEST(LivePlayer, ACopyThatWasMadeInAStepGoesOnWhereItIsToGo) {
  WatchedPlayer player;
  player.tell({{"do", "speed"}, {"value", 100}});
  player.play_until(9.0);
  for (int i = 0; i < 30; ++i) player.tell({{"do", "step"}});
  player.until([](const Json& json) { return json.value("now", 0.0) > 11.5; });
  player.go_back(10.5);
  const double last = player.known().scans().back().at(0);
  EXPECT_NEAR(last, 10.4, 0.15);
  player.tell({{"do", "step"}});
  const std::size_t count = player.known().scans().size();
  player.until([&](const Json&) { return player.known().scans().size() > count; });
  EXPECT_NEAR(player.known().scans().back().at(0).get<double>(), last + 0.1, 1e-3);
}

TEST(LivePlayer, WhatIsAskedForTogetherWithGoingBackIsDone) {
  WatchedPlayer player;
  player.play_until(2.0);
  player.tell({{"do", "back"}, {"to_s", 1.0}});
  player.tell({{"do", "save"}});
  player.until([](const Json& json) { return json.value("said", "") == "scenario"; });
}

TEST(LivePlayer, GoingBackChangesNothingOfThePast) {
  const auto truth_at = [](bool back) {
    Player player;
    std::map<double, Json> poses;
    const auto play_until = [&](double time_s) {
      player.tell({{"do", "play"}});
      player.wait_for([&](const Json& json) {
        if (json.contains("scans")) {
          for (const Json& scan : json.at("scans")) poses[scan.at(0).get<double>()] = scan.at(2);
        }
        return json.value("now", 0.0) >= time_s;
      });
    };
    player.tell({{"do", "speed"}, {"value", 100}});
    play_until(15.0);
    player.tell({{"do", "pause"}});
    if (back) {
      player.tell({{"do", "back"}, {"to_s", 11.0}});
      player.wait_for_said("hello");
      poses.clear();
    }
    play_until(20.0);
    return poses.lower_bound(19.0)->second;
  };
  EXPECT_EQ(truth_at(false), truth_at(true));
}

}  // namespace
}  // namespace castaway::testbed
