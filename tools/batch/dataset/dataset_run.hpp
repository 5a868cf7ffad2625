/// Makes data sets.
#pragma once

#include <filesystem>

#include "tools/batch/dataset/dataset_contents.hpp"
#include "tools/play/report_writer.hpp"
#include "tools/scenario/dataset_yaml.hpp"

namespace castaway::testbed {

/// Arguments of the command line.
struct DatasetRequest {
  std::filesystem::path spec;
  DatasetOverrides overrides;
  int sequences = 1;
  int workers = 1;
  std::filesystem::path out;
  bool json = false;
  DatasetPages pages;   ///< Beside the sequences.
  ReportWriter report;  ///< Of a sequence's run, where the specification asks for one.
};

/// Makes the missing sequences of the data set in `out`, finishes the data set and prints a report.
/// If a sequence fails or nothing can be written, prints a line on stderr and returns kRunFailed;
/// finished sequences are kept, and the same call resumes with the others. Throws std::exception
/// before anything is made if the specification is invalid or `out` holds something else.
int make_dataset(const DatasetRequest& request);

}  // namespace castaway::testbed
