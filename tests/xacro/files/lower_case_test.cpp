#include "xacro/files/lower_case.hpp"

#include <gtest/gtest.h>

namespace castaway {
namespace {

TEST(LowerCase, ChangesLettersOnly) { EXPECT_EQ(to_lower("A_z9 \xc3\x84"), "a_z9 \xc3\x84"); }

TEST(LowerCase, FindsWordsInNames) {
  EXPECT_TRUE(holds_word("Rear_Caster_Link", {"castor", "caster"}));
  EXPECT_FALSE(holds_word("rear_link", {"castor", "caster"}));
  EXPECT_FALSE(holds_word("rear_link", {}));
}

}  // namespace
}  // namespace castaway
