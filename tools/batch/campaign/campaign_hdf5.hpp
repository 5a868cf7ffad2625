/// The tables of a campaign as HDF5.
#pragma once

#include <filesystem>

#include "tools/batch/campaign/cell_row.hpp"
#include "tools/scenario/campaign_yaml.hpp"

namespace castaway::testbed {

/// Writes results.h5, with the rows of results.csv and kidnaps.csv in their order:
///
///     /combinations/<key>      texts: the values of the grid's keys, by combination
///     /cells/cell, combination, seed, state     state: 0 done, 1 void, 2 failed
///     /cells/drawn             a column for each drawn key; NaN where it is no number
///     /cells/drawn_keys        texts: the names of these columns
///     /cells/metrics           a column for each metric; NaN where there was nothing to measure
///     /cells/metric_names      texts: the names of these columns
///     /kidnaps/cell, localizer, kind, at_s, to (x, y, yaw), scored, recovered, time_s
///     /kidnaps/localizers, kinds                texts: what localizer and kind count
///
/// Throws FileError if the file cannot be written.
void write_hdf5(const CampaignSpec& spec, CellRows& rows, const std::filesystem::path& file);

}  // namespace castaway::testbed
