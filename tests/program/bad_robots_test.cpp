// A catalogue of broken robots: each gives one clear line and exit code 2.
#include <algorithm>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

/// A broken robot, and the required parts of the error line.
struct BadRobot {
  const char* name;
  std::string text;  ///< Content of r.urdf.xacro.
  std::vector<std::string> parts;
  std::string arguments = {};
};

std::ostream& operator<<(std::ostream& out, const BadRobot& robot) { return out << robot.name; }

const std::string kBody = R"(<link name="base_link">
<inertial><mass value="1"/><inertia ixx=".01" iyy=".01" izz=".01" ixy="0" ixz="0" iyz="0"/></inertial>
<collision><origin xyz="0 0 0.1"/><geometry><box size="0.2 0.2 0.1"/></geometry></collision></link>
)";

std::string wheel(const std::string& name, const std::string& y,
                  const std::string& shape = "<cylinder radius=\"0.05\" length=\"0.02\"/>") {
  return "<link name=\"" + name + "\"><collision><origin rpy=\"1.5708 0 0\"/><geometry>" + shape +
         "</geometry></collision></link>\n<joint name=\"" + name +
         "_joint\" type=\"continuous\"><parent link=\"base_link\"/><child link=\"" + name +
         "\"/><origin xyz=\"0 " + y + " 0.05\"/><axis xyz=\"0 1 0\"/></joint>\n";
}

std::string robot(const std::string& inside) {
  return "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n" + inside +
         "</robot>\n";
}

/// A valid robot with additional content.
std::string with(const std::string& inside) {
  return robot(inside + kBody + wheel("left", "0.12") + wheel("right", "-0.12"));
}

std::string body_with(const std::string& element) {
  std::string body = kBody;
  return robot(body.replace(body.find("</link>"), 0, element) + wheel("left", "0.12") +
               wheel("right", "-0.12"));
}

std::string mesh(const std::string& uri) {
  return body_with("<visual><geometry><mesh filename=\"" + uri + "\"/></geometry></visual>");
}

std::string deep() {
  std::string text;
  for (int i = 0; i < 50000; ++i) text += "<a>";
  return text;
}

std::string doubling() {
  std::string text = "<xacro:property name=\"p0\" value=\"lol\"/>\n";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "${p" + std::to_string(i - 1) + "}";
    text +=
        "<xacro:property name=\"p" + std::to_string(i) + "\" value=\"" + before + before + "\"/>";
  }
  return text + "<x v=\"${p29}\"/>";
}

const std::string kLaughs =
    "<?xml version=\"1.0\"?>\n<!DOCTYPE lolz [<!ENTITY a \"lol\"><!ENTITY b \"&a;&a;&a;&a;\">"
    "<!ENTITY c \"&b;&b;&b;&b;\">]>\n<robot name=\"&c;\"/>";

std::vector<BadRobot> xml_cases() {
  return {{"Empty", "", {"r.urdf.xacro"}},
          {"NoXml", "wheels: 4\n", {"r.urdf.xacro"}},
          {"Torn", "<robot name=\"r\"><link", {"r.urdf.xacro"}},
          {"WrongTags", "<robot name=\"r\">\n<link name=\"a\">\n</robot>", {"well-formed"}},
          {"OtherRoot", "<sdf version=\"1.6\"/>", {"<robot>", "<sdf>"}},
          {"BillionLaughs", kLaughs, {":2:", "entities"}},
          {"ExternalEntity",
           "<!DOCTYPE r [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><robot name=\"&x;\"/>",
           {"entities"}},
          {"TooDeep", deep(), {"deeper than 200"}},
          {"ZeroBytes", std::string("<robot\0name=\"r\"/>", 17), {"zero byte"}}};
}

std::string fixed(const std::string& name, const std::string& parent, const std::string& child) {
  return "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/></joint>";
}

std::vector<BadRobot> urdf_cases() {
  return {{"NoLinks", robot(""), {"r.urdf.xacro", "not a valid URDF"}},
          {"LinkWithoutName", robot("<link/>"), {"not a valid URDF"}},
          {"SameLinkTwice", robot(kBody + kBody), {"base_link", "not unique"}},
          {"UnknownParent",
           robot(kBody + "<joint name=\"j\" type=\"fixed\"><parent link=\"ghost\"/>"
                         "<child link=\"base_link\"/></joint>"),
           {"ghost"}},
          {"TwoRoots", robot(kBody + "<link name=\"other\"/>"), {"base_link", "other"}},
          {"Loop", robot(fixed("j", "a", "b") + fixed("k", "b", "a")), {"joint", "loop"}},
          {"LoopBeside", with(fixed("j", "a", "b") + fixed("k", "b", "a")), {"form a loop"}},
          {"TwoParents",
           with("<link name=\"a\"/>" + fixed("j", "base_link", "a") + fixed("k", "left", "a")),
           {"link a hangs on two joints", "j and k"}},
          {"UnknownJointType",
           robot(kBody + "<link name=\"b\"/><joint name=\"j\" type=\"magic\"><parent "
                         "link=\"base_link\"/><child link=\"b\"/></joint>"),
           {"magic"}},
          {"NumberThatIsNone",
           body_with("<visual><geometry><box size=\"a b c\"/></geometry></visual>"),
           {"not a valid URDF"}},
          {"NoWheels", robot(kBody), {"no drive wheels", "continuous"}},
          {"OneWheel", robot(kBody + wheel("lone", "0.1")), {"lone_joint", "left and right"}},
          {"WheelWithoutShape",
           robot(kBody + wheel("left", "0.1", "<box size=\"0 0 0\"/>") +
                 wheel("right", "-0.1", "<box size=\"0 0 0\"/>")),
           {"left", "without a shape"}},
          {"NegativeSize",
           robot(kBody + wheel("left", "0.1", "<cylinder radius=\"-1\" length=\"0.1\"/>") +
                 wheel("right", "-0.1")),
           {"left", "sizes above 0"}},
          {"SizeThatIsNoNumber",
           body_with("<collision><geometry><box size=\"nan 1 1\"/></geometry></collision>"),
           {"base_link", "nan"}},
          {"JointAtInfinity",
           robot(kBody + wheel("left", "inf") + wheel("right", "-0.12")),
           {"left_joint", "inf"}},
          {"NothingButWheels",
           robot("<link name=\"base_link\"/>" + wheel("left", "0.12") + wheel("right", "-0.12")),
           {"there are only wheels"}},
          {"MeshOutside", mesh("../../../../../../etc/passwd"), {"base_link", "lies outside"}},
          {"MeshAnywhere", mesh("file:///etc/passwd"), {"base_link", "--search-path"}},
          {"MeshOutOfItsPackage", mesh("package://r/../../etc/passwd"), {"lies outside"}},
          {"MeshFromTheNet", mesh("https://example.org/a.stl"), {"https", "package://"}}};
}

std::vector<BadRobot> expression_cases() {
  const auto value = [](const std::string& text) { return with("<x v=\"" + text + "\"/>\n"); };
  return {{"UnknownProperty", value("${radius}"), {":2: <x>", "radius", "xacro:property"}},
          {"DivisionByZero", value("${1 / 0}"), {"division by zero"}},
          {"OpenBrace", value("${1 + 2"), {"closing '}'"}},
          {"TextPlusNumber", value("${'a' + 1}"), {"a text + an integer"}},
          {"UnknownFunction", value("${__import__('os')}"), {"__import__", "not supported"}},
          {"Comprehension", value("${[i for i in [1]]}"), {"'for'"}},
          {"MissingArgument", value("$(arg size)"), {"size", "--arg size:=value"}},
          {"MissingVariable", value("$(env CASTAWAY_NOT_SET)"), {"CASTAWAY_NOT_SET", "not set"}},
          {"UnknownSubstitution", value("$(anon robot)"), {"anon", "not supported"}},
          {"DefinedByItself",
           with("<xacro:property name=\"a\" value=\"${a + 1}\"/><x v=\"${a}\"/>"),
           {"depends on itself"}},
          {"TextThatGrows", with(doubling()), {"65536"}},
          {"YamlThatIsMissing", value("${xacro.load_yaml('gone.yaml')}"), {"gone.yaml"}},
          {"YamlOutside", value("${xacro.load_yaml('/etc/hostname')}"), {"lies outside"}},
          {"ErrorOfTheFile", value("${xacro.error('too many wheels')}"), {"too many wheels"}}};
}

std::vector<BadRobot> xacro_cases() {
  const std::string macro = "<xacro:macro name=\"m\" params=\"a *b\"><y/></xacro:macro>\n";
  return {
      {"UnknownMacro", with(macro + "<xacro:n/>"), {"unknown macro 'n'", "known: m"}},
      {"MissingParameter", with(macro + "<xacro:m><z/></xacro:m>"), {"'m' needs a="}},
      {"UnknownParameter", with(macro + "<xacro:m a=\"1\" c=\"2\"><z/></xacro:m>"), {"'c'"}},
      {"MissingBlock", with(macro + "<xacro:m a=\"1\"/>"), {"block 'b'"}},
      {"SpareBlock", with(macro + "<xacro:m a=\"1\"><z/><z/></xacro:m>"), {"no block for <z>"}},
      {"UnknownBlock", with("<xacro:insert_block name=\"b\"/>"), {"no block 'b'"}},
      {"BadParameters", with("<xacro:macro name=\"m\" params=\"a a\"/>"), {"'a' is given twice"}},
      {"ConditionThatIsNone", with("<xacro:if value=\"maybe\"/>"), {"'maybe'", "true, false"}},
      {"ConditionWithoutValue", with("<xacro:if/>"), {"'value'"}},
      {"PropertyWithoutName", with("<xacro:property value=\"1\"/>"), {"'name'"}},
      {"MisspeltAttribute", with("<xacro:property name=\"a\" vlaue=\"1\"/>"), {"'vlaue'", "value"}},
      {"MissingInclude", with("<xacro:include filename=\"gone.xacro\"/>"), {":2:", "gone.xacro"}},
      {"IncludeOfItself", with("<xacro:include filename=\"r.urdf.xacro\"/>"), {"by itself"}},
      {"IncludeOutside",
       with("<xacro:include filename=\"../../../secret.xacro\"/>"),
       {"lies outside", "--search-path"}},
      {"IncludeOfAMissingPackage",
       with("<xacro:include filename=\"$(find gone)/a.xacro\"/>"),
       {"'gone' is not found", "CASTAWAY_PACKAGE_PATH"}},
      {"MacroThatCallsItself",
       with("<xacro:macro name=\"m\" params=\"\"><xacro:m/></xacro:macro><xacro:m/>"),
       {"'m' is called without end"}},
      {"MacrosThatDouble",
       with("<xacro:macro name=\"m\" params=\"n\"><xacro:if value=\"${n > 0}\"><xacro:m n=\"${n - "
            "1}\"/><xacro:m n=\"${n - 1}\"/></xacro:if></xacro:macro><xacro:m n=\"60\"/>"),
       {"without end"}},
      {"UnsupportedElement", with("<xacro:element xacro:name=\"x\"/>"), {"not supported"}},
      {"ArgumentWithoutValue", with(""), {"name:=value"}, "--arg size"}};
}

class BadRobots : public testing::TestWithParam<BadRobot> {};

TEST_P(BadRobots, EndInOneClearLine) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "r.urdf.xacro", std::ios::binary) << GetParam().text;
  std::ofstream(folder / "package.xml") << "<package><name>r</name></package>";
  const Outcome outcome =
      castaway(folder, "check-robot r.urdf.xacro --no-picture " + GetParam().arguments);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_LT(outcome.err.size(), 800U) << outcome.err;
  for (const std::string& part : GetParam().parts) expect_contains(outcome.err, part);
}

std::string name_of(const testing::TestParamInfo<BadRobot>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Xml, BadRobots, testing::ValuesIn(xml_cases()), name_of);
INSTANTIATE_TEST_SUITE_P(Urdf, BadRobots, testing::ValuesIn(urdf_cases()), name_of);
INSTANTIATE_TEST_SUITE_P(Expressions, BadRobots, testing::ValuesIn(expression_cases()), name_of);
INSTANTIATE_TEST_SUITE_P(Xacro, BadRobots, testing::ValuesIn(xacro_cases()), name_of);

TEST(CheckRobot, PrintsJsonAndTakesAPicture) {
  const fs::path folder = fresh_folder();
  const Outcome outcome = castaway(folder, "check-robot mule --json --out mule.png");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "\"kind\": \"skid steer\"");
  expect_contains(outcome.out, "\"track_m\": 0.4");
  EXPECT_GT(fs::file_size(folder / "mule.png"), 10000U);
}

TEST(CheckRobot, TakesArgumentsAndExpands) {
  const fs::path folder = fresh_folder();
  const Outcome low = castaway(folder, "check-robot mule --arg mast:=false --expand");
  EXPECT_EQ(low.exit_code, 0) << low.err;
  expect_contains(low.out, "0.18");
  EXPECT_EQ(low.out.find("mast"), std::string::npos);
  EXPECT_EQ(low.out.find("xacro"), std::string::npos);
}

TEST(CheckRobot, GoesOnWithoutEgl) {
  const fs::path folder = fresh_folder();
  const Outcome outcome =
      castaway(folder, "check-robot disc", "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(outcome.out, "picture: none");
}

TEST(RunWithXacro, TakesItsArgumentsFromTheScenario) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "s.yaml")
      << "robot: {file: mule, args: {mast: false}}\nworld: lab\nduration_s: 1\n"
         "localizers: [amcl]\noutputs: {snapshots: false, report: false}\n";
  const Outcome outcome = castaway(folder, "run s.yaml --out run");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_contains(text_of(folder / "run/scenario.yaml"), "mast: false");
  EXPECT_EQ(castaway(folder, "run run/scenario.yaml --out again").exit_code, 0);
  EXPECT_EQ(castaway(folder, "run s.yaml --set robot.arsg.mast=true").exit_code, 2);
  const Outcome direct = castaway(folder,
                                  "run --robot butler --duration 1 --set outputs.snapshots=false "
                                  "--set events=[] --out butler");
  EXPECT_EQ(direct.exit_code, 0) << direct.err;
  EXPECT_EQ(direct.err, "");
}

}  // namespace
}  // namespace castaway::test
