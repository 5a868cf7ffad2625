/// An experiment's table: the paper's figures and this run's side by side.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/campaign/paper_experiments.hpp"

namespace castaway::testbed {

/// Cells as text; every row is as long as the head.
struct TextTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// The paper's rows with a column for each localizer, then what the paper shows in figures:
/// hypotheses, and how well quality, stated probability and covariance tell right from wrong.
TextTable experiment_table(const Experiment& experiment, const nlohmann::ordered_json& summary,
                           const nlohmann::ordered_json& timing);

/// Columns padded to their widest cell, the first one left, the others right.
std::string as_text(const TextTable& table);

}  // namespace castaway::testbed
