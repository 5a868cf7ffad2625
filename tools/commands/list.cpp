// castaway list: what is shipped, with a line of description each. castaway worlds, robots,
// scenarios: their files, for scripts.
#include <algorithm>
#include <array>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/commands/commands.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/files/file_description.hpp"
#include "tools/scenario/sections/lidar_profile.hpp"

namespace castaway::testbed {
namespace {

/// An entry of a list.
struct Listed {
  std::string name;
  std::filesystem::path file;
};

template <typename FileOf>
std::vector<Listed> listed(const std::vector<std::string>& names, const FileOf& file_of) {
  std::vector<Listed> list;
  for (const std::string& name : names) list.push_back({name, file_of(name)});
  return list;
}

std::vector<Listed> worlds() {
  return listed(world_names(), [](const std::string& name) { return find_world(name, "."); });
}

std::vector<Listed> robots() {
  return listed(robot_names(), [](const std::string& name) { return find_robot(name, "."); });
}

std::vector<Listed> scenarios() {
  return listed(scenario_names(), [](const std::string& name) { return find_scenario(name, "."); });
}

std::vector<Listed> lidars() {
  const auto file = [](const std::string& name) {
    return data_root() / "lidars" / (name + ".yaml");
  };
  return listed(lidar_profile_names(), file);
}

/// A kind of what is shipped.
struct ListedKind {
  const char* name;
  std::vector<Listed> (*list)();
};
constexpr std::array<ListedKind, 4> kListKinds{
    {{"worlds", worlds}, {"robots", robots}, {"lidars", lidars}, {"scenarios", scenarios}}};

std::string description_of(const ListedKind& kind, const Listed& one) {
  if (kind.list == lidars) return load_lidar_profile(one.name).device;
  return first_sentence(one.file);
}

void print_described(const ListedKind& kind) {
  constexpr std::size_t kLine = 100;
  const std::vector<Listed> list = kind.list();
  std::size_t width = 0;
  for (const Listed& one : list) width = std::max(width, one.name.size());
  for (const Listed& one : list) {
    print_out("  {:<{}}  {}\n", one.name, width,
              shorten(description_of(kind, one), kLine - width - 4));
  }
}

/// Prints one kind, or all if `what` is empty.
int print_kinds(const std::string& what, bool json) {
  auto kinds = nlohmann::ordered_json::object();
  for (const ListedKind& kind : kListKinds) {
    if (!what.empty() && what != kind.name) continue;
    if (!json) {
      print_out("{}{}:\n", what.empty() && kind.list != worlds ? "\n" : "", kind.name);
      print_described(kind);
      continue;
    }
    auto& array = kinds[kind.name] = nlohmann::ordered_json::array();
    for (const Listed& one : kind.list()) {
      array.push_back({{"name", one.name},
                       {"file", one.file.string()},
                       {"description", description_of(kind, one)}});
    }
  }
  if (json) print_out("{}\n", json_text(kinds, 1));
  return kDone;
}

void add_described_list(Command& app) {
  auto what = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  Command command = app.add_command("list", "List what comes along, with a line about each");
  command.add_option("what", *what, "worlds, robots, lidars or scenarios; default: all")
      .one_of({"worlds", "robots", "lidars", "scenarios"});
  command.add_flag("--json", *json, "Print JSON, with files, instead of a table");
  command.footer("Examples:\n  castaway list\n  castaway list scenarios");
  command.action([what, json] { return print_kinds(*what, *json); });
}

int print(const std::vector<Listed>& list, bool json) {
  auto array = nlohmann::ordered_json::array();
  for (const Listed& one : list) {
    array.push_back({{"name", one.name}, {"file", one.file.string()}});
    if (!json) print_out("{:<28} {}\n", one.name, one.file.string());
  }
  if (json) print_out("{}\n", json_text(array, 1));
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
  add_described_list(app);
  add_list(app, "worlds", "List the shipped worlds", "castaway run --world office", worlds);
  add_list(app, "robots", "List the shipped robots", "castaway run --robot mule", robots);
  add_list(app, "scenarios", "List the shipped scenarios", "castaway run office/look-alikes",
           scenarios);
}

}  // namespace castaway::testbed
