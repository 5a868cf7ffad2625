#include "localization/paper/published/published_defects.hpp"

#include <set>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(PublishedDefects, AreOffUnlessAskedFor) {
  const PublishedDefects none;
  for (const NamedDefect& defect : named_defects()) EXPECT_FALSE(none.*defect.on) << defect.name;
}

TEST(PublishedDefects, AreAllNamedOnce) {
  EXPECT_EQ(named_defects().size(), sizeof(PublishedDefects));  // every field is one bool
  std::set<std::string_view> names;
  for (const NamedDefect& defect : named_defects()) {
    names.insert(defect.name);
    EXPECT_TRUE(all_defects().*defect.on) << defect.name;
    PublishedDefects one;
    one.*defect.on = true;
    EXPECT_NE(one, PublishedDefects{});
  }
  EXPECT_EQ(names.size(), named_defects().size());
}

}  // namespace
}  // namespace castaway::localization
