#include "tools/outputs/records/event_log.hpp"

#include <algorithm>

namespace castaway::testbed {
namespace {

void add_alarms(const std::vector<MetricRow>& rows, const std::string& localizer,
                std::vector<LoggedEvent>& log) {
  bool was_lost = false;
  for (const MetricRow& row : rows) {
    if (row.lost != was_lost) {
      log.push_back(
          {{row.answered(), AlarmEvent{row.lost, localizer}, row.T_map_base_true}, {}, {}});
    }
    was_lost = row.lost;
  }
}

void add_recoveries(const LocalizerMetrics& metrics, const std::string& localizer,
                    std::vector<LoggedEvent>& log) {
  for (const RecoveryWindow& window : metrics.windows) {
    if (!window.recovered) continue;
    using From = RecoveryEvent::From;
    const RecoveryEvent recovery{window.unknown_start ? From::kStart : From::kKidnap, localizer};
    log.push_back({{*window.recovered, recovery},
                   seconds(*window.recovered - window.begin),
                   window.distance_m});
  }
}

}  // namespace

std::vector<LoggedEvent> log_events(const RunHistory& history,
                                    const std::vector<LocalizerMetrics>& metrics) {
  std::vector<LoggedEvent> log;
  for (const RunEvent& event : history.events) log.push_back({event, {}, {}});
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    add_alarms(history.rows[i], history.info.localizers[i], log);
    add_recoveries(metrics[i], history.info.localizers[i], log);
  }
  std::stable_sort(log.begin(), log.end(), [](const LoggedEvent& a, const LoggedEvent& b) {
    return a.event.stamp < b.event.stamp;
  });
  return log;
}

}  // namespace castaway::testbed
