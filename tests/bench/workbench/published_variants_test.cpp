#include "tests/bench/workbench/published_variants.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using localization::named_defects;
using localization::PublishedDefects;

int defects_of(const PublishedVariant& variant) {
  int count = 0;
  for (const auto& defect : named_defects()) {
    count += variant.config.defects.*defect.on ? 1 : 0;
  }
  return count;
}

TEST(PublishedVariants, ArePaperEachDefectAloneTheFiguresAndAll) {
  const std::vector<PublishedVariant> variants = published_variants();
  ASSERT_EQ(variants.size(), named_defects().size() + 3);
  EXPECT_EQ(variants.front().name, "paper");
  EXPECT_EQ(defects_of(variants.front()), 0);
  for (std::size_t i = 0; i < named_defects().size(); ++i) {
    EXPECT_EQ(defects_of(variants[i + 1]), 1);
    EXPECT_TRUE(variants[i + 1].config.defects.*named_defects()[i].on);
    EXPECT_EQ(variants[i + 1].name, "+ " + std::string(named_defects()[i].name));
  }
  const PublishedVariant& figures = variants[variants.size() - 2];
  EXPECT_EQ(defects_of(figures), 0);
  EXPECT_EQ(figures.config.paper.reseed.winners, 0.03);
  EXPECT_EQ(variants.back().config.defects, localization::all_defects());
}

TEST(VariantScore, AddsUpRuns) {
  LocalizerMetrics first;
  first.events = 3;
  first.recovered = 1;
  first.wrong_lock_share = 0.5;
  RecoveryWindow recovered;
  recovered.begin = std::chrono::seconds(10);
  recovered.recovered = std::chrono::seconds(14);
  first.windows = {RecoveryWindow{}, recovered};
  LocalizerMetrics second;
  second.events = 2;
  second.tracking_error_m = Statistics{.mean = 0.1};
  VariantScore score;
  score.add(first);
  score.add(second);
  EXPECT_EQ(score.events, 5);
  EXPECT_EQ(score.recovered, 1);
  EXPECT_EQ(score.time_s, std::vector<double>{4.0});
  EXPECT_EQ(score.tracking_m, std::vector<double>{0.1});
  EXPECT_EQ(score.wrong, std::vector<double>{0.5});
}

}  // namespace
}  // namespace castaway::testbed
