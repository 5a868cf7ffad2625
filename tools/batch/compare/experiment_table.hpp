/// Table of an experiment: the paper's figures beside those of this run.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "tools/base/formats/text_table.hpp"
#include "tools/batch/compare/paper_experiments.hpp"

namespace castaway::testbed {

/// The paper's rows with a column for each localizer, followed by values that the paper only plots:
/// number of hypotheses, and how well quality, stated probability and covariance separate right
/// from wrong outputs.
TextTable experiment_table(const Experiment& experiment, const nlohmann::ordered_json& summary,
                           const nlohmann::ordered_json& timing);

}  // namespace castaway::testbed
