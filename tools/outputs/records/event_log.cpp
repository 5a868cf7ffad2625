#include "tools/outputs/records/event_log.hpp"

#include <algorithm>

namespace castaway::testbed {
namespace {

void add_alarms(const std::vector<MetricRow>& rows, const std::string& localizer,
                std::vector<LoggedEvent>& log) {
  bool was_lost = false;
  for (const MetricRow& row : rows) {
    if (row.lost != was_lost) {
      const RunEvent event{row.answered(),
                           row.lost ? EventKind::kAlarmOn : EventKind::kAlarmOff,
                           "",
                           row.T_map_base_true,
                           {}};
      log.push_back({event, localizer});
    }
    was_lost = row.lost;
  }
}

void add_recoveries(const LocalizerMetrics& metrics, const std::string& localizer,
                    std::vector<LoggedEvent>& log) {
  for (const RecoveryWindow& window : metrics.windows) {
    if (!window.recovered) continue;
    const std::string detail = window.unknown_start ? "from unknown start" : "from kidnap";
    RunEvent event;
    event.stamp = *window.recovered;
    event.kind = EventKind::kRecovery;
    event.detail = detail;
    log.push_back({event, localizer, seconds(*window.recovered - window.begin), window.distance_m});
  }
}

}  // namespace

std::vector<LoggedEvent> log_events(const RunHistory& history,
                                    const std::vector<LocalizerMetrics>& metrics) {
  std::vector<LoggedEvent> log;
  for (const RunEvent& event : history.events) log.push_back({event, event.localizer});
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
