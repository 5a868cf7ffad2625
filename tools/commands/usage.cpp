#include "tools/commands/usage.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>

#include <fmt/format.h>

#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return names;
}

std::vector<const CLI::App*> subcommands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// "castaway bench kidnaps": as far as the parser came.
std::string path_of(const CLI::App& app, const CLI::App*& last) {
  std::string path = "castaway";
  last = &app;
  for (auto chosen = app.get_subcommands(); !chosen.empty(); chosen = last->get_subcommands()) {
    last = chosen.front();
    path += " " + last->get_name();
  }
  return path;
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// The option that an unexpected word may have meant.
std::string not_expected(const CLI::App& command, const std::string& word) {
  if (!word.starts_with("-")) return fmt::format("'{}' is one word too many", word);
  const std::string name = word.substr(0, word.find('='));
  const auto near = nearest_name(name, options_of(command));
  const bool close = near && edit_distance(name, *near) <= 3;
  return fmt::format("no option '{}'{}", name,
                     close ? fmt::format("; did you mean '{}'?", *near) : "");
}

}  // namespace

std::optional<std::string> unknown_command(const CLI::App& app,
                                           const std::vector<std::string>& words) {
  const CLI::App* level = &app;
  std::string path = "castaway";
  for (std::size_t i = 0;; ++i) {
    const std::vector<const CLI::App*> known = subcommands_of(*level);
    if (known.empty()) return std::nullopt;
    if (i >= words.size()) {
      return fmt::format("{}: give a command: {}; `{} --help` says what they do", path,
                         fmt::join(names_of(known), ", "), path);
    }
    if (words[i].starts_with("-")) return std::nullopt;  // --help, --version, or an option amiss.
    const auto found = std::find_if(known.begin(), known.end(), [&](const CLI::App* command) {
      return command->get_name() == words[i];
    });
    if (found == known.end()) {
      return fmt::format("{}: no command '{}'; {}; `{} --help` lists them", path, words[i],
                         suggestion(words[i], names_of(known)), path);
    }
    level = *found;
    path += " " + level->get_name();
  }
}

std::string describe_usage(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = nullptr;
  const std::string path = path_of(app, command);
  std::string what = error.what();
  const std::vector<std::string> extras = command->remaining();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !extras.empty()) {
    what = not_expected(*command, extras.front());
  }
  std::replace(what.begin(), what.end(), '\n', ' ');
  return fmt::format("{}: {}; `{} --help` says what it takes", path, what, path);
}

void require_whole_seeds(CLI::App& app) {
  const CLI::Validator whole(
      [](const std::string& text) {
        std::uint64_t value = 0;
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        const bool good = error == std::errc{} && stop == end;
        return good ? std::string() : "needs a whole number from 0 to 2^64 - 1, not " + text;
      },
      "");
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (CLI::Option* seed = command->get_option_no_throw("--seed")) seed->check(whole);
    require_whole_seeds(*command);
  }
}

}  // namespace castaway::testbed
