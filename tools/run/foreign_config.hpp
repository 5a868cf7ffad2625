/// Settings of localizers that are not castaway's own.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace castaway::localization {
class Localizer;
}

namespace castaway::testbed {

struct Greeting;

/// A localizer that runs as a program and is spoken to over its standard input and output
/// (docs/protocol.md).
struct ProgramConfig {
  std::vector<std::string> command;   ///< The program and its arguments; no shell reads them.
  std::string params = "{}";          ///< JSON object, passed to the program as it is.
  double timeout_s = 10.0;            ///< [s] Wall time for the answer to a scan.
  double start_timeout_s = 60.0;      ///< [s] The same for the answer to `hello`.
  std::filesystem::path folder = {};  ///< Of the scenario: files of the command may lie there.
};

/// A localizer in a shared library with the interface of castaway/localizer.h.
struct LibraryConfig {
  std::string library;                ///< File.
  std::string params = "{}";          ///< JSON object, passed to the library as text.
  std::filesystem::path folder = {};  ///< Of the scenario: the file may lie there.
};

/// A localizer that the program around castaway provides: an object of Python or C++.
struct OwnConfig {
  /// Makes the localizer of a run; empty in a scenario's file, where there is no such program.
  std::function<std::unique_ptr<localization::Localizer>(const Greeting& greeting)> make = {};
};

/// The file that `text` names: as it is, or in `folder` if there is none and `folder` has one.
std::string find_beside(const std::string& text, const std::filesystem::path& folder);

}  // namespace castaway::testbed
