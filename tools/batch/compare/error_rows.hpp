/// Reads errors.csv, from which an experiment is summarised.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace castaway::testbed {

/// A scan and a localizer's output for it.
struct ErrorRow {
  double stamp_s = 0.0;
  std::optional<double> error_m;
  double quality = 0.0;
  double sigma_m = 0.0;
  double probability = 0.0;
  double populations = 0.0;
};

/// Rows of one localizer, sorted by time.
struct LocalizerRows {
  std::string localizer;
  std::vector<ErrorRow> rows;
};

/// Reads errors.csv of a run folder; localizers are in the order in which they appear. Throws
/// std::runtime_error naming the file.
std::vector<LocalizerRows> read_error_rows(const std::filesystem::path& run_folder);

}  // namespace castaway::testbed
