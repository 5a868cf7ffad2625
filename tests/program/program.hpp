/// Runs the program like a user.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::test {

namespace fs = std::filesystem;

/// Result of running a command.
struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

inline std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// "Suite.Name", with slashes replaced.
inline std::string suite_and_name(const testing::TestInfo& info) {
  std::string text = std::string(info.test_suite_name()) + "." + info.name();
  for (char& c : text) c = c == '/' ? '.' : c;
  return text;
}

/// A path without its ending as the name of a test: "lab_scenarios_kidnap".
inline std::string path_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param.substr(0, info.param.find('.'));
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

/// An empty folder for the current test.
inline fs::path fresh_folder() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder =
      fs::path(testing::TempDir()) / "castaway-program" / (suite_and_name(*info));
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// Runs `castaway <arguments>` in `folder`; `environment` precedes the command, e.g. "A=b".
inline Outcome castaway(const fs::path& folder, const std::string& arguments,
                        const std::string& environment = "") {
  const fs::path out = folder / "stdout.txt";
  const fs::path err = folder / "stderr.txt";
  const std::string command = "cd '" + folder.string() + "' && " + environment + " '" +
                              CASTAWAY_PROGRAM + "' " + arguments + " >'" + out.string() + "' 2>'" +
                              err.string() + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

inline void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "missing: " << part << "\nin: " << text;
}

/// A Python that has a module: that of PATH, or Debian's; empty: none.
inline std::string python_with(const std::string& module) {
  for (const std::string python : {"python3", "/usr/bin/python3"}) {
    const std::string test = python + " -c 'import " + module + "' 2>/dev/null";
    if (std::system(test.c_str()) == 0) return python;
  }
  return "";
}

/// Expects one line on stderr that contains every part, and exit code 2.
inline void expect_refused(const Outcome& outcome, const std::vector<std::string>& parts) {
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  for (const std::string& part : parts) expect_contains(outcome.err, part);
}

/// Writes a file and creates its folders.
inline void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace castaway::test
