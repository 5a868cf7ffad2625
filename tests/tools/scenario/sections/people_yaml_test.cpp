#include "tools/scenario/sections/people_yaml.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

PeopleSpec people_of(const std::string& text) {
  YamlDocument document = YamlDocument::parse(text, "scenario.yaml");
  YamlReader root = document.root();
  const PeopleSpec people = read_people(root);
  document.reject_unknown_keys();
  return people;
}

std::string people_error(const std::string& text) {
  try {
    (void)people_of(text);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(PeopleSpec, WithoutTheKeyIsNobodyAndFillsNothingIn) {
  YamlDocument document = YamlDocument::parse("{}", "scenario.yaml");
  YamlReader root = document.root();
  EXPECT_EQ(read_people(root).config.count(), 0);
  EXPECT_EQ(document.effective().find("people"), std::string::npos);
}

TEST(PeopleSpec, ReadsAllKeys) {
  const PeopleSpec people = people_of(
      "people: {count: 8, behaviour: scared, groups: 0.3, standing: 2, talking: [3, 2], at: [[1, "
      "2], "
      "[3, 4, 0.5]], robot_yields: false, log_every_s: 0.1}");
  EXPECT_EQ(people.config.walking, 8);
  EXPECT_EQ(people.config.behaviour, sim::Behaviour::kScared);
  EXPECT_EQ(people.config.in_groups, 0.3);
  EXPECT_EQ(people.config.standing, 2);
  EXPECT_EQ(people.config.talking, (std::vector<int>{3, 2}));
  EXPECT_EQ(people.config.placed[1], (sim::Pose2{3.0, 4.0, 0.5}));
  EXPECT_FALSE(people.config.robot_yields);
  EXPECT_EQ(people.log_every_s, 0.1);
  EXPECT_EQ(people.config.count(), 17);
}

TEST(PeopleSpec, MixedIsNoBehaviourInParticular) {
  EXPECT_FALSE(people_of("people: {count: 3, behaviour: mixed}").config.behaviour);
}

TEST(PeopleSpec, ACrowdBringsItsPeople) {
  const PeopleSpec people = people_of("people: {crowd: {blocked: 0.4}}");
  EXPECT_EQ(people.config.blocked_share, 0.4);
  EXPECT_EQ(people.config.walking, 24);
  EXPECT_EQ(people_of("people: {count: 12, crowd: {blocked: 0.4}}").config.walking, 12);
}

TEST(PeopleSpec, RefusesWhatCannotBe) {
  EXPECT_NE(people_error("people: {cuont: 3}").find("count"), std::string::npos);
  EXPECT_NE(people_error("people: {behaviour: sacred}").find("scared"), std::string::npos);
  EXPECT_NE(people_error("people: {crowd: {blocked: 0.7}}").find("from 0 to 0.6"),
            std::string::npos);
  EXPECT_NE(people_error("people: {groups: 1.5}").find("from 0 to 1"), std::string::npos);
  EXPECT_NE(people_error("people: {talking: [1]}"), "");
  EXPECT_NE(people_error("people: {count: 201}").find("200"), std::string::npos);
  EXPECT_NE(people_error("people: {at: [[1]]}").find("[x, y]"), std::string::npos);
  EXPECT_NE(people_error("people: {count: -1}"), "");
  EXPECT_NE(people_error("people: {log_every_s: -1}"), "");
}

}  // namespace
}  // namespace castaway::testbed
