/// What a page of several runs shows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/run/metrics/verdict.hpp"

namespace castaway::testbed {

/// The runs of a page.
struct ShownRuns {
  std::vector<std::filesystem::path> folders;  ///< With summary.json.
  std::filesystem::path page;                  ///< Reports are linked by paths relative to it.
  std::vector<std::uint64_t> failed_seeds{};   ///< Their runs left no summary.
  std::vector<Check> checks{};                 ///< Of expectations; those of clocks are not shown.
};

/// Renders the page.
using RunsPageRenderer = std::function<std::string(const ShownRuns&)>;

}  // namespace castaway::testbed
