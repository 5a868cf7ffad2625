/// Reads localizers that are programs or shared libraries of the user's.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Whether files may name programs and libraries that a command then starts or loads.
enum class FilePrograms {
  kRefused,  ///< Only the command line may.
  kAllowed,  ///< The user trusts the file: --allow-programs.
};

/// Where files that name localizers lie, and whether they are trusted.
struct ForeignRules {
  std::filesystem::path folder = {};  ///< Relative files are also looked for here.
  FilePrograms programs = FilePrograms::kRefused;
};

/// True if the localizer is a program or library of the user's.
bool is_foreign(const LocalizerSpec& spec);

/// Reads `{name, program, params, ...}` or `{name, library, params}`; nothing for another form.
/// Fails, naming --allow-programs, if a file that is not trusted names it.
std::optional<LocalizerSpec> read_foreign(YamlReader& item, const ForeignRules& rules);

/// Parses `program:COMMAND` or `library:FILE` of the command line; nothing for another text. Throws
/// std::invalid_argument.
std::optional<LocalizerSpec> parse_foreign(const std::string& text);

/// The same as an element of a scenario's list, in YAML's flow style.
std::string foreign_yaml(const LocalizerSpec& spec);

/// Appends the settings of both.
void describe_foreign(std::vector<SettingText>& texts);

/// Splits a command into words at blanks; quotes and backslashes protect them as in a shell. Throws
/// std::invalid_argument for a quote without its end.
std::vector<std::string> split_words(const std::string& command);

}  // namespace castaway::testbed
