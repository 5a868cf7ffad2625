#include "tools/scenario/sections/operator_events.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

using testing::HasSubstr;

/// What `read` makes of a body.
template <typename Read>
auto read_body(const std::string& body, Read read) {
  YamlDocument document = YamlDocument::parse("event: " + body, "scenario.yaml");
  YamlReader root = document.root();
  auto result = read(root.child("event"));
  document.reject_unknown_keys();
  return result;
}

template <typename Read>
std::string error_of_body(const std::string& body, Read read) {
  try {
    (void)read_body(body, read);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(OperatorEvents, ReadACommand) {
  const sim::DriveCommand command = read_body("{at_s: 3, w: -0.5}", read_drive_command);
  EXPECT_EQ(command.at_s, 3.0);
  EXPECT_EQ(command.twist->v, 0.0);
  EXPECT_EQ(command.twist->w, -0.5);
  EXPECT_FALSE(read_body("{at_s: 4}", read_drive_command).twist);
}

TEST(OperatorEvents, ReadAnInitialPose) {
  const LocalizerOrder order = read_body(
      "{at_s: 3, name: amcl, do: initialize, pose: [1, 2, 3], sigma_m: 0.5}", read_localizer_order);
  EXPECT_EQ(order.at, localization::from_seconds(3.0));
  EXPECT_EQ(order.localizer, "amcl");
  EXPECT_EQ(order.what, LocalizerOrder::What::kInitialize);
  EXPECT_EQ(order.pose->T_map_base, (localization::SE2{1.0, 2.0, 3.0}));
  EXPECT_EQ(order.pose->covariance(0, 0), 0.25);
}

TEST(OperatorEvents, ReadOrdersWithoutAPose) {
  for (const char* what : {"relocalize", "off", "on"}) {
    const auto order =
        read_body(std::string("{at_s: 3, name: amcl, do: ") + what + "}", read_localizer_order);
    EXPECT_EQ(part_name(order.what), what);
    EXPECT_FALSE(order.pose);
  }
}

TEST(OperatorEvents, SayWhatIsWrong) {
  EXPECT_THAT(error_of_body("{v: 1}", read_drive_command), HasSubstr("at_s"));
  EXPECT_THAT(error_of_body("{at_s: 1, v: fast}", read_drive_command), HasSubstr("v"));
  EXPECT_THAT(error_of_body("{at_s: 1, name: amcl, do: initialize}", read_localizer_order),
              HasSubstr("give 'pose'"));
  EXPECT_THAT(error_of_body("{at_s: 1, name: amcl, do: sing}", read_localizer_order),
              HasSubstr("relocalize"));
  EXPECT_THAT(
      error_of_body("{at_s: 1, name: amcl, do: off, pose: [0, 0, 0]}", read_localizer_order),
      HasSubstr("pose"));
}

}  // namespace
}  // namespace castaway::testbed
