#include "sim/robot/urdf_file.hpp"

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include <console_bridge/console.h>
#include <fmt/format.h>

namespace castaway::sim {
namespace {

constexpr int kSubstitutionRounds = 5;  // Constants may name constants.

/// Keeps what urdfdom would print.
class ConsoleCapture : public console_bridge::OutputHandler {
 public:
  ConsoleCapture() { console_bridge::useOutputHandler(this); }
  ~ConsoleCapture() override { console_bridge::restorePreviousOutputHandler(); }
  ConsoleCapture(const ConsoleCapture&) = delete;
  ConsoleCapture& operator=(const ConsoleCapture&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    if (!errors_.empty()) errors_ += "; ";
    errors_ += text;
  }
  [[nodiscard]] const std::string& errors() const { return errors_; }

 private:
  std::string errors_;
};

std::string read_text(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  if (!file || !(text << file.rdbuf())) {
    throw std::runtime_error(
        fmt::format("{}: cannot read this robot: check that the path names a URDF file", path));
  }
  return text.str();
}

std::unique_ptr<TiXmlDocument> parse_xml(const std::string& path, const std::string& text) {
  auto document = std::make_unique<TiXmlDocument>();
  document->Parse(text.c_str(), nullptr, TIXML_ENCODING_UTF8);
  if (document->Error()) {
    throw std::runtime_error(fmt::format("{}:{}: not well-formed XML: {}", path,
                                         document->ErrorRow(), document->ErrorDesc()));
  }
  const TiXmlElement* root = document->RootElement();
  if (root == nullptr || root->ValueStr() != "robot") {
    throw std::runtime_error(
        fmt::format("{}: not a URDF file: its root element must be <robot>", path));
  }
  return document;
}

std::string attribute(const TiXmlElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value == nullptr ? "" : value;
}

/// What stands for `${name}` and `$(arg name)`.
std::map<std::string, std::string> constants(const TiXmlElement& root) {
  std::map<std::string, std::string> result;
  for (auto* e = root.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    const std::string name = attribute(*e, "name");
    if (e->ValueStr() == "xacro:arg") result["$(arg " + name + ")"] = attribute(*e, "default");
    if (e->ValueStr() == "xacro:property") result["${" + name + "}"] = attribute(*e, "value");
  }
  return result;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

/// Names the first thing that needs a real xacro processor; empty if there is none.
std::string first_xacro(const TiXmlElement& root, const std::string& text) {
  for (auto* e = root.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
    const std::string& name = e->ValueStr();
    if (name.starts_with("xacro:") && name != "xacro:arg" && name != "xacro:property") {
      return fmt::format("<{}> in line {}", name, e->Row());
    }
  }
  const std::size_t at = std::min(text.find("${"), text.find("$("));
  if (at == std::string::npos) return "";
  return text.substr(at, std::min<std::size_t>(text.find_first_of(")}", at) + 1 - at, 40));
}

}  // namespace

UrdfFile read_urdf(const std::string& path) {
  UrdfFile file;
  file.path = path;
  std::string text = read_text(path);
  file.xml = parse_xml(path, text);
  for (int round = 0; round < kSubstitutionRounds; ++round) {
    for (const auto& [what, by] : constants(*file.xml->RootElement())) replace_all(text, what, by);
  }
  file.xml = parse_xml(path, text);
  const std::string xacro = first_xacro(*file.xml->RootElement(), text);
  if (!xacro.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: needs xacro ({}): expand it first: xacro {} > robot.urdf", path, xacro, path));
  }
  const ConsoleCapture console;
  file.model = urdf::parseURDF(text);
  if (!file.model) {
    throw std::runtime_error(fmt::format("{}: not a valid URDF: {}", path, console.errors()));
  }
  return file;
}

}  // namespace castaway::sim
