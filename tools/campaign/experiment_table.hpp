/// Table of an experiment: the paper's figures beside those of this run.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/campaign/paper_experiments.hpp"

namespace castaway::testbed {

/// Cells as text; every row has as many cells as the head.
struct TextTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// The paper's rows with a column for each localizer, followed by values that the paper only plots:
/// number of hypotheses, and how well quality, stated probability and covariance separate right
/// from wrong outputs.
TextTable experiment_table(const Experiment& experiment, const nlohmann::ordered_json& summary,
                           const nlohmann::ordered_json& timing);

/// Columns are padded to their widest cell; the first is left-aligned, the others right-aligned.
std::string as_text(const TextTable& table);

}  // namespace castaway::testbed
