// Options of castaway::MhAmcl and castaway::Amcl, and what they make of them.
#include <regex>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "castaway/amcl.hpp"
#include "castaway/mh_amcl.hpp"
#include "localization/amcl/amcl.hpp"
#include "localization/mh_amcl/mh_amcl.hpp"
#include "localization/paper/paper_mh_amcl.hpp"
#include "tests/support/grid_drive.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway {
namespace {

using testbed::error_of;

/// The default of a setting in docs/settings.md.
std::string documented(const std::string& path) {
  for (const testbed::SettingText& setting : testbed::scenario_settings()) {
    if (setting.path == path) return setting.value;
  }
  return "no setting " + path;
}

/// The field has the default of the setting `key`, and sets it: -1 is out of range, and the error
/// names the key.
template <typename Carried, typename Options, typename T>
void expect_option(const std::string& kind, const std::string& key, T Options::*field) {
  Options options;
  EXPECT_EQ(fmt::format("{}", options.*field), documented("localizers[]." + kind + "." + key));
  options.*field = T{-1};
  const std::string error = error_of([&] { Carried(test::office(), options); });
  const std::string name = key.substr(key.find('.') + 1);
  EXPECT_TRUE(std::regex_search(error, std::regex("\\b" + name + "\\b"))) << error;
}

TEST(MhAmclOptions, AreSettings) {
  const auto expect = [](const std::string& key, auto MhAmclOptions::*field) {
    expect_option<MhAmcl>("mh_amcl", key, field);
  };
  expect("max_range", &MhAmclOptions::max_range);
  expect("max_beams", &MhAmclOptions::max_beams);
  expect("max_particles", &MhAmclOptions::max_particles);
  expect("correct_rate_hz", &MhAmclOptions::correct_rate_hz);
  expect("trans_per_m", &MhAmclOptions::trans_per_m);
  expect("trans_per_rad", &MhAmclOptions::trans_per_rad);
  expect("rot_per_m", &MhAmclOptions::rot_per_m);
  expect("rot_per_rad", &MhAmclOptions::rot_per_rad);
  expect("found", &MhAmclOptions::found);
  expect("stays", &MhAmclOptions::stays);
  expect("posterior.false_alarms_per_h", &MhAmclOptions::false_alarms_per_h);
  expect("budget_ms", &MhAmclOptions::budget_ms);
  expect("budget_most_ms", &MhAmclOptions::budget_most_ms);
  EXPECT_EQ(MhAmclOptions().mode, documented("localizers[].mh_amcl.mode"));
}

TEST(AmclOptions, AreSettings) {
  const auto expect = [](const std::string& key, auto AmclOptions::*field) {
    expect_option<Amcl>("amcl", key, field);
  };
  expect("laser_max_range", &AmclOptions::laser_max_range);
  expect("max_beams", &AmclOptions::max_beams);
  expect("min_particles", &AmclOptions::min_particles);
  expect("max_particles", &AmclOptions::max_particles);
  expect("alpha1", &AmclOptions::alpha1);
  expect("alpha2", &AmclOptions::alpha2);
  expect("alpha3", &AmclOptions::alpha3);
  expect("alpha4", &AmclOptions::alpha4);
  expect("recovery_alpha_slow", &AmclOptions::recovery_alpha_slow);
  expect("recovery_alpha_fast", &AmclOptions::recovery_alpha_fast);
  expect("update_min_d", &AmclOptions::update_min_d);
  expect("update_min_a", &AmclOptions::update_min_a);
  EXPECT_EQ(AmclOptions().preset, documented("localizers[].amcl.preset"));
}

std::string mh_amcl_error(const MhAmclOptions& options) {
  return error_of([&] { MhAmcl(test::office(), options); });
}

TEST(MhAmclOptions, ThatAreWrongAreNamed) {
  EXPECT_EQ(mh_amcl_error(MhAmclOptions{}.set("max_particels", "60")),
            "MhAmcl: max_particels=60: unknown key 'max_particels'; did you mean 'max_particles'?");
  EXPECT_EQ(mh_amcl_error(MhAmclOptions{}.set("posterior.kidnap", "soon")),
            "MhAmcl: posterior.kidnap=soon: posterior.kidnap: expected a number, found 'soon'");
  MhAmclOptions options;
  options.max_range = -1.0;
  EXPECT_EQ(mh_amcl_error(options),
            "MhAmcl: max_range=-1: max_range: -1 is out of range; give from 0.01 to 10000 m");
  EXPECT_EQ(mh_amcl_error(MhAmclOptions{.mode = "improve"}),
            "MhAmcl: mode=improve: mode: 'improve' is not allowed here; did you mean 'improved'?");
  EXPECT_TRUE(testbed::contains(mh_amcl_error(MhAmclOptions{.mode = "3d"}), "mode=3d: works on a"));
  EXPECT_EQ(error_of([] { Amcl(test::office(), AmclOptions{}.set("alpha5", "0.2")); }),
            "Amcl: alpha5=0.2: unknown key 'alpha5'; did you mean 'alpha1'?");
}

TEST(MhAmclOptions, ANameOverridesAnOption) {
  MhAmclOptions options;
  options.max_particles = 100;
  options.set("min_particles", "60").set("max_particles", "60");
  MhAmcl localizer(test::office(), options);
  localizer.initialize(test::known_start(test::kStart));
  ASSERT_EQ(localizer.diagnostics().populations.size(), 1U);
  EXPECT_EQ(localizer.diagnostics().populations[0].particles.size(), 60U);
}

/// Poses and probabilities of a drive from a known start, in one line.
std::string drive(Localizer& localizer) {
  test::GridDrive robot(test::office(), test::kStart);
  localizer.initialize(test::known_start(test::kStart));
  std::string text;
  for (int step = 0; step < 20; ++step) {
    robot.step(localizer, test::kForward);
    const std::optional<Estimate> estimate = localizer.estimate();
    if (!estimate) continue;
    const Pose2& pose = estimate->T_map_base;
    text += fmt::format("{} {} {} {};", pose.x, pose.y, pose.yaw, estimate->probability);
  }
  return text;
}

TEST(MhAmcl, IsToTheBitTheLocalizerOfRuns) {
  MhAmcl with_defaults(test::office(), MhAmclOptions{.seed = 7});
  localization::MhAmcl of_runs({}, test::office(), 7);
  const std::string drove = drive(with_defaults);
  EXPECT_FALSE(drove.empty());
  EXPECT_EQ(drove, drive(of_runs));
  MhAmcl with_an_option(test::office(), MhAmclOptions{.seed = 7, .max_beams = 30});
  EXPECT_NE(drove, drive(with_an_option));
}

TEST(MhAmcl, HasTheDefaultsOfItsMode) {
  MhAmcl paper(test::office(), MhAmclOptions{.seed = 7, .mode = "paper"});
  localization::PaperMhAmcl of_runs({}, test::office(), 7);
  EXPECT_EQ(drive(paper), drive(of_runs));
}

TEST(Amcl, HasTheDefaultsOfItsPreset) {
  for (const std::string preset : {"amcl", "amcl-recovery"}) {
    localization::AmclConfig config;
    if (preset == "amcl-recovery") config.recovery = {0.001, 0.1};
    localization::Amcl of_runs(config, test::office(), 7);
    Amcl amcl(test::office(), AmclOptions{.seed = 7, .preset = preset});
    EXPECT_EQ(drive(amcl), drive(of_runs)) << preset;
  }
}

TEST(MhAmcl, CanBeMoved) {
  MhAmcl first(test::office());
  MhAmcl second = std::move(first);
  EXPECT_EQ(drive(second), [] {
    MhAmcl third(test::office());
    return drive(third);
  }());
}

}  // namespace
}  // namespace castaway
