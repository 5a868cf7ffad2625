#include "tools/base/formats/junit.hpp"

#include <set>
#include <string_view>

#include <gtest/gtest.h>
#include <tinyxml.h>

namespace castaway::testbed {
namespace {

using Element = TiXmlElement;

std::vector<JunitCase> three_cases() {
  return {{"castaway.a", "one", 1.5, {}, {}},
          {"castaway.a", "two < 5 & \"more\"", 2.0, "is 6 > 5\nsee \x01 there", {}},
          {"castaway.a", "runs", 0.0, {}, "the run failed"}};
}

void parse(const std::string& xml, TiXmlDocument& document) {
  document.Parse(xml.c_str(), nullptr, TIXML_ENCODING_UTF8);
  ASSERT_FALSE(document.Error()) << document.ErrorDesc();
}

int count(const Element& element, const char* attribute) {
  int value = -1;
  element.QueryIntAttribute(attribute, &value);
  return value;
}

void expect_attributes(const Element& element, const std::set<std::string_view>& allowed) {
  for (const auto* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
    EXPECT_TRUE(allowed.contains(a->Name())) << element.Value() << " " << a->Name();
  }
}

/// Checks a case against the readers' common schema (Jenkins' junit-10.xsd).
void expect_case(const Element& test) {
  EXPECT_STREQ(test.Value(), "testcase");
  expect_attributes(test, {"name", "classname", "time"});
  EXPECT_NE(test.Attribute("name"), nullptr);
  EXPECT_NE(test.Attribute("classname"), nullptr);
  for (const auto* e = test.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    EXPECT_TRUE(std::set<std::string_view>({"failure", "error"}).contains(e->Value()))
        << e->Value();
    expect_attributes(*e, {"message", "type"});
  }
}

TEST(Junit, KeepsToTheSchemaThatItsReadersShare) {
  TiXmlDocument document;
  parse(junit_xml("a \"suite\"", three_cases()), document);
  const Element& root = *document.RootElement();
  EXPECT_STREQ(root.Value(), "testsuites");
  expect_attributes(root, {"name", "tests", "failures", "errors", "time"});
  const Element& suite = *root.FirstChildElement();
  EXPECT_STREQ(suite.Value(), "testsuite");
  expect_attributes(suite, {"name", "tests", "failures", "errors", "time", "skipped"});
  EXPECT_STREQ(suite.Attribute("name"), "a \"suite\"");
  EXPECT_EQ(count(suite, "tests"), 3);
  EXPECT_EQ(count(suite, "failures"), 1);
  EXPECT_EQ(count(suite, "errors"), 1);
  EXPECT_STREQ(suite.Attribute("time"), "3.500");
  int cases = 0;
  for (const auto* e = suite.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    expect_case(*e);
    ++cases;
  }
  EXPECT_EQ(cases, 3);
  EXPECT_EQ(suite.NextSiblingElement(), nullptr);
}

TEST(Junit, EscapesAndLeavesOutWhatXmlCannotSay) {
  TiXmlDocument document;
  parse(junit_xml("s", three_cases()), document);
  const Element& second =
      *document.RootElement()->FirstChildElement()->FirstChildElement()->NextSiblingElement();
  EXPECT_STREQ(second.Attribute("name"), "two < 5 & \"more\"");
  EXPECT_STREQ(second.FirstChildElement("failure")->Attribute("message"), "is 6 > 5 see  there");
}

TEST(Junit, IsUtf8WhateverTheNamesAre) {
  EXPECT_TRUE(contains(junit_xml("caf\xe9", {}), "caf\xef\xbf\xbd\""));
}

TEST(Junit, OfNoCasesIsAnEmptySuite) {
  TiXmlDocument document;
  parse(junit_xml("s", {}), document);
  EXPECT_EQ(count(*document.RootElement()->FirstChildElement(), "tests"), 0);
}

}  // namespace
}  // namespace castaway::testbed
