/// Makes data sets.
#pragma once

#include <filesystem>

#include "tools/batch/cluster/slurm_batch.hpp"
#include "tools/batch/dataset/dataset_contents.hpp"
#include "tools/batch/jobs/batch_request.hpp"
#include "tools/play/report_writer.hpp"
#include "tools/scenario/dataset_yaml.hpp"

namespace castaway::testbed {

/// Arguments of the command line.
struct DatasetRequest {
  std::filesystem::path spec;
  DatasetOverrides overrides;
  int sequences = 1;
  BatchRequest batch;
  bool json = false;
  DatasetPages pages;   ///< Beside the sequences.
  ReportWriter report;  ///< Of a sequence's run, where the specification asks for one.
};

/// Makes the missing sequences of the data set in `out` and, unless other shards make some,
/// finishes the data set and prints a report. If a sequence fails or nothing can be written, prints
/// a line on stderr and returns kRunFailed; finished sequences are kept, and the same call resumes
/// with the others. Throws std::exception before anything is made if the specification is invalid
/// or `out` holds something else.
int make_dataset(const DatasetRequest& request);

/// Makes a data set on a cluster, as `follow_on_cluster` does; scripts and logs are in a folder
/// beside it, `<out>.slurm`.
int make_dataset_on_slurm(DatasetRequest request, const ClusterRequest& cluster);

}  // namespace castaway::testbed
