#include "xacro/files/xml_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/robot_files.hpp"

namespace castaway {
namespace {

using testing::HasSubstr;

std::string xml_error(const std::string& text) {
  return error_text([&] { (void)parse_xml("a.xml", text); });
}

TEST(XmlText, IsParsed) {
  const auto document = parse_xml("a.xml", "<?xml version='1.0'?><!-- <!DOCTYPE --><a b='>'/>");
  EXPECT_EQ(document->RootElement()->ValueStr(), "a");
  EXPECT_THAT(xml_text_of(*document), HasSubstr("<a b=\"&gt;\""));
}

TEST(XmlText, OfAnAbsentAttributeIsEmpty) {
  const auto document = parse_xml("a.xml", "<a b=\"c\"/>");
  EXPECT_EQ(attribute(*document->RootElement(), "b"), "c");
  EXPECT_EQ(attribute(*document->RootElement(), "d"), "");
}

TEST(XmlText, WithEntitiesIsRefused) {
  EXPECT_THAT(xml_error("\n<!DOCTYPE a [<!ENTITY b \"c\">]><a>&b;</a>"),
              HasSubstr("a.xml:2: document types and entities"));
}

TEST(XmlText, ThatWouldOverflowTheParserIsRefused) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_THAT(xml_error(deep), HasSubstr("nested deeper than 200"));
  std::string wide = "<a>";
  for (int i = 0; i < 200001; ++i) wide += "<b/>";
  EXPECT_THAT(xml_error(wide + "</a>"), HasSubstr("more than 200000 elements"));
}

TEST(XmlText, ThatIsTornOrNoTextIsRefused) {
  EXPECT_THAT(xml_error("<a>\n<b></a>"), HasSubstr("not well-formed"));
  EXPECT_THAT(xml_error("<a"), HasSubstr("a.xml"));
  EXPECT_THAT(xml_error("<!-- never closed"), HasSubstr("a.xml"));
  EXPECT_THAT(xml_error(""), HasSubstr("a.xml"));
  EXPECT_THAT(xml_error(std::string("<a>\0</a>", 8)), HasSubstr("zero byte"));
  EXPECT_THAT(error_text([] { (void)read_xml_text("/nowhere.urdf"); }), HasSubstr("cannot read"));
  EXPECT_THAT(error_text([] { (void)read_xml_text("/tmp"); }), HasSubstr("cannot read"));
}

}  // namespace
}  // namespace castaway
