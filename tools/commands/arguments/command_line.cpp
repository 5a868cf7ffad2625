#include "tools/commands/arguments/command_line.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "tools/base/output/exit_code.hpp"
#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return names;
}

/// "castaway bench kidnaps": the commands that the parser recognized.
std::string path_of(const CLI::App& app, const CLI::App*& last) {
  std::string path = app.get_name();
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

/// The option nearest to an unexpected word.
std::string not_expected(const CLI::App& command, const std::string& word) {
  if (!word.starts_with("-")) return fmt::format("'{}' is one word too many", word);
  const std::string name = word.substr(0, word.find('='));
  const auto near = close_name(name, options_of(command));
  return fmt::format("no option '{}'{}", name,
                     near ? fmt::format("; did you mean '{}'?", *near) : "");
}

/// The error in words that no command takes; empty: none. Other errors can be their consequence:
/// with `--hlep`, "log is required".
std::string extras_trouble(const CLI::App& app, const CLI::App& command, bool any_word) {
  for (const CLI::App* level : {&command, &app}) {
    for (const std::string& word : level->remaining()) {
      if (any_word || word.starts_with("-")) return not_expected(*level, word);
    }
  }
  return "";
}

std::string describe_usage(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* command = nullptr;
  const std::string path = path_of(app, command);
  const bool extras = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  std::string what = extras_trouble(app, *command, extras);
  if (what.empty()) what = error.what();
  std::replace(what.begin(), what.end(), '\n', ' ');
  return fmt::format("{}: {}; `{} --help` says what it takes", path, what, path);
}

std::string whole_number_trouble(const std::string& text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool good = error == std::errc{} && stop == end;
  return good ? std::string() : "needs a whole number from 0 to 2^64 - 1, not " + text;
}

void require_whole_seeds(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    CLI::Option* seed = command->get_option_no_throw("--seed");
    if (seed != nullptr) seed->check(CLI::Validator(whole_number_trouble, ""));
    require_whole_seeds(*command);
  }
}

}  // namespace

Option Option::required() {
  option_->required();
  return *this;
}

Option Option::at_least(int least) {
  option_->expected(least, -1);
  return *this;
}

Option Option::repeatable() {
  option_->allow_extra_args(false);
  return *this;
}

Option Option::show_default() {
  option_->capture_default_str();
  return *this;
}

Option Option::range(int low, int high) {
  option_->check(CLI::Range(low, high));
  return *this;
}

Option Option::range(double low, double high) {
  option_->check(CLI::Range(low, high));
  return *this;
}

Option Option::one_of(const std::vector<std::string>& values) {
  option_->check(CLI::IsMember(values));
  return *this;
}

Option Option::value_name(const std::string& name) {
  option_->type_name(name);
  return *this;
}

Option Option::not_negative() {
  option_->check(CLI::NonNegativeNumber);
  return *this;
}

Option Option::positive() {
  option_->check(CLI::PositiveNumber);
  return *this;
}

Option Option::check(const Check& check) {
  option_->check(CLI::Validator([check](const std::string& value) { return check(value); }, ""));
  return *this;
}

bool Option::given() const { return option_->count() > 0; }

Command Command::add_command(const std::string& name, const std::string& what) {
  return {app_->add_subcommand(name, what), chosen_};
}

template <typename T>
Option Command::add_option(const std::string& names, T& value, const std::string& what) {
  return Option(app_->add_option(names, value, what));
}

using Text = std::string;
template Option Command::add_option(const Text&, std::string&, const Text&);
template Option Command::add_option(const Text&, std::vector<std::string>&, const Text&);
template Option Command::add_option(const Text&, std::vector<int>&, const Text&);
template Option Command::add_option(const Text&, int&, const Text&);
template Option Command::add_option(const Text&, std::int64_t&, const Text&);
template Option Command::add_option(const Text&, std::uint64_t&, const Text&);
template Option Command::add_option(const Text&, double&, const Text&);
template Option Command::add_option(const Text&, std::optional<double>&, const Text&);
template Option Command::add_option(const Text&, std::optional<std::int64_t>&, const Text&);
template Option Command::add_option(const Text&, std::optional<std::uint64_t>&, const Text&);

Option Command::add_option(const std::string& names,
                           const std::function<void(const std::string&)>& take,
                           const std::string& what) {
  return Option(app_->add_option_function<std::string>(names, take, what));
}

void Command::add_flag(const std::string& names, bool& value, const std::string& what) {
  app_->add_flag(names, value, what);
}

void Command::footer(const std::string& text) { app_->footer(text); }

void Command::action(const std::function<int()>& act) {
  app_->callback([chosen = chosen_, act] { *chosen = act; });
}

void Command::require_command() { app_->require_subcommand(1); }

std::string Command::name() const { return app_->get_name(); }

std::string Command::what() const { return app_->get_description(); }

std::string Command::footer() const { return app_->get_footer(); }

std::vector<Command> Command::commands() const {
  std::vector<Command> commands;
  for (CLI::App* command : app_->get_subcommands([](const CLI::App*) { return true; })) {
    commands.emplace_back(command, chosen_);
  }
  return commands;
}

std::vector<OptionText> Command::options() const {
  std::vector<OptionText> texts;
  for (const CLI::Option* option : app_->get_options()) {
    const bool takes_value = option->get_items_expected_max() != 0;
    texts.push_back({option->get_positional() ? option->get_name(true) : option->get_name(),
                     takes_value ? option->get_type_name() : "", option->get_description(),
                     option->get_lnames()});
  }
  return texts;
}

std::vector<std::string> replace_help_words(const std::vector<std::string>& words) {
  if (words.empty() || words.front() != "help") return words;
  std::vector<std::string> replaced(words.begin() + 1, words.end());
  replaced.emplace_back("--help");
  return replaced;
}

CommandLine::CommandLine(const std::string& what, const std::string& version)
    : app_(std::make_unique<CLI::App>(what)) {
  app_->set_version_flag("--version", version);
  app_->require_subcommand(1);
  app_->name(version.substr(0, version.find(' ')));
}

CommandLine::~CommandLine() = default;

Command CommandLine::root() { return {app_.get(), &chosen_}; }

void CommandLine::require_whole_seeds() { testbed::require_whole_seeds(*app_); }

std::optional<std::string> CommandLine::unknown_command(const std::vector<std::string>& words) {
  const CLI::App* level = app_.get();
  std::string path = app_->get_name();
  for (std::size_t i = 0;; ++i) {
    const std::vector<const CLI::App*> known = commands_of(*level);
    if (known.empty()) return std::nullopt;
    if (i >= words.size()) {
      return fmt::format("{}: give a command: {}; `{} --help` says what they do", path,
                         fmt::join(names_of(known), ", "), path);
    }
    if (words[i].starts_with("-")) return std::nullopt;  // --help, --version, or an unknown option.
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

CommandLine::Parsed CommandLine::parse(const std::vector<std::string>& words) {
  try {
    app_->parse(std::vector<std::string>(words.rbegin(), words.rend()));
    return {chosen_, kDone, {}};
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return {{}, app_->exit(error), {}};  // --help, --version
    return {{}, kBadInput, describe_usage(*app_, error)};
  }
}

}  // namespace castaway::testbed
