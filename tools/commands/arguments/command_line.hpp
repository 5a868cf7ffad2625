/// The program's command line: commands, their options, errors.
///
/// A wrapper of CLI11, which is header-only and takes seconds to compile: only command_line.cpp
/// includes it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace castaway::testbed {

/// A handle of an option or positional argument. Valid as long as its command line.
class Option {
 public:
  /// Returns the error in a value; empty: none.
  using Check = std::function<std::string(const std::string& value)>;

  explicit Option(CLI::Option* option) : option_(option) {}

  Option required();
  /// Requires at least `least` values.
  Option at_least(int least);
  /// Accepts `--x a --x b`, not `--x a b`.
  Option repeatable();
  /// Shows the current value as the default in the help text.
  Option show_default();
  /// Requires a value from `low` to `high`, both included.
  Option range(int low, int high);
  Option range(double low, double high);
  Option one_of(const std::vector<std::string>& values);
  /// Name of the value in the help text, if the variable's type is not enough.
  Option value_name(const std::string& name);
  Option not_negative();
  Option positive();
  Option check(const Check& check);
  /// True if the command line has the option.
  [[nodiscard]] bool given() const;

 private:
  CLI::Option* option_;
};

/// An option as in the help text.
struct OptionText {
  std::string name;   ///< "-j,--jobs", or of a positional argument "log".
  std::string value;  ///< "INT in [1 - 1024]"; empty for a flag.
  std::string what;
  std::vector<std::string> long_names;  ///< Without dashes.
};

/// A handle of a command. Variables that options are bound to must outlive the parsing.
class Command {
 public:
  Command(CLI::App* app, std::function<int()>* chosen) : app_(app), chosen_(chosen) {}

  /// Adds a subcommand.
  Command add_command(const std::string& name, const std::string& what);
  /// An option ("--out", "-j,--jobs"), or a positional argument ("log"). Defined for texts,
  /// numbers, lists of texts and of integers, and optional numbers.
  template <typename T>
  Option add_option(const std::string& names, T& value, const std::string& what);
  /// Adds an option whose value is passed to `take`.
  Option add_option(const std::string& names, const std::function<void(const std::string&)>& take,
                    const std::string& what);
  /// Adds a flag; "!--no-x" sets it to false.
  void add_flag(const std::string& names, bool& value, const std::string& what);
  /// Text at the end of the help text.
  void footer(const std::string& text);
  /// Sets the action, which returns an exit code.
  void action(const std::function<int()>& act);
  /// Requires one of the subcommands.
  void require_command();

  [[nodiscard]] std::string name() const;
  [[nodiscard]] std::string what() const;
  [[nodiscard]] std::string footer() const;
  [[nodiscard]] std::vector<Command> commands() const;
  [[nodiscard]] std::vector<OptionText> options() const;

 private:
  CLI::App* app_;
  std::function<int()>* chosen_;
};

/// The words of a command line with `help run` as `run --help`.
std::vector<std::string> replace_help_words(const std::vector<std::string>& words);

/// The whole command line.
class CommandLine {
 public:
  /// `version`: what --version prints: the program's name and its version.
  CommandLine(const std::string& what, const std::string& version);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  [[nodiscard]] Command root();
  /// Every `--seed` takes a whole number from 0: CLI11 takes -1 for 2^64 - 1.
  void require_whole_seeds();
  /// The error for an unknown command, with the nearest known one; nothing if all are known.
  /// `words`: the command line without the program's name.
  [[nodiscard]] std::optional<std::string> unknown_command(const std::vector<std::string>& words);

  /// The result of parsing.
  struct Parsed {
    std::function<int()> act;  ///< Empty: the program ends with `exit_code`.
    int exit_code = 0;         ///< 0 after --help and --version, which it has printed.
    std::string trouble;       ///< Error in one line; empty: none.
  };
  /// `words`: the command line without the program's name.
  Parsed parse(const std::vector<std::string>& words);

 private:
  std::unique_ptr<CLI::App> app_;
  std::function<int()> chosen_;
};

}  // namespace castaway::testbed
