#include "tools/batch/compare/paper_experiments.hpp"

#include <filesystem>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(PaperExperiments, HaveThePapersRuns) {
  EXPECT_EQ(runs_of(paper_experiment(1, 1, false)).size(), 5U);
  EXPECT_EQ(runs_of(paper_experiment(2, 1, false)).size(), 30U);
  EXPECT_EQ(runs_of(paper_experiment(2, 10, false)).size(), 300U);
  EXPECT_EQ(runs_of(paper_experiment(3, 1, false)).size(), 1U);
}

TEST(PaperExperiments, NeverRepeatARun) {
  for (const int number : {1, 2, 3}) {
    std::set<std::string> folders;
    std::set<std::uint64_t> seeds;
    const auto runs = runs_of(paper_experiment(number, 3, false));
    for (const ExperimentRun& run : runs) {
      EXPECT_TRUE(folders.insert(run.folder).second) << run.folder;
      seeds.insert(run.seed);
      EXPECT_TRUE(
          std::filesystem::exists(std::filesystem::path(CASTAWAY_SOURCE_DIR) / run.scenario))
          << run.scenario;
    }
    if (number == 2) {
      EXPECT_EQ(seeds.size(), runs.size());  // all starts differ
    }
  }
}

TEST(PaperExperiments, AreShortWhenQuick) {
  for (const int number : {1, 2, 3})
    EXPECT_LE(runs_of(paper_experiment(number, 5, true)).size(), 4U);
}

TEST(PaperExperiments, RefuseOtherNumbers) {
  EXPECT_THROW(paper_experiment(4, 1, false), std::invalid_argument);
  EXPECT_THROW(paper_experiment(1, 0, false), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::testbed
