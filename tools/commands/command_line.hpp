/// The program's command line: commands, their options, what is wrong with a line of words.
///
/// CLI11 does the work. It is header-only and takes five seconds to compile, so that only
/// command_line.cpp includes it.
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
  /// What is wrong with a value; empty: nothing.
  using Check = std::function<std::string(const std::string& value)>;

  explicit Option(CLI::Option* option) : option_(option) {}

  Option required();
  /// Takes from `least` values on.
  Option at_least(int least);
  /// `--x a --x b` rather than `--x a b`.
  Option repeatable();
  /// Help states the present value as the default.
  Option show_default();
  /// From `low` to `high`, both included.
  Option range(int low, int high);
  Option range(double low, double high);
  Option one_of(const std::vector<std::string>& values);
  /// What help calls the value, where the variable's type does not say it.
  Option value_name(const std::string& name);
  Option not_negative();
  Option positive();
  Option check(const Check& check);
  /// Whether the command line gave it.
  [[nodiscard]] bool given() const;

 private:
  CLI::Option* option_;
};

/// An option as help shows it.
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

  /// A command below this one.
  Command add_command(const std::string& name, const std::string& what);
  /// An option ("--out", "-j,--jobs"), or a positional argument ("log"). Defined for texts,
  /// numbers, lists of texts and of integers, and optional numbers.
  template <typename T>
  Option add_option(const std::string& names, T& value, const std::string& what);
  /// An option of which `take` gets the value.
  Option add_option(const std::string& names, std::function<void(const std::string&)> take,
                    const std::string& what);
  /// True where it is given; "!--no-x" sets false.
  void add_flag(const std::string& names, bool& value, const std::string& what);
  /// What help says at its end.
  void footer(const std::string& text);
  /// What the command does; returns an exit code.
  void action(const std::function<int()>& act);
  /// One of the commands below must be given.
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

/// The whole command line.
class CommandLine {
 public:
  /// `version`: what --version prints.
  CommandLine(const std::string& what, const std::string& version);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  [[nodiscard]] Command root();
  /// Every `--seed` takes a whole number from 0: CLI11 takes -1 for 2^64 - 1.
  void require_whole_seeds();
  /// A word where a command should stand that is none, with the nearest one; nothing if the
  /// commands are known. `words`: the command line without the program's name.
  [[nodiscard]] std::optional<std::string> unknown_command(const std::vector<std::string>& words);

  /// What a line of words asks for.
  struct Parsed {
    std::function<int()> act;  ///< Empty: nothing is left to do but to end with `exit_code`.
    int exit_code = 0;         ///< 0 after --help and --version, which it has printed.
    std::string trouble;       ///< In one line, with where help is; empty: none.
  };
  Parsed parse(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
  std::function<int()> chosen_;
};

}  // namespace castaway::testbed
