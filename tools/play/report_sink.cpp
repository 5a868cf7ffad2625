#include "tools/play/report_sink.hpp"

#include <utility>

#include "tools/report/report.hpp"

namespace castaway::testbed {

ReportSink::ReportSink(std::filesystem::path run_folder, RosMap map)
    : run_folder_(std::move(run_folder)), map_(std::move(map)) {}

void ReportSink::finish(Stamp, const RunTiming&) { write_report(run_folder_, map_); }

}  // namespace castaway::testbed
