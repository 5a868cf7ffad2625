/// Options of commands that evaluate recorded logs.
#pragma once

#include <string>
#include <vector>

#include "tools/batch/evaluate/evaluation.hpp"
#include "tools/commands/arguments/command_line.hpp"
#include "tools/commands/arguments/localizer_arguments.hpp"

namespace castaway::testbed {

/// The argument FOLDERS, and the options that choose localizers, by default `mh_amcl`.
void add_log_arguments(Command& command, std::vector<std::string>& folders,
                       LocalizerArguments& localizers);

/// The options --starts, --kidnaps and --window.
void add_trial_options(Command& command, EvaluationConfig& config);

/// The option --align, for `parse_align`.
void add_align_option(Command& command, std::string& align);

}  // namespace castaway::testbed
