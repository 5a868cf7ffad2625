#include "tools/batch/evaluate/rows_sink.hpp"

namespace castaway::testbed {
namespace {

RunInfo one_localizer() {
  RunInfo info;
  info.localizers = {"localizer"};
  return info;
}

}  // namespace

RowsSink::RowsSink(RowsOfRun& rows) : rows_(rows), history_(one_localizer()) {}

void RowsSink::on_scan(const ScanRecord& record) {
  history_.add(record);
  rows_.update_ms.push_back(
      std::chrono::duration<double, std::milli>(record.localizers.at(0).update_cpu).count());
}

void RowsSink::finish(Stamp end, const RunTiming&) {
  rows_.rows = history_.rows.at(0);
  rows_.events = history_.events;
  rows_.end = end;
}

}  // namespace castaway::testbed
