#include "tools/outputs/records/hit_legend.hpp"

#include <set>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

HitLegend legend() {
  HitLegend of;
  of.entries[0] = {BeamClass::kStatic, "wall"};
  of.entries[1] = {BeamClass::kGlass, "pane"};
  of.entries[-2] = {BeamClass::kFloor, "floor"};
  of.first_person = 100;
  return of;
}

TEST(HitLegend, TellsClassesAndIds) {
  EXPECT_EQ(legend().class_of(0), BeamClass::kStatic);
  EXPECT_EQ(legend().class_of(1), BeamClass::kGlass);
  EXPECT_EQ(legend().class_of(-2), BeamClass::kFloor);
  EXPECT_EQ(legend().class_of(-1), BeamClass::kNone);
  EXPECT_EQ(legend().class_of(103), BeamClass::kPerson);
  EXPECT_EQ(legend().id_of(1), 1);
  EXPECT_EQ(legend().id_of(-2), -1);
  EXPECT_EQ(legend().id_of(-1), -1);
  EXPECT_EQ(legend().id_of(103), 3);
  EXPECT_EQ(legend().id_of(7), -1);
}

TEST(HitLegend, EveryClassHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int i = 0; i < kBeamClasses; ++i) names.insert(class_name(static_cast<BeamClass>(i)));
  EXPECT_EQ(names.size(), 10U);
  EXPECT_STREQ(class_name(BeamClass::kPerson), "person");
  EXPECT_STREQ(class_name(BeamClass::kCover), "cover");
}

TEST(HitLegend, WhatIsOnTheMapHidesNothingOfIt) {
  for (const BeamClass of :
       {BeamClass::kNone, BeamClass::kStatic, BeamClass::kGlass, BeamClass::kFloor}) {
    EXPECT_FALSE(hides_map(of)) << class_name(of);
  }
  for (const BeamClass of : {BeamClass::kUnmapped, BeamClass::kMoved, BeamClass::kDoor,
                             BeamClass::kPerson, BeamClass::kDust, BeamClass::kCover}) {
    EXPECT_TRUE(hides_map(of)) << class_name(of);
  }
}

}  // namespace
}  // namespace castaway::testbed
