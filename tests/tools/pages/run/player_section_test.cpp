#include "tools/pages/run/player_section.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {
namespace {

RunFolder run_with(const std::string& recording) {
  RunFolder run;
  run.recording = recording;
  run.events.push_back({1.5, KidnapEvent{"</script><b>"}, "", std::nullopt,
                        localization::SE2{1.0, 2.0, 0.0}, localization::SE2{3.0, 4.0, 0.0}});
  return run;
}

TEST(PlayerSection, SaysWhyThereIsNoPlayer) {
  const RunFolder run = run_with("");
  EXPECT_FALSE(has_player(run));
  EXPECT_TRUE(contains(player_section(run), "This page has no player"));
  EXPECT_TRUE(
      contains(player_section(run), player_bundle() ? "no recording.gz" : "without Node.js"));
  EXPECT_EQ(player_data(run), "");
}

TEST(PlayerSection, CarriesTheRecordingAndTheEvents) {
  if (!player_bundle()) GTEST_SKIP() << "built without Node.js";
  const RunFolder run = run_with("abc");
  EXPECT_TRUE(has_player(run));
  EXPECT_TRUE(contains(player_section(run), "id=\"castaway-player\""));
  const std::string scripts = player_data(run);
  EXPECT_TRUE(contains(scripts, "id=\"castaway-recording\">YWJj</script>"));
  EXPECT_TRUE(contains(scripts, "\"right_m\":0.5"));
  EXPECT_TRUE(contains(scripts, "\"open_s\":1.5"));
  EXPECT_TRUE(contains(scripts, "\"from\":[1.0,2.0],\"to\":[3.0,4.0]"));
}

TEST(PlayerSection, LetsNoTextEndAScript) {
  if (!player_bundle()) GTEST_SKIP() << "built without Node.js";
  const std::string scripts = player_data(run_with("abc"));
  EXPECT_TRUE(contains(scripts, "\\u003c/script>\\u003cb>"));
  std::size_t ends = 0;
  for (std::size_t at = scripts.find("</script"); at != std::string::npos;
       at = scripts.find("</script", at + 1)) {
    ++ends;
  }
  EXPECT_EQ(ends, 2U);
}

TEST(WebBundle, HoldsNoEndOfItsOwnTag) {
  if (!player_bundle()) GTEST_SKIP() << "built without Node.js";
  for (const WebBundle& bundle : {*player_bundle(), *plots_bundle()}) {
    EXPECT_EQ(bundle.script.find("</script"), std::string_view::npos);
    EXPECT_EQ(bundle.style.find("</style"), std::string_view::npos);
    EXPECT_TRUE(contains(std::string(bundle.script), "Permission is hereby granted"));
  }
}

}  // namespace
}  // namespace castaway::testbed
