// castaway settings: lists every key of a scenario with its default, range and meaning.
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/commands/commands.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct SettingsArguments {
  std::string prefix;
  bool json = false;
  bool markdown = false;
};

std::string bounds_of(const SettingText& setting) {
  std::string text = setting.range;
  if (!setting.unit.empty()) text += (text.empty() ? "" : " ") + setting.unit;
  return text;
}

void print_words(const std::vector<SettingText>& settings) {
  for (const SettingText& s : settings) {
    const std::string bounds = bounds_of(s);
    print_out("{}: {}\n    {}{}\n", s.path, s.value.empty() ? "-" : s.value, s.what,
              bounds.empty() ? "" : " [" + bounds + "]");
  }
}

std::string in_table(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, "\\");
  }
  return text;
}

void print_markdown(const std::vector<SettingText>& settings) {
  std::string section;
  for (const SettingText& s : settings) {
    const std::size_t dot = s.path.rfind('.');
    const std::string here = dot == std::string::npos ? "Run" : s.path.substr(0, dot);
    if (here != section) {
      print_out("\n## {}\n\n| key | default | range | meaning |\n|---|---|---|---|\n",
                dot == std::string::npos ? here : "`" + here + "`");
      section = here;
    }
    print_out("| `{}` | {} | {} | {} |\n", s.path.substr(dot == std::string::npos ? 0 : dot + 1),
              s.value.empty() ? "" : "`" + in_table(s.value) + "`", in_table(bounds_of(s)),
              in_table(s.what));
  }
}

void print_json(const std::vector<SettingText>& settings) {
  auto all = nlohmann::ordered_json::array();
  for (const SettingText& s : settings) {
    all.push_back({{"key", s.path},
                   {"default", s.value},
                   {"range", s.range},
                   {"unit", s.unit},
                   {"what", s.what}});
  }
  print_out("{}\n", json_text(all, 1));
}

int list_settings(const SettingsArguments& arguments) {
  std::vector<SettingText> settings = scenario_settings();
  std::erase_if(settings,
                [&](const SettingText& s) { return !s.path.starts_with(arguments.prefix); });
  if (settings.empty()) {
    throw std::runtime_error("no setting begins with '" + arguments.prefix +
                             "'; `castaway settings` lists all of them");
  }
  if (arguments.json) {
    print_json(settings);
  } else if (arguments.markdown) {
    print_markdown(settings);
  } else {
    print_words(settings);
  }
  return kDone;
}

}  // namespace

void add_settings_command(Command& app) {
  auto a = std::make_shared<SettingsArguments>();
  Command command =
      app.add_command("settings", "List the keys of a scenario: defaults, ranges, meaning");
  command.add_option("prefix", a->prefix, "Only keys with this prefix: \"drive\", \"lidar.noise\"");
  command.add_flag("--markdown", a->markdown,
                   "Print Markdown tables, as docs/settings.md has them");
  command.add_flag("--json", a->json, "Print JSON");
  command.footer("Example:\n  castaway settings odometry.slip");
  command.action([a] { return list_settings(*a); });
}

}  // namespace castaway::testbed
