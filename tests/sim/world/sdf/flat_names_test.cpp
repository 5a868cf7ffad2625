#include "sim/world/sdf/flat_names.hpp"

#include <string>

#include <gtest/gtest.h>

#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

std::string renamed(const std::string& model) {
  const auto document = parse_xml("w.sdf", model);
  unscope_names(*document->RootElement());
  TiXmlPrinter printer;
  printer.SetStreamPrinting();
  document->Accept(&printer);
  return printer.Str();
}

TEST(FlatNames, BecomePlainWithWhatRefersToThem) {
  EXPECT_EQ(renamed("<model name=\"m\"><frame name=\"in::__model__\" />"
                    "<link name=\"in::body\"><pose relative_to=\"in::__model__\">1</pose></link>"
                    "<joint name=\"in::j\"><parent>world</parent><child>in::body</child></joint>"
                    "</model>"),
            "<model name=\"m\"><frame name=\"in/__model__\" />"
            "<link name=\"in/body\"><pose relative_to=\"in/__model__\">1</pose></link>"
            "<joint name=\"in/j\"><parent>world</parent><child>in/body</child></joint>"
            "</model>");
}

TEST(FlatNames, LeaveAlonePathsToNestedModels) {
  const std::string nested =
      "<model name=\"m\"><link name=\"l\"><pose relative_to=\"in::body\">1</pose></link>"
      "<model name=\"in\"><link name=\"body\" /></model></model>";
  EXPECT_EQ(renamed(nested), nested);
}

TEST(FlatNames, ReachIntoModelsThatAreRenamed) {
  EXPECT_EQ(renamed("<model name=\"m\"><model name=\"a::b\"><link name=\"c\" /></model>"
                    "<frame name=\"f\" attached_to=\"a::b::c\" /></model>"),
            "<model name=\"m\"><model name=\"a/b\"><link name=\"c\" /></model>"
            "<frame name=\"f\" attached_to=\"a/b::c\" /></model>");
}

}  // namespace
}  // namespace castaway::sim
