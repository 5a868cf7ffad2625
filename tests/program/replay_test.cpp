// Replays recorded logs of real robots. Skipped if the data are not available.
#include <cstdlib>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

class Replay : public testing::TestWithParam<const char*> {
 protected:
  /// Folder of a recorded log, or an empty path.
  static fs::path recorded(const std::string& name) {
    const char* root = std::getenv("CASTAWAY_REAL_DATA");
    const fs::path folder =
        (root != nullptr ? fs::path(root) : fs::path(CASTAWAY_SOURCE_DIR) / "../shared/data/real") /
        name;
    return fs::exists(folder / "log.carmen.gz") ? folder : fs::path();
  }
};

TEST_P(Replay, FindsItselfFromAnUnknownStart) {
  const fs::path data = recorded(GetParam());
  if (data.empty()) GTEST_SKIP() << "no recorded log " << GetParam() << " (set CASTAWAY_REAL_DATA)";
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder, "replay '" + (data / "log.carmen.gz").string() + "' --map '" +
                           (data / "map.yaml").string() +
                           "' --start unknown --from-scan 100 --scans 200 --out run --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json mh_amcl = Json::parse(outcome.out).at("localizers").at("mh_amcl");
  EXPECT_EQ(mh_amcl.at("recovery").at("recovered"), 1);
  EXPECT_LT(mh_amcl.at("tracking_error_m").at("mean"), 0.1);  // the accuracy of the reference poses
}

INSTANTIATE_TEST_SUITE_P(RealLogs, Replay, testing::Values("intel", "freiburg-079", "aces"),
                         [](const auto& parameter) {
                           std::string name = parameter.param;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace castaway::test
