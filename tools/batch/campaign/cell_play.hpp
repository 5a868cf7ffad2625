/// Plays the cells of a campaign.
#pragma once

#include <filesystem>

#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/batch/campaign/cell_row.hpp"
#include "tools/build/shared_models.hpp"
#include "tools/build/shared_worlds.hpp"
#include "tools/play/report_writer.hpp"

namespace castaway::testbed {

/// What the cells of one process have in common.
struct PartsOfCells {
  ReportWriter report;  ///< Of a run, where the scenario asks for one.
  SharedWorlds worlds{};
  SharedModels models{};
};

/// Simulates a cell. Its run folder is made as `draft`; what the specification keeps of it is moved
/// to `kept`, the rest is removed. Errors of the run are in the row. `parts`: of this process.
/// Throws Interrupted after a signal, FileError if nothing can be written.
CellRow play_cell(const CampaignSpec& spec, const CampaignCell& cell,
                  const std::filesystem::path& draft, const std::filesystem::path& kept,
                  PartsOfCells& parts);

/// The row of a cell that has no run, because of `reason`.
CellRow failed_row(const CampaignCell& cell, const std::string& reason);

}  // namespace castaway::testbed
