#include "tools/base/output/file_name.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(FileName, TakesNames) {
  for (const char* name : {"lab-kidnap", "a b", "x.y", "Büro", "mh_amcl:paper", "1"}) {
    EXPECT_EQ(file_name_error(name), "") << name;
    EXPECT_EQ(file_name_of(name), name);
  }
}

TEST(FileName, RefusesPathsAndOddNames) {
  for (const std::string& name :
       {std::string(), std::string("../up"), std::string("/etc"), std::string("a/b"),
        std::string("a\\b"), std::string("."), std::string(".."), std::string(".hidden"),
        std::string("-rf"), std::string(" a"), std::string("a "), std::string("a\nb"),
        std::string("a\0b", 3), std::string("\x7f"), std::string("caf\xe9"),
        std::string(101, 'a')}) {
    EXPECT_NE(file_name_error(name), "") << name;
    EXPECT_EQ(file_name_error(file_name_of(name)), "") << name;
  }
}

TEST(FileName, SaysThatANameIsNoPath) {
  EXPECT_EQ(file_name_error("a/b"), "must not hold '/'; it names files, it is not a path");
  EXPECT_EQ(file_name_of("a/b"), "a_b");
  EXPECT_EQ(file_name_of("../../evil"), "_._.._evil");
}

}  // namespace
}  // namespace castaway::testbed
