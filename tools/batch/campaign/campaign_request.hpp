/// What the user asks of a campaign.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/batch/campaign/finished_campaign.hpp"
#include "tools/play/report_writer.hpp"
#include "tools/scenario/campaign_yaml.hpp"

namespace castaway::testbed {

/// Arguments of the command line.
struct CampaignRequest {
  std::filesystem::path spec;
  std::vector<std::string> overrides;  ///< Of the scenario, as key=value.
  FilePrograms programs = FilePrograms::kRefused;
  std::filesystem::path out;
  int workers = 1;
  int shard = 1;   ///< This process makes every `shards`-th cell, from this one on.
  int shards = 1;  ///< How many processes share the cells.
  bool retry_failed = false;
  bool json = false;                    ///< Prints summary.json instead of words.
  bool rank = false;                    ///< Ranks the keys, too.
  RenderCampaignPages pages = nullptr;  ///< Of files besides the tables.
  ReportWriter report{};                ///< Of a cell's run, where the scenario asks for one.
  std::vector<std::string> metrics;     ///< To rank by; empty: `ranked_metrics`.
};

/// The shard, from 1 on, that makes a cell. With `until` a combination stays with one shard, which
/// decides how many cells it needs.
int shard_of(const CampaignSpec& spec, int cell, int shards);

/// Parses "3/8". Throws std::invalid_argument.
void parse_shard(const std::string& text, CampaignRequest& request);

}  // namespace castaway::testbed
