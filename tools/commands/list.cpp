// castaway worlds, robots, scenarios: lists what is shipped.
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/commands/commands.hpp"
#include "tools/files/json_text.hpp"
#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {
namespace {

/// An entry of a list.
struct Listed {
  std::string name;
  std::filesystem::path file;
};

std::vector<Listed> worlds() {
  std::vector<Listed> list;
  for (const std::string& name : world_names()) list.push_back({name, find_world(name, ".")});
  return list;
}

std::vector<Listed> robots() {
  std::vector<Listed> list;
  for (const std::string& name : robot_names()) list.push_back({name, find_robot(name, ".")});
  return list;
}

std::vector<Listed> scenarios() {
  std::vector<Listed> list;
  for (const std::string& name : scenario_names()) list.push_back({name, find_scenario(name, ".")});
  return list;
}

int print(const std::vector<Listed>& list, bool json) {
  auto array = nlohmann::ordered_json::array();
  for (const Listed& one : list) {
    array.push_back({{"name", one.name}, {"file", one.file.string()}});
    if (!json) fmt::print("{:<28} {}\n", one.name, one.file.string());
  }
  if (json) fmt::print("{}\n", json_text(array, 1));
  return kDone;
}

void add_list(Command& app, const std::string& name, const std::string& text,
              const std::string& example, std::vector<Listed> (*list)()) {
  auto json = std::make_shared<bool>(false);
  Command command = app.add_command(name, text);
  command.add_flag("--json", *json, "Print JSON instead of a table");
  command.footer("Example:\n  castaway " + name + "\n  " + example);
  command.action([json, list] { return print(list(), *json); });
}

}  // namespace

void add_list_commands(Command& app) {
  add_list(app, "worlds", "List the shipped worlds", "castaway run --world office", worlds);
  add_list(app, "robots", "List the shipped robots", "castaway run --robot mule", robots);
  add_list(app, "scenarios", "List the shipped scenarios", "castaway run office/look-alikes",
           scenarios);
}

}  // namespace castaway::testbed
