/// Campaigns with made-up rows for tests.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/batch/campaign/finished_campaign.hpp"

namespace castaway::testbed {

/// A scored kidnap; recovered if it has a time. [s], [m]
inline CellKidnap kidnap_of(const std::string& localizer, double at_s, std::optional<double> time_s,
                            std::optional<SE2> to = SE2{1.5, 2.5, 0.0}) {
  return {localizer, "teleport", at_s, to, true, time_s.has_value(), time_s};
}

/// A folder with a specification and rows. A test may have several.
class CampaignOfRows {
 public:
  explicit CampaignOfRows(const std::string& text) : folder_(next_folder()) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "s.yaml", std::ios::binary) << text;
    spec_ = load_campaign_spec(folder_ / "s.yaml", FilePrograms::kRefused);
  }
  ~CampaignOfRows() { std::filesystem::remove_all(folder_); }
  CampaignOfRows(const CampaignOfRows&) = delete;
  CampaignOfRows& operator=(const CampaignOfRows&) = delete;

  /// The row of a cell that is done, with its seed, grid and drawn values.
  [[nodiscard]] CellRow row(int index) const {
    CellRow row;
    row.index = index;
    row.cell = "0123456789abcdef";
    row.seed = cell_seed(spec_, index);
    row.values = combination_values(spec_, index / spec_.samples());
    for (const DrawnKey& key : spec_.drawn) {
      row.values.emplace_back(key.path, std::to_string(index % spec_.samples()));
    }
    row.metrics["duration_s"] = 20.0;
    row.cpu_s = 0.5;
    row.memory_mb = 40.0;
    return row;
  }
  /// Adds such a row for every cell.
  void add_all() {
    for (int i = 0; i < spec_.cells(); ++i) add(row(i));
  }
  void add(const CellRow& row) { RowsFile(folder_ / "rows.jsonl").add(row_text(row)); }

  [[nodiscard]] const CampaignSpec& spec() const { return spec_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] CellRows& rows() {
    if (!rows_) rows_ = std::make_unique<CellRows>(folder_, spec_.cells());
    return *rows_;
  }
  /// With localizers "a" and "b".
  [[nodiscard]] FinishedCampaign finished() {
    return {spec_, overrides, localizers, checks, folder_, rows()};
  }

  std::vector<std::string> overrides;
  std::vector<std::string> localizers{"a", "b"};
  std::vector<Check> checks;

 private:
  static std::filesystem::path next_folder() {
    static int made = 0;
    return std::filesystem::path(testing::TempDir()) /
           ("castaway-campaign-" + std::to_string(::getpid()) + "-" + std::to_string(++made));
  }

  std::filesystem::path folder_;
  CampaignSpec spec_;
  std::unique_ptr<CellRows> rows_;
};

}  // namespace castaway::testbed
