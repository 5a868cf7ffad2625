/// Makes campaigns.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/scenario/campaign_spec.hpp"

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
  bool json = false;  ///< Prints summary.json instead of words.
};

/// Parses "3/8". Throws std::invalid_argument.
void parse_shard(const std::string& text, CampaignRequest& request);

/// Makes the missing cells of the campaign in `out` and, unless other shards make the rest, its
/// tables. Returns kDone; kRunFailed if a cell failed; kExpectationNotMet if an expectation was not
/// met. Throws std::exception before anything is made if the specification is invalid or `out`
/// holds something else; Interrupted after a signal, and the same call goes on.
int make_campaign(const CampaignRequest& request);

/// Makes the tables of a campaign whose shards are done. Returns as `make_campaign`; names the
/// cells that are missing and returns kRunFailed if there are any.
int collect_campaign(const CampaignRequest& request);

/// Plays one cell again, in full, as the run folder `out`. Returns as `play`.
int make_cell(const CampaignRequest& request, int index);

}  // namespace castaway::testbed
