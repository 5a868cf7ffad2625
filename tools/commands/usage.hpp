/// What is wrong with a command line, in one line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace castaway::testbed {

/// A word where a subcommand should stand that is none, with the nearest one; nothing if the
/// subcommands are known. `words`: the command line without the program's name.
std::optional<std::string> unknown_command(const CLI::App& app,
                                           const std::vector<std::string>& words);

/// What the parser found, with the subcommand it found it in, the nearest option and where help is.
std::string describe_usage(const CLI::App& app, const CLI::ParseError& error);

/// Every `--seed` of every command takes a whole number from 0: the parser alone would take -1 for
/// 2^64 - 1.
void require_whole_seeds(CLI::App& app);

}  // namespace castaway::testbed
