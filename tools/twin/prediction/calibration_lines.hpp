/// The figures of a calibration, line by line, for terminal and page.
#pragma once

#include <string>
#include <vector>

#include "tools/twin/twin_folder.hpp"

namespace castaway::testbed {

/// A line of the table: a figure in the unit shown, or a sentence.
struct CalibrationLine {
  std::string name;
  std::string value;     ///< With its unit; of a line without a figure, the sentence.
  std::string interval;  ///< 95 %; empty if there is none.
};

/// Lines under one heading.
struct CalibrationGroup {
  std::string heading;
  std::vector<CalibrationLine> lines;
};

/// Everything that was fitted, and what could not be.
std::vector<CalibrationGroup> calibration_groups(const Twin& twin);

/// How the log was aligned, in a sentence.
std::string alignment_sentence(const AlignedLog& log);

}  // namespace castaway::testbed
