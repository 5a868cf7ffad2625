/// SDF files for tests.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "sim/world/sdf/load_sdf.hpp"

namespace castaway::sim {

/// A folder of worlds and models.
class SdfFiles : public testing::Test {
 protected:
  SdfFiles() {
    folder_ = std::filesystem::path(testing::TempDir()) / "castaway-sdf" /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
  }
  ~SdfFiles() override { std::filesystem::remove_all(folder_); }

  static constexpr const char* kBox = "<box><size>2 1 0.5</size></box>";

  std::string put(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  SdfWorld load(const std::string& inside, const SdfOptions& options = {}) {
    return load_sdf(put("worlds/w.world",
                        "<?xml version='1.0'?>\n<sdf version='1.6'>\n"
                        "<world name='small'>\n" +
                            inside + "</world>\n</sdf>\n"),
                    options);
  }
  static std::string link(const std::string& geometry, const std::string& pose = "0 0 0 0 0 0") {
    return "<link name='l'><pose>" + pose + "</pose><collision name='c'><geometry>" + geometry +
           "</geometry></collision></link>";
  }
  static const WorldObject& named(const SdfWorld& world, const std::string& name) {
    const auto found = std::find_if(world.spec.objects.begin(), world.spec.objects.end(),
                                    [&](const auto& object) { return object.name == name; });
    if (found == world.spec.objects.end()) throw std::runtime_error("no object " + name);
    return *found;
  }

  std::filesystem::path folder_;
};

}  // namespace castaway::sim
