/// A temporary folder of robot files.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace castaway {

/// Removed after the test. Its path contains the test's name.
class RobotFiles : public testing::Test {
 protected:
  RobotFiles() { std::filesystem::remove_all(root_); }
  ~RobotFiles() override { std::filesystem::remove_all(root_); }

  /// Writes a file and returns its path.
  std::string write(const std::string& path, const std::string& text) const {
    std::filesystem::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path, std::ios::binary) << text;
    return at(path);
  }
  [[nodiscard]] std::string at(const std::string& path) const { return (root_ / path).string(); }

 private:
  static std::string test_name() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(info->test_suite_name()) + "_" + info->name();
    for (char& c : name) c = c == '/' ? '_' : c;
    return name;
  }

  std::filesystem::path root_ = std::filesystem::canonical(std::filesystem::temp_directory_path()) /
                                ("castaway_" + test_name());
};

/// Text of the exception that a call throws; "" if it throws none.
template <typename Call>
std::string error_text(Call call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace castaway
