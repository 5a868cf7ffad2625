#include "tools/scenario/scenario_file.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

class ScenarioFileTest : public testing::Test {
 protected:
  LoadedScenario load(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return load_scenario(folder_.put("trial.yaml", text), overrides);
  }
  /// Text of the error; empty if there is none.
  std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
      (void)load(text, overrides);
      return "";
    } catch (const std::exception& error) {
      return error.what();
    }
  }
  static void expect_contains(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(ScenarioFileTest, HasADefaultForEveryKeyButTheLocalizers) {
  const Scenario scenario = load("localizers: [mh_amcl]").scenario;
  EXPECT_EQ(scenario.name, "trial");
  EXPECT_EQ(scenario.world.file, "lab");
  EXPECT_EQ(scenario.seed, 1U);
  EXPECT_EQ(scenario.duration_s, 120.0);
  EXPECT_TRUE(scenario.start.known);
  EXPECT_EQ(scenario.localizers.at(0).name, "mh_amcl");
}

TEST_F(ScenarioFileTest, SetsKeysBesideARobotAndAWorldThatAreGivenShort) {
  const std::string text = "localizers: [mh_amcl]\nrobot: butler\nworld: office";
  const Scenario scenario =
      load(text, {"robot.joints.arm=0.5", "world.search_paths=[models]"}).scenario;
  EXPECT_EQ(scenario.robot.file, "butler");
  EXPECT_EQ(scenario.robot.joints.at("arm"), 0.5);
  EXPECT_EQ(scenario.world.file, "office");
  EXPECT_EQ(scenario.world.search_paths, std::vector<std::string>{"models"});
  const Scenario given =
      load("localizers: [mh_amcl]", {"robot=mule", "robot.joints.arm=1"}).scenario;
  EXPECT_EQ(given.robot.file, "mule");
  EXPECT_EQ(load(text, {"robot.file=mule"}).scenario.robot.file, "mule");
}

TEST_F(ScenarioFileTest, NamesTheWorldInOneWordOrWithItsDifferences) {
  const WorldChoice plain = load("{world: home, localizers: [mh_amcl]}").scenario.world;
  EXPECT_EQ(plain.file, "home");
  EXPECT_FALSE(plain.differences.has_value());
  const std::string text =
      "{world: {name: w.sdf, search_paths: [models], differences: {remove: 0.2}}, localizers: "
      "[mh_amcl]}";
  const LoadedScenario loaded = load(text);
  EXPECT_EQ(loaded.scenario.world.file, "w.sdf");
  EXPECT_EQ(loaded.scenario.world.search_paths, std::vector<std::string>{"models"});
  ASSERT_TRUE(loaded.scenario.world.differences.has_value());
  EXPECT_EQ(loaded.scenario.world.differences->remove, 0.2);
  EXPECT_EQ(load(loaded.effective).scenario.world.differences->remove, 0.2);
  EXPECT_EQ(load(text, {"world=lab"}).scenario.world.file, "lab");
  EXPECT_EQ(load(text, {"world.differences.remove=0.5"}).scenario.world.differences->remove, 0.5);
  expect_contains(error_of("{world: {nam: lab}, localizers: [mh_amcl]}"), "'name'");
}

TEST_F(ScenarioFileTest, NamesAnotherMapThanTheWorlds) {
  const LoadedScenario loaded = load("{world: {name: w.yaml, map: m.yaml}, localizers: [amcl]}");
  EXPECT_EQ(loaded.scenario.world.file, "w.yaml");
  EXPECT_EQ(loaded.scenario.world.map, "m.yaml");
  EXPECT_EQ(load(loaded.effective).scenario.world.map, "m.yaml");
  EXPECT_EQ(load("{world: {name: w.yaml}, localizers: [amcl]}").scenario.world.map, "");
}

TEST_F(ScenarioFileTest, KeepsTheScanTimesOfALidar) {
  const LoadedScenario loaded = load("{lidar: {scan_times: times.txt}, localizers: [amcl]}");
  EXPECT_EQ(loaded.scenario.lidars.at(0).scan_times, "times.txt");
  EXPECT_EQ(load(loaded.effective).scenario.lidars.at(0).scan_times, "times.txt");
}

TEST_F(ScenarioFileTest, NamesTheRobotInOneWordOrWithItsArguments) {
  EXPECT_EQ(load("localizers: [mh_amcl]").scenario.robot.file, "waffle");
  EXPECT_EQ(load("{robot: mule, localizers: [mh_amcl]}").scenario.robot.file, "mule");
  const LoadedScenario loaded = load(R"(
robot: {file: a.xacro, args: {size: 0.5, arms: true}, search_paths: [.., /opt]}
localizers: [mh_amcl]
)");
  const RobotSpec& robot = loaded.scenario.robot;
  EXPECT_EQ(robot.file, "a.xacro");
  EXPECT_EQ(robot.arguments.at("size"), "0.5");
  EXPECT_EQ(robot.arguments.at("arms"), "true");
  EXPECT_EQ(robot.search_paths, (std::vector<std::string>{"..", "/opt"}));
  EXPECT_EQ(load(loaded.effective).effective, loaded.effective);
  expect_contains(error_of("{robot: {args: {a: 1}}, localizers: [mh_amcl]}"), "'file'");
  expect_contains(error_of("{robot: {file: a, arg: {a: 1}}, localizers: [mh_amcl]}"), "args");
}

TEST_F(ScenarioFileTest, ReadsWhatIsWritten) {
  const Scenario scenario = load(R"(
name: trial-7
world: maps/home.yaml
start: {pose: [1, 2, 0.5], sigma_m: 0.3}
drive: {route: loop, by: mh_amcl, max_speed: 0.4}
lidar: {beams: 180, range_max: 8, mount_rpy: [3.14159, 0, 0]}
odometry: {profile: ideal, drift_yaw_deg: 2}
events:
  - kidnap: {at_s: 10, min_distance_m: 5}
  - kidnap: {kind: teleport, at_s: 20, pose: [3, 4, 1]}
localizers:
  - mh_amcl: {max_beams: 45}
  - amcl: {preset: amcl-recovery, max_particles: 900}
outputs: {snapshots: {every_s: 5, on_events: false}}
)")
                                .scenario;
  EXPECT_EQ(scenario.start.place, StartSpec::Place::kPose);
  EXPECT_EQ(scenario.start.pose, Eigen::Vector3d(1, 2, 0.5));
  EXPECT_EQ(scenario.drive.by, "mh_amcl");
  EXPECT_EQ(scenario.lidars.front().changes.find("beams")->scalar, "180");
  EXPECT_EQ(scenario.odometry.track_sigma, 0.0);
  EXPECT_EQ(scenario.odometry.drift_yaw_deg, 2.0);
  ASSERT_EQ(scenario.events.simulated.kidnaps.size(), 2U);
  EXPECT_EQ(scenario.events.simulated.kidnaps[0].min_distance_m, 5.0);
  EXPECT_EQ(scenario.events.simulated.kidnaps[1].target->y, 4.0);
  EXPECT_EQ(scenario.localizers[1].name, "amcl-recovery");
  const auto& amcl = std::get<localization::AmclConfig>(scenario.localizers[1].config);
  EXPECT_EQ(amcl.kld.max_particles, 900);
  EXPECT_EQ(amcl.recovery.alpha_fast, 0.1);
  EXPECT_FALSE(scenario.outputs.pictures.on_events);
}

TEST_F(ScenarioFileTest, TakesAnUnknownStart) {
  const Scenario scenario = load("start: unknown\nlocalizers: [amcl]").scenario;
  EXPECT_EQ(scenario.start.place, StartSpec::Place::kRandom);
  EXPECT_FALSE(scenario.start.known);
}

TEST_F(ScenarioFileTest, ItsEffectiveTextReproducesIt) {
  const LoadedScenario first =
      load("events: [{kidnap: {at_s: 3}}]\nlocalizers: [amcl: {max_beams: 30}]",
           {"seed=9", "lidar.beams=90"});
  const LoadedScenario second = load(first.effective);
  EXPECT_EQ(second.effective, first.effective);
  EXPECT_EQ(second.scenario.seed, 9U);
  EXPECT_EQ(second.scenario.lidars.front().changes.find("beams")->scalar, "90");
  EXPECT_EQ(second.scenario.events.simulated.kidnaps.at(0).when.value, 3.0);
}

TEST_F(ScenarioFileTest, ReadsLidarsFaultsAndOutputsAndReproducesThem) {
  const LoadedScenario first = load(
      "lidars: [front, {rear: {profile: lds-01, mount_xyz: [-0.2, 0, 0.1]}}]\n"
      "odometry: {profile: slippery, gyro: {}}\n"
      "events: [{fault: {kind: lidar-late, at_s: 3, for_s: 2, lidar: rear}}]\n"
      "outputs: {scans: true, points: {every_s: 2}}\nlocalizers: [amcl]");
  const LoadedScenario second = load(first.effective);
  EXPECT_EQ(second.effective, first.effective);
  ASSERT_EQ(second.scenario.lidars.size(), 2U);
  EXPECT_EQ(second.scenario.lidars[1].profile, "lds-01");
  EXPECT_TRUE(second.scenario.odometry.gyro.has_value());
  ASSERT_EQ(second.scenario.events.simulated.faults.size(), 1U);
  EXPECT_EQ(second.scenario.events.simulated.faults[0].lidar, "rear");
  EXPECT_TRUE(second.scenario.outputs.scans);
  EXPECT_EQ(second.scenario.outputs.points_every_s, 2.0);
}

/// With a list of lidars, `lidar` would be ignored.
TEST_F(ScenarioFileTest, TakesOneLidarOrAList) {
  EXPECT_THROW((void)load("lidar: {rate_hz: 5}\nlidars: [front]\nlocalizers: [amcl]"),
               std::runtime_error);
}

TEST_F(ScenarioFileTest, OverridesReachIntoLists) {
  const Scenario scenario =
      load("events: [{kidnap: {at_s: 3}}]\nlocalizers: [mh_amcl]", {"events.0.kidnap.at_s=8"})
          .scenario;
  EXPECT_EQ(scenario.events.simulated.kidnaps.at(0).when.value, 8.0);
}

TEST_F(ScenarioFileTest, NamesTheNearestKeyOfAnUnknownOne) {
  const std::string error = error_of("localizers: [mh_amcl]\ndrive:\n  rute: loop\n");
  expect_contains(error, "trial.yaml:3");
  expect_contains(error, "rute");
  expect_contains(error, "route");
}

TEST_F(ScenarioFileTest, ReadsMhAmclOn3dMaps) {
  const LocalizerSpec spec =
      load("{localizers: [{mh_amcl: {mode: 3d, voxel: 0.05, max_beams: 45}}]}")
          .scenario.localizers.front();
  EXPECT_EQ(spec.name, "mh_amcl-3d");
  const auto& config = std::get<localization::MhAmcl3dConfig>(spec.config);
  EXPECT_EQ(config.voxel, 0.05);
  EXPECT_EQ(config.mh_amcl.input.beams.max_beams, 45);
  expect_contains(error_of("{localizers: [{mh_amcl: {mode: 3d, voxel: 0}}]}"), "voxel");
  expect_contains(error_of("{localizers: [{mh_amcl: {voxel: 0.1}}]}"), "voxel");
}

TEST_F(ScenarioFileTest, MhAmclWeighsAlongBeamsOn3dMaps) {
  const LocalizerSpec spec =
      load("{localizers: [{mh_amcl: {mode: 3d, track_by: along_beam}}]}").scenario.localizers[0];
  EXPECT_EQ(std::get<localization::MhAmcl3dConfig>(spec.config).mh_amcl.track_by,
            localization::TrackingError::kAlongBeam);
  expect_contains(error_of("{localizers: [{mh_amcl: {track_by: along_beam}}]}"), "track_by");
  expect_contains(
      error_of("{localizers: [{mh_amcl: {mode: 3d, track_by: along_beam, belief: gaussians}}]}"),
      "track_by weighs particles");
}

TEST_F(ScenarioFileTest, ReadsTheModesOfMhAmclWithTheirDefects) {
  const auto config = [this](const std::string& settings) {
    return load("localizers: [mh_amcl: {" + settings + "}]").scenario.localizers[0].config;
  };
  using localization::PublishedDefects;
  const auto published = [&](const std::string& settings) {
    return std::get<localization::PublishedMhAmclConfig>(config(settings));
  };
  const auto improved = std::get<localization::MhAmclConfig>(config("found: 0.99"));
  EXPECT_EQ(improved.lost_and_found.found, 0.99);
  const auto paper = std::get<localization::PaperMhAmclConfig>(
      config("mode: paper, max_beams: 30, min_particles: 60"));
  EXPECT_EQ(paper.input.beams.max_beams, 30);
  EXPECT_EQ(paper.size.min_particles, 60);
  EXPECT_EQ(published("mode: published").defects, localization::all_defects());
  EXPECT_EQ(published("mode: published").paper.reseed.winners, 0.03);
  EXPECT_EQ(published("mode: published, max_beams: 30").paper.input.beams.max_beams, 30);
  const auto one = published("mode: paper, defects: [summed_weights]").defects;
  EXPECT_TRUE(one.summed_weights);
  EXPECT_FALSE(one.winner_unused);
  EXPECT_EQ(published("mode: published, defects: []").defects, PublishedDefects{});
  expect_contains(error_of("localizers: [mh_amcl: {mode: paper, defects: [sumed_weights]}]"),
                  "summed_weights");
  expect_contains(error_of("localizers: [mh_amcl: {defects: [mount_ignored]}]"), "defects");
}

TEST_F(ScenarioFileTest, WatchesTheFirstLocalizerWhereAKidnapWaitsForOne) {
  const std::string waiting = "events: [{kidnap: {when_localized_s: 5}}]\nlocalizers: ";
  EXPECT_EQ(load(waiting + "[amcl, mh_amcl]").scenario.events.watched, "amcl");
  EXPECT_EQ(load("{events: [{kidnap: {at_s: 5}}], localizers: [amcl]}").scenario.events.watched,
            "");
  expect_contains(error_of("{events: [{kidnap: {when_localized_s: 5, localizer: amlc}}], "
                           "localizers: [amcl]}"),
                  "did you mean 'amcl'");
}

TEST_F(ScenarioFileTest, TellsTheLocalizersAWrongPlaceIfAsked) {
  const Scenario scenario = load("{start: {wrong_by: [1, 0, 0.5]}, localizers: [amcl]}").scenario;
  EXPECT_TRUE(scenario.start.known);
  EXPECT_FALSE(scenario.start.initializes());
  EXPECT_EQ(scenario.start.wrong_by, Eigen::Vector3d(1.0, 0.0, 0.5));
  EXPECT_TRUE(load("localizers: [amcl]").scenario.start.initializes());
  expect_contains(error_of("{start: {known: false, wrong_by: [1, 0, 0]}, localizers: [amcl]}"),
                  "known");
}

TEST_F(ScenarioFileTest, ChoosesWhatMovesTheRobot) {
  EXPECT_FALSE(load("localizers: [amcl]").scenario.kinematic);
  const Scenario kinematic = load("{physics: kinematic, localizers: [amcl]}").scenario;
  EXPECT_TRUE(kinematic.kinematic);
  EXPECT_EQ(kinematic.physics_hz, 100.0);
  expect_contains(error_of("{physics: jolt, localizers: [amcl]}"), "kinematic");
}

TEST_F(ScenarioFileTest, NamesTheLineOfWhatIsWrong) {
  expect_contains(error_of("localizers: [mh_amcl]\nduration_s: soon"), "trial.yaml:2");
  expect_contains(error_of("localizers: [mh_amcl]\nduration_s: -5"), "out of range");
  expect_contains(error_of("localizers: [mh_amcl]\nseed: [1"), "trial.yaml:");
  expect_contains(error_of("localizers: [mh_amlc]"), "mh_amcl");
  expect_contains(error_of("localizers: [amcl: {preset: fast}]"), "amcl-recovery");
  expect_contains(error_of("localizers: [amcl: {max_beams: 1}]"), "max_beams");
  expect_contains(error_of("localizers: [amcl, amcl]"), "name");
  expect_contains(error_of("localizers: [mh_amcl: {mode: papre}]"), "paper");
  expect_contains(error_of("localizers: []"), "localizers");
  expect_contains(error_of("localizers: [amcl]\nevents: [{kidnap: {min_distance_m: 2}}]"), "at_s");
  expect_contains(error_of("localizers: [amcl]\nevents: [{fire: {}}]"), "kidnap");
  expect_contains(error_of("localizers: [amcl]\nstart: somewhere"), "unknown");
}

TEST_F(ScenarioFileTest, ReadsTheSensorModelsOfAmclByNav2sNames) {
  const auto config = [this](const std::string& settings) {
    const Scenario scenario = load("localizers: [amcl: {" + settings + "}]").scenario;
    return std::get<localization::AmclConfig>(scenario.localizers[0].config);
  };
  using Model = localization::AmclSensorModel;
  EXPECT_EQ(config("").model, Model::kLikelihoodField);
  EXPECT_EQ(config("preset: amcl-prob").model, Model::kLikelihoodFieldProb);
  EXPECT_EQ(config("laser_model_type: likelihood_field_prob").model, Model::kLikelihoodFieldProb);
  const auto beam = config("laser_model_type: beam, z_hit: 0.9, z_short: 0.1, lambda_short: 0.2");
  EXPECT_EQ(beam.model, Model::kBeam);
  EXPECT_EQ(beam.beam.z_hit, 0.9);
  EXPECT_EQ(beam.beam.z_short, 0.1);
  EXPECT_EQ(beam.beam.z_max, 0.05);
  EXPECT_EQ(beam.beam.lambda_short, 0.2);
  EXPECT_TRUE(config("update_at_rest: true").update_at_rest);
  EXPECT_TRUE(config("half_cell_shift: true").half_cell_shift);
}

TEST_F(ScenarioFileTest, SaysWhoIsToldOfKidnaps) {
  const Scenario scenario = load(
                                "localizers: [amcl, {amcl: {preset: amcl-global}}, "
                                "{mh_amcl: {global_localization_at_kidnap: true}}]")
                                .scenario;
  EXPECT_FALSE(scenario.localizers[0].relocalize_at_kidnap);
  EXPECT_TRUE(scenario.localizers[1].relocalize_at_kidnap);
  EXPECT_TRUE(scenario.localizers[2].relocalize_at_kidnap);
}

TEST(Scenario, NeedsNoLocalizersWhereItIsSaid) {
  const TemporaryFolder folder;
  const auto load = [&](const std::string& text) {
    return load_scenario(folder.put("s.yaml", text), {}).scenario;
  };
  EXPECT_TRUE(load("localizers: []\noutputs: {report: false}\n").localizers.empty());
  EXPECT_TRUE(contains(error_of([&] { load("localizers: []\n"); }),
                       "'outputs.report' shows localizers, and there are none"));
}

TEST(ParseLocalizer, TakesANameAndAPreset) {
  EXPECT_EQ(parse_localizer("mh_amcl").name, "mh_amcl");
  EXPECT_FALSE(parse_localizer("amcl").relocalize_at_kidnap);
  EXPECT_TRUE(parse_localizer("amcl:amcl-global").relocalize_at_kidnap);
  EXPECT_EQ(parse_localizer("amcl:amcl-recovery").name, "amcl-recovery");
  EXPECT_EQ(parse_localizer("mh_amcl:paper").name, "mh_amcl-paper");
  EXPECT_EQ(parse_localizer("mh_amcl:published").name, "mh_amcl-published");
  EXPECT_EQ(parse_localizer("mh_amcl:3d").name, "mh_amcl-3d");
  EXPECT_THROW(parse_localizer("mh_amcl:papre"), std::invalid_argument);
  EXPECT_THROW(parse_localizer("amcl:nonsense"), std::invalid_argument);
  EXPECT_THROW(parse_localizer("gmapping"), std::invalid_argument);
}

TEST(ParseLocalizers, TakesNamesAndFiles) {
  const TemporaryFolder folder;
  const std::string file =
      folder.put("tuned.yaml", "localizers: [amcl, mh_amcl: {stays: 0.5, name: tuned}]\n");
  const auto specs = parse_localizers({"mh_amcl", file});
  ASSERT_EQ(specs.size(), 3U);
  EXPECT_EQ(specs[0].name, "mh_amcl");
  EXPECT_EQ(specs[1].name, "amcl");
  EXPECT_EQ(specs[2].name, "tuned");
  EXPECT_EQ(std::get<localization::MhAmclConfig>(specs[2].config).lost_and_found.stays, 0.5);
}

TEST(ParseLocalizers, RefusesOneNameTwiceAndKeysThatAreNotALocalizers) {
  const TemporaryFolder folder;
  const auto error = [&](const std::vector<std::string>& texts) {
    return error_of([&] { (void)parse_localizers(texts); });
  };
  EXPECT_TRUE(contains(error({"amcl", "amcl"}), "two localizers are called 'amcl'"));
  const std::string whole = folder.put("whole.yaml", "localizers: [amcl]\nduration_s: 3\n");
  EXPECT_TRUE(contains(error({whole}), "whole.yaml:2: unknown key 'duration_s'"));
  const std::string none = folder.put("empty.yaml", "localizers: []\n");
  EXPECT_TRUE(contains(error({none}), "empty.yaml: lists no localizer"));
  const std::string wrong = folder.put("wrong.yaml", "localizers:\n- mh_amcl: {stayz: 0.5}\n");
  EXPECT_TRUE(contains(error({wrong}), "wrong.yaml:2: "));
  EXPECT_TRUE(contains(error({(folder.path() / "none.yaml").string()}), "none.yaml"));
}

TEST_F(ScenarioFileTest, HasADefaultForEveryKey) {
  const LoadedScenario loaded = load("{}\n");
  ASSERT_EQ(loaded.scenario.localizers.size(), 2U);
  EXPECT_EQ(loaded.scenario.localizers[0].name, "mh_amcl");
  EXPECT_EQ(loaded.scenario.localizers[1].name, "amcl");
  EXPECT_EQ(load(loaded.effective).effective, loaded.effective);
}

TEST_F(ScenarioFileTest, FollowsAPathAlone) {
  EXPECT_EQ(load("drive: {path: a.tum}\n").scenario.drive.path, "a.tum");
  EXPECT_EQ(load("{}\n").scenario.drive.path, "");
  for (const char* other : {"route: loop", "route: none", "by: mh_amcl", "twist_log: b.csv"}) {
    const std::string error = error_of("\ndrive: {path: a.tum, " + std::string(other) + "}\n");
    expect_contains(error, "trial.yaml:2");
    expect_contains(error, "'path' leads the robot; leave out 'by', 'route' and 'twist_log'");
  }
  EXPECT_NO_THROW((void)load("drive: {path: a.tum, by: truth}\n"));
}

TEST_F(ScenarioFileTest, RefusesToKidnapARobotFromItsPath) {
  const std::string kidnap = "events: [{kidnap: {at_s: 3}}]\n";
  const std::string error = error_of("drive: {path: a.tum}\n" + kidnap);
  expect_contains(error, "trial.yaml");
  expect_contains(error, "'drive.path' leads the robot to the end: kidnaps need another drive");
  EXPECT_NO_THROW((void)load(kidnap));
  EXPECT_NO_THROW((void)load(
      "drive: {path: a.tum}\nevents: [{fault: {kind: lidar-late, at_s: 3, for_s: 2}}]\n"));
}

TEST_F(ScenarioFileTest, RefusesADriverThatIsNotOfTheRun) {
  expect_contains(error_of("drive: {by: amlc}\n"), "did you mean 'amcl'?");
  EXPECT_NO_THROW((void)load("drive: {by: amcl}\n"));
}

}  // namespace
}  // namespace castaway::testbed
