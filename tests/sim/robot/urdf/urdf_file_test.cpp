// Repairs before urdfdom reads a robot, and rejected files.
#include "sim/robot/urdf/urdf_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/robot_files.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::sim {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class UrdfFileTest : public RobotFiles {
 protected:
  [[nodiscard]] UrdfFile read(const std::string& text) const {
    const std::string path = write("my.urdf", text);
    return read_urdf(path, PackageFinder(path, {}), {});
  }
};

const std::string kLink =
    "<link name=\"a\"><visual><geometry><sphere radius=\"1\"/></geometry>"
    "<material name=\"red\"/></visual></link>";

TEST_F(UrdfFileTest, GivesTheRobotItsFilesName) {
  const UrdfFile file = read("<robot><link name=\"a\"/></robot>");
  EXPECT_EQ(file.model->getName(), "my");
  EXPECT_THAT(file.warnings, Contains(HasSubstr("no name")));
}

TEST_F(UrdfFileTest, DropsMaterialsThatNobodyDefines) {
  EXPECT_THAT(read("<robot name=\"r\">" + kLink + "</robot>").warnings,
              Contains(HasSubstr("no material 'red'")));
}

TEST_F(UrdfFileTest, KeepsOneOfTwoEqualMaterials) {
  const std::string red = "<material name=\"red\"><color rgba=\"1 0 0 1\"/></material>";
  const UrdfFile file = read("<robot name=\"r\">" + red + red + kLink + "</robot>");
  EXPECT_THAT(file.warnings, IsEmpty());
  EXPECT_FLOAT_EQ(file.model->getLink("a")->visual->material->color.r, 1.0F);
}

TEST_F(UrdfFileTest, AddsMissingLimits) {
  const UrdfFile file = read(
      "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" "
      "type=\"revolute\"><parent link=\"a\"/><child link=\"b\"/></joint></robot>");
  EXPECT_THAT(file.warnings, Contains(HasSubstr("joint j: incomplete <limit>")));
  EXPECT_EQ(file.model->getJoint("j")->limits->effort, 0.0);
}

std::string tree_error(const std::string& joints) {
  const auto document = parse_xml("r.urdf", "<robot>" + joints + "</robot>");
  return error_text([&] { require_tree(*document->RootElement(), "r.urdf"); });
}

std::string joint(const std::string& name, const std::string& parent, const std::string& child) {
  return "<joint name=\"" + name + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/></joint>";
}

TEST(UrdfTree, IsATree) {
  EXPECT_EQ(tree_error(joint("j", "a", "b") + joint("k", "a", "c") + joint("l", "c", "d")), "");
  EXPECT_THAT(tree_error(joint("j", "a", "b") + joint("k", "c", "b")), HasSubstr("b hangs on two"));
  EXPECT_THAT(tree_error(joint("j", "a", "b") + joint("k", "b", "c") + joint("l", "c", "b2") +
                         joint("m", "c", "a")),
              HasSubstr("form a loop"));
  EXPECT_THAT(tree_error(joint("j", "a", "a")), HasSubstr("form a loop"));
}

}  // namespace
}  // namespace castaway::sim
