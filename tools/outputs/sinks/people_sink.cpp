#include "tools/outputs/sinks/people_sink.hpp"

#include "castaway/stamp.hpp"

namespace castaway::testbed {

PeopleSink::PeopleSink(const std::filesystem::path& run_folder, double every_s)
    : csv_(run_folder / "people.csv",
           {"stamp_s", "id", "x_m", "y_m", "yaw_rad", "vx_mps", "vy_mps", "gap_m"}),
      period_(localization::from_seconds(every_s)) {}

void PeopleSink::on_scan(const ScanRecord& record) {
  if (record.stamp < next_.value_or(record.stamp)) return;
  next_ = next_.value_or(record.stamp) + period_;
  for (const PersonTruth& person : record.people.people) {
    csv_.number(seconds(record.stamp)).count(person.id).pose(person.T_map_person);
    csv_.number(person.velocity.x(), 3).number(person.velocity.y(), 3).number(person.gap_m, 3);
    csv_.end_row();
  }
}

}  // namespace castaway::testbed
