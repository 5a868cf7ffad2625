/// Options that choose localizers.
#pragma once

#include <string>
#include <vector>

#include "tools/commands/arguments/command_line.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {

/// Values of --localizer and --allow-programs.
struct LocalizerArguments {
  std::vector<std::string> texts;
  bool allow_programs = false;

  /// The chosen localizers, by default those of `defaults`. Throws as `parse_localizers` does.
  [[nodiscard]] std::vector<LocalizerSpec> specs(const std::vector<std::string>& defaults) const;
};

/// The option --localizer, which also takes files, and --allow-programs. `defaults`: for the help.
void add_localizer_options(Command& command, LocalizerArguments& arguments,
                           const std::string& defaults);

/// The flag --allow-programs.
void add_allow_programs(Command& command, bool& allow);

/// Localizers of the command line as an override of a scenario's `localizers`; empty for none.
std::vector<std::string> localizer_override(const std::vector<std::string>& texts);

/// What the flag means.
FilePrograms file_programs(bool allow);

}  // namespace castaway::testbed
