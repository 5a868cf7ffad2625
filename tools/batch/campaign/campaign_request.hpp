/// What the user asks of a campaign.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/batch/campaign/finished_campaign.hpp"
#include "tools/batch/jobs/batch_request.hpp"
#include "tools/play/report_writer.hpp"
#include "tools/scenario/campaign_yaml.hpp"

namespace castaway::testbed {

/// Arguments of the command line.
struct CampaignRequest {
  std::filesystem::path spec;
  std::vector<std::string> overrides;  ///< Of the scenario, as key=value.
  FilePrograms programs = FilePrograms::kRefused;
  BatchRequest batch;
  bool json = false;                    ///< Prints summary.json instead of words.
  bool rank = false;                    ///< Ranks the keys, too.
  RenderCampaignPages pages = nullptr;  ///< Of files besides the tables.
  ReportWriter report{};                ///< Of a cell's run, where the scenario asks for one.
  std::vector<std::string> metrics;     ///< To rank by; empty: `ranked_metrics`.
};

}  // namespace castaway::testbed
