#include "tools/play/replay/replay_session.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

ReplaySession session_from(const std::string& text) {
  return read_session(YamlDocument::parse(text, "saved.yaml"));
}

std::string trouble_of(const std::string& text) {
  return error_of([&] { session_from(text); });
}

TEST(ReplaySession, IsTheWholeLogByDefault) {
  const ReplaySession session = session_from("log: a.log\n");
  EXPECT_EQ(session.log, "a.log");
  EXPECT_FALSE(session.known_start);
  EXPECT_EQ(session.part.from_scan, 0U);
  EXPECT_FALSE(session.part.scans);
  EXPECT_EQ(names_of(session.localizers), (std::vector<std::string>{"mh_amcl"}));
}

TEST(ReplaySession, ReadsBackWhatItWrites) {
  const ReplaySession session = session_from(
      "log: a.log\nmap: m.yaml\nstart: truth\nfrom_scan: 5\nscans: 40\nscans_used: odd\nseed: 7\n"
      "localizers: [{amcl: {preset: amcl-recovery}}]\nscan_topics: [/scan]\n"
      "events:\n"
      "  - splice: {after_scans: 12, to_scan: 90}\n"
      "  - localizer: {name: amcl-recovery, do: relocalize, at_s: 3}\n"
      "  - splice: {after_scans: 20, to_scan: 3}\n"
      "  - localizer: {name: amcl-recovery, do: 'off', at_s: 1.5}\n");
  const ReplaySession again = session_from(emit_yaml(session.tree));
  EXPECT_EQ(emit_yaml(again.tree), emit_yaml(session.tree));
  EXPECT_TRUE(again.known_start);
  EXPECT_EQ(again.seed, 7U);
  EXPECT_EQ(again.part.scans, 40U);
  EXPECT_EQ(again.scans_used, CarmenSourceConfig::Scans::kOdd);
  EXPECT_EQ(again.topics.scans, (std::vector<std::string>{"/scan"}));
  ASSERT_EQ(again.part.jumps.size(), 2U);
  EXPECT_EQ(again.part.jumps[1].after_scans, 20U);
  EXPECT_EQ(again.part.jumps[1].to_scan, 3U);
  ASSERT_EQ(again.orders.size(), 2U);
  EXPECT_EQ(again.orders[0].what, LocalizerOrder::What::kOff);  // In order of time.
}

TEST(ReplaySession, OnA3dMapIsPlayedByTheLocalizerForIt) {
  const ReplaySession session =
      session_from("log: a\nmap3d: a.bt\nimu_topic: /imu\nbase_height: 0.1\n");
  EXPECT_EQ(session.map3d, "a.bt");
  EXPECT_EQ(session.topics.imu, "/imu");
  EXPECT_EQ(session.base_height, 0.1);
  EXPECT_EQ(names_of(session.localizers), (std::vector<std::string>{"mh_amcl-3d"}));
  EXPECT_EQ(emit_yaml(session_from(emit_yaml(session.tree)).tree), emit_yaml(session.tree));
  EXPECT_EQ(emit_yaml(session_from("log: a\n").tree).find("3d"), std::string::npos);
  EXPECT_TRUE(contains(trouble_of("log: a\nmap3d: a.bt\nlocalizers: [mh_amcl]\n"),
                       "(--map3d) is for mh_amcl in mode 3d"));
}

TEST(ReplaySession, PlacesTheTruthInTheMap) {
  const ReplaySession session = session_from("log: a\ntruth_in_map: [1.5, -2, 0.25]\n");
  EXPECT_EQ(session.T_map_truth.x, 1.5);
  EXPECT_EQ(session.T_map_truth.y, -2.0);
  EXPECT_EQ(session.T_map_truth.yaw, 0.25);
  EXPECT_EQ(emit_yaml(session_from(emit_yaml(session.tree)).tree), emit_yaml(session.tree));
  EXPECT_EQ(emit_yaml(session_from("log: a\n").tree).find("truth_in_map"), std::string::npos);
  EXPECT_TRUE(contains(trouble_of("log: a\ntruth_in_map: [1, 2]\n"), "a list of 3 numbers"));
}

TEST(ReplaySession, NamesWhatIsWrong) {
  EXPECT_TRUE(contains(trouble_of("map: m.yaml\n"), "log"));
  EXPECT_TRUE(contains(trouble_of("log: a\nscans: 0\n"), "'scans' is 0"));
  EXPECT_TRUE(contains(trouble_of("log: a\nscan: 5\n"), "saved.yaml:2"));
  EXPECT_TRUE(contains(trouble_of("log: a\nevents: [{box: {at: [1, 1]}}]\n"),
                       "unknown event 'box' of a replay; known: localizer, splice"));
  EXPECT_TRUE(contains(trouble_of("log: a\nevents: [{splice: {to_scan: 3}}]\n"), "after_scans"));
  EXPECT_TRUE(
      contains(trouble_of("log: a\nevents: [{localizer: {name: amcl, do: 'off', at_s: 1}}]\n"),
               "for localizer 'amcl'"));
  EXPECT_TRUE(
      contains(trouble_of("log: a\nlocalizers: [{program: ./mine}]\n"), "--allow-programs"));
}

}  // namespace
}  // namespace castaway::testbed
