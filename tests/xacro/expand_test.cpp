#include "xacro/expand.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/robot_files.hpp"
#include "xacro/files/xml_text.hpp"

namespace castaway::xacro {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Compares expanded xacro with text expanded by hand.
class Expand : public RobotFiles {
 protected:
  /// The content of `<robot>` without indentation.
  [[nodiscard]] std::string expanded(const std::string& inside, const Options& options = {}) const {
    const std::string path = write("pkg/urdf/xml_text_of(*robot.xml).xacro", robot(inside));
    std::string urdf = xml_text_of(*expand(path, PackageFinder(path, search_paths_), options).xml);
    urdf = urdf.substr(urdf.find('>') + 1);
    urdf = urdf.substr(0, urdf.rfind("</robot>"));
    std::string flat;
    for (const char c : urdf) {
      const bool indent = c == '\n' || (c == ' ' && (flat.empty() || flat.back() == '>'));
      if (!indent) flat += c;
    }
    return flat;
  }

  [[nodiscard]] std::string error(const std::string& inside, const Options& options = {}) const {
    return error_text([&] { return expanded(inside, options); });
  }

  static std::string robot(const std::string& inside) {
    return "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">" + inside + "</robot>";
  }

  std::vector<std::string> search_paths_;
};

TEST_F(Expand, PropertiesAndArithmetic) {
  EXPECT_EQ(expanded(R"(<xacro:property name="r" value="0.5"/>
                        <xacro:property name="d" value="${2 * r}"/>
                        <a b="${d} ${pi > 3} x" c="$${d}">t${r}</a>)"),
            R"(<a b="1.0 True x" c="${d}">t0.5</a>)");
}

TEST_F(Expand, PropertiesAreEvaluatedWhenAskedFor) {
  EXPECT_EQ(expanded(R"(<xacro:property name="a" value="${b}"/>
                        <xacro:property name="b" value="1"/>
                        <x v="${a}"/>
                        <xacro:property name="c" value="${b}" lazy_eval="false"/>
                        <xacro:property name="b" value="2"/>
                        <x v="${c}"/>)"),
            R"(<x v="1" /><x v="1" />)");
}

TEST_F(Expand, DefaultsOfPropertiesGiveWay) {
  EXPECT_EQ(expanded(R"(<xacro:property name="a" value="1"/>
                        <xacro:property name="a" default="2"/>
                        <xacro:property name="b" default="3"/>
                        <x v="${a} ${b}"/>)"),
            R"(<x v="1 3" />)");
}

TEST_F(Expand, ArgumentsAndTheirDefaults) {
  Options options;
  options.arguments["a"] = "given";
  EXPECT_EQ(expanded(R"(<xacro:arg name="a" default="x"/><xacro:arg name="b" default="y"/>
                        <x v="$(arg a) $(arg b) ${'$(arg b)' == 'y'}"/>)",
                     options),
            R"(<x v="given y True" />)");
}

TEST_F(Expand, SubstitutionsOfTheEnvironmentAndOfFolders) {
  ::setenv("CASTAWAY_TEST_NAME", "value", 1);
  EXPECT_EQ(expanded(R"x(<x v="$(env CASTAWAY_TEST_NAME) $(optenv CASTAWAY_NONE two words)"/>)x"),
            R"x(<x v="value two words" />)x");
  EXPECT_EQ(expanded(R"x(<x v="$(dirname)"/>)x"), "<x v=\"" + at("pkg/urdf") + "\" />");
  EXPECT_EQ(expanded(R"x(<xacro:arg name="n" default="3"/><x v="$(eval n * 2 + arg('n'))"/>)x"),
            R"x(<x v="9" />)x");
}

TEST_F(Expand, Conditions) {
  EXPECT_EQ(expanded(R"(<xacro:property name="a" value="x"/>
                        <xacro:if value="${a == 'x'}"><yes/></xacro:if>
                        <xacro:unless value="${a == 'x'}"><no/></xacro:unless>
                        <xacro:if value="0"><no/></xacro:if>
                        <xacro:if value="true"><xacro:unless value="False"><yes/></xacro:unless></xacro:if>)"),
            "<yes /><yes />");
}

TEST_F(Expand, MacrosWithDefaultsAndBlocks) {
  EXPECT_EQ(expanded(R"(
    <xacro:macro name="wheel" params="name r:=0.1 *origin **extra">
      <link name="${name}"><xacro:insert_block name="origin"/><c r="${r * 2}"/>
        <xacro:insert_block name="extra"/></link>
    </xacro:macro>
    <xacro:wheel name="left"><origin xyz="1 0 0"/><e><p/><q/></e></xacro:wheel>
    <xacro:wheel name="right" r="${1 + 1}"><origin xyz="2 0 0"/><e/></xacro:wheel>)"),
            R"(<link name="left"><origin xyz="1 0 0" /><c r="0.2" /><p /><q /></link>)"
            R"(<link name="right"><origin xyz="2 0 0" /><c r="4" /></link>)");
}

TEST_F(Expand, BlocksAreExpandedWhereTheCallStands) {
  EXPECT_EQ(expanded(R"(
    <xacro:property name="v" value="outer"/>
    <xacro:macro name="inner" params="v *b"><xacro:insert_block name="b"/></xacro:macro>
    <xacro:macro name="outer" params="*b">
      <xacro:inner v="inner"><xacro:insert_block name="b"/></xacro:inner>
    </xacro:macro>
    <xacro:outer><x v="${v}"/></xacro:outer>)"),
            R"(<x v="outer" />)");
}

TEST_F(Expand, PropertiesThatHoldBlocks) {
  EXPECT_EQ(expanded(R"(
    <xacro:property name="look"><m c="${c}"/><n/></xacro:property>
    <xacro:property name="c" value="red"/>
    <v><xacro:insert_block name="look"/></v>)"),
            R"(<v><m c="red" /><n /></v>)");
}

TEST_F(Expand, MacrosSeeWhatTheirCallersSee) {
  EXPECT_EQ(expanded(R"(
    <xacro:property name="side" value="none"/>
    <xacro:macro name="show" params="size:=^|7 side:=^"><x v="${side} ${size}"/></xacro:macro>
    <xacro:macro name="both" params="side"><xacro:show/></xacro:macro>
    <xacro:both side="left"/><xacro:property name="size" value="3"/><xacro:show/>)"),
            R"(<x v="left 7" /><x v="none 3" />)");
}

TEST_F(Expand, ArgumentsThatTheFilesDoNotHaveAreRefused) {
  Options options;
  options.arguments = {{"prefx", "a_"}};
  EXPECT_THAT(error(R"(<xacro:arg name="prefix" default=""/><x/>)", options),
              AllOf(HasSubstr("xml_text_of(*robot.xml).xacro"), HasSubstr("no argument 'prefx'"),
                    HasSubstr("did you mean 'prefix'?")));
  EXPECT_THAT(error("<x/>", options), HasSubstr("it has no <xacro:arg>"));
  EXPECT_EQ(expanded(R"x(<x v="$(arg prefx)"/>)x", options), R"(<x v="a_" />)");
}

TEST_F(Expand, AMacroWhoseNameIsAnExpressionIsNeverCalled) {
  EXPECT_EQ(expanded(R"(<xacro:macro name="${p}_m" params="p"><x/></xacro:macro><y/>)"), "<y />");
}

TEST_F(Expand, PropertiesOfMacrosStayInside) {
  EXPECT_EQ(expanded(R"(
    <xacro:property name="a" value="1"/>
    <xacro:macro name="m" params="">
      <xacro:property name="a" value="2"/>
      <xacro:property name="up" value="${a}" scope="parent"/>
      <xacro:property name="all" value="${a + 1}" scope="global"/>
      <x v="${a}"/>
    </xacro:macro>
    <xacro:m/><x v="${a} ${up} ${all}"/>)"),
            R"(<x v="2" /><x v="1 2 3" />)");
}

TEST_F(Expand, MacrosDefineMacrosAndCallThemselves) {
  EXPECT_EQ(expanded(R"(
    <xacro:macro name="count" params="n">
      <xacro:if value="${n > 0}"><x v="${n}"/><xacro:count n="${n - 1}"/></xacro:if>
    </xacro:macro>
    <xacro:macro name="outer" params=""><xacro:macro name="in" params=""><y/></xacro:macro>
      <xacro:in/></xacro:macro>
    <xacro:count n="3"/><xacro:outer/><xacro:call macro="${'cou' + 'nt'}" n="1"/>)"),
            R"(<x v="3" /><x v="2" /><x v="1" /><y /><x v="1" />)");
}

TEST_F(Expand, IncludesFromTheFileAndFromPackages) {
  write("pkg/package.xml", "<package><name>my_robot</name></package>");
  write("pkg/urdf/parts/a.xacro",
        robot("<xacro:include filename=\"b.xacro\"/><a v=\"$(find my_robot)\"/>"));
  write("pkg/urdf/parts/b.xacro", robot("<xacro:property name=\"p\" value=\"5\"/><b/>"));
  write("other/package.xml", "<package><name>other</name></package>");
  write("other/c.xacro",
        robot("<xacro:macro name=\"m\" params=\"\"><c v=\"${p}\"/></xacro:macro>"));
  EXPECT_EQ(expanded(R"(<xacro:include filename="parts/a.xacro"/>
                        <xacro:include filename="$(find other)/c.xacro"/>
                        <xacro:include filename="none.xacro" optional="true"/><xacro:m/>)"),
            "<b /><a v=\"" + at("pkg") + "\" /><c v=\"5\" />");
}

/// Like Kinova's arms: xacro includes the children of the root, whatever its name.
TEST_F(Expand, IncludesFilesOfAnyRoot) {
  write("pkg/urdf/arm.xacro",
        "<root xmlns:xacro=\"http://www.ros.org/wiki/xacro\"><xacro:property name=\"p\" "
        "value=\"5\"/><a/></root>");
  EXPECT_EQ(expanded(R"(<xacro:include filename="arm.xacro"/><b v="${p}"/>)"),
            R"(<a /><b v="5" />)");
}

TEST_F(Expand, IncludesWithANamespace) {
  write("pkg/urdf/w.xacro", robot(R"(<xacro:property name="r" value="0.1"/>
    <xacro:macro name="wheel" params="name"><w n="${name}" r="${r}"/></xacro:macro>)"));
  EXPECT_EQ(expanded(R"(<xacro:include filename="w.xacro" ns="front"/>
                        <xacro:property name="r" value="9"/>
                        <xacro:front.wheel name="a"/><x v="${front.r} ${r}"/>)"),
            R"(<w n="a" r="0.1" /><x v="0.1 9" />)");
}

TEST_F(Expand, YamlIfThereIsAReader) {
  Options options;
  options.read_yaml = [](const std::string&) {
    return Value{Dict{{"wheel", {Dict{{"radius", {0.04}}}}}}};
  };
  EXPECT_EQ(expanded(R"(<xacro:property name="c" value="${xacro.load_yaml('c.yaml')}"/>
                        <x v="${c['wheel']['radius'] * 2} ${c.wheel.radius}"/>)",
                     options),
            R"(<x v="0.08 0.04" />)");
  EXPECT_THAT(error(R"(<x v="${xacro.load_yaml('c.yaml')}"/>)"), HasSubstr("not supported"));
}

TEST_F(Expand, PlainUrdfComesBackAsItIs) {
  EXPECT_EQ(expanded("<!-- kept --><link name=\"$5\"/>"), "<link name=\"$5\" />");
}

TEST_F(Expand, WarnsOfPackagesThatAreNotNeededToReadOn) {
  const std::string path =
      write("pkg/r.xacro", robot("<xacro:if value=\"1\"><p>$(find gone)/c.yaml</p></xacro:if>"));
  const Expansion robot = expand(path, PackageFinder(path, {}), {});
  EXPECT_THAT(xml_text_of(*robot.xml), HasSubstr("$(find gone)/c.yaml"));
  EXPECT_THAT(robot.warnings, ElementsAre(HasSubstr("'gone' is not found")));
}

TEST_F(Expand, ErrorsNameFileLineAndElement) {
  write("pkg/urdf/bad.xacro", "<robot>\n\n  <x v=\"${nothing}\"/>\n</robot>");
  EXPECT_THAT(error("\n<xacro:include filename=\"bad.xacro\"/>"),
              AllOf(HasSubstr("bad.xacro:3: <x>: in ${nothing}"), HasSubstr("not defined")));
  EXPECT_THAT(error("\n\n<xacro:nope/>"),
              HasSubstr("xml_text_of(*robot.xml).xacro:3: <xacro:nope>"));
}

TEST_F(Expand, RefusesEndlessRecursion) {
  EXPECT_THAT(error(R"(<xacro:macro name="m" params=""><xacro:m/></xacro:macro><xacro:m/>)"),
              HasSubstr("'m' is called without end"));
  EXPECT_THAT(error(R"(<xacro:macro name="m" params="n"><xacro:if value="${n &lt; 40}">
                       <xacro:m n="${n + 1}"/><xacro:m n="${n + 1}"/></xacro:if></xacro:macro>
                       <xacro:m n="0"/>)"),
              HasSubstr("without end"));
  write("pkg/urdf/a.xacro", robot("<xacro:include filename=\"a.xacro\"/>"));
  EXPECT_THAT(error(R"(<xacro:include filename="a.xacro"/>)"), HasSubstr("included by itself"));
  EXPECT_THAT(error(R"(<xacro:property name="a" value="${b}"/>
                       <xacro:property name="b" value="${a}"/><x v="${a}"/>)"),
              HasSubstr("depends on itself"));
}

TEST_F(Expand, RefusesTextsThatGrow) {
  std::string bomb = R"(<xacro:property name="p0" value="lol"/>)";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "${p" + std::to_string(i - 1) + "}";
    bomb +=
        "<xacro:property name=\"p" + std::to_string(i) + "\" value=\"" + before + before + "\"/>";
  }
  EXPECT_THAT(error(bomb + "<x v=\"${p39}\"/>"), HasSubstr("65536"));
}

TEST_F(Expand, RefusesBlocksAndListsThatDouble) {
  std::string blocks = "<a/>";
  std::string lists = R"(<xacro:property name="l0" value="${[1]}"/>)";
  for (int i = 0; i < 40; ++i) {
    blocks.insert(0, "<xacro:d><q>").append("</q></xacro:d>");
    const std::string l = "l" + std::to_string(i);
    lists += "<xacro:property name=\"l" + std::to_string(i + 1) + "\" value=\"${[" + l + ", " + l +
             "]}\"/>";
  }
  EXPECT_THAT(error(R"(<xacro:macro name="d" params="**b"><w><xacro:insert_block name="b"/>
                       <xacro:insert_block name="b"/></w></xacro:macro>)" +
                    blocks),
              HasSubstr("more than 200000 elements"));
  EXPECT_THAT(error(lists + R"(<x v="${len(l40)}"/>)"), HasSubstr("make it smaller"));
}

TEST_F(Expand, RefusesMoreTextThanMemoryHolds) {
  const std::string text(60000, 'x');
  EXPECT_THAT(error("<xacro:macro name=\"m\" params=\"n\"><xacro:if value=\"${n > 0}\"><x v=\"" +
                    text + "\"/><xacro:m n=\"${n - 1}\"/></xacro:if></xacro:macro>" +
                    [] {
                      std::string calls;
                      for (int i = 0; i < 20; ++i) calls += "<xacro:m n=\"90\"/>";
                      return calls;
                    }()),
              HasSubstr("64 MiB"));
}

TEST_F(Expand, RefusesFilesOutside) {
  write("secret.xacro", robot("<x/>"));
  EXPECT_THAT(error(R"(<xacro:include filename="../../secret.xacro"/>)"),
              AllOf(HasSubstr("secret.xacro lies outside"), HasSubstr("--search-path")));
  EXPECT_THAT(error(R"(<xacro:include filename="/etc/passwd"/>)"), HasSubstr("lies outside"));
  search_paths_ = {at("")};
  EXPECT_EQ(expanded(R"(<xacro:include filename="../../secret.xacro"/>)"), "<x />");
}

}  // namespace
}  // namespace castaway::xacro
