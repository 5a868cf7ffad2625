#include "tools/commands/arguments/log_arguments.hpp"

namespace castaway::testbed {

void add_log_arguments(Command& command, std::vector<std::string>& folders,
                       LocalizerArguments& localizers) {
  command.add_option("folders", folders, "Folders that hold a log and a map").required();
  add_localizer_options(command, localizers, "mh_amcl");
}

void add_trial_options(Command& command, EvaluationConfig& config) {
  command.add_option("--starts", config.starts, "Unknown starts in each log")
      .range(0, 100000)
      .show_default();
  command.add_option("--kidnaps", config.kidnaps, "Kidnaps in each log")
      .range(0, 100000)
      .show_default();
  command.add_option("--window", config.window_s, "Length of a trial [s]")
      .range(0.1, 1e6)
      .show_default();
}

void add_align_option(Command& command, std::string& align) {
  command
      .add_option("--align", align,
                  "Poses of the scans: truth (reference poses of the log), mh_amcl, or auto (truth "
                  "where most scans have it)")
      .one_of({"auto", "truth", "mh_amcl"})
      .show_default();
}

}  // namespace castaway::testbed
