#include "tools/pages/runs/recoveries_section.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/outputs/pictures/localizer_styles.hpp"
#include "tools/outputs/records/summary_kidnaps.hpp"
#include "tools/pages/html/line_chart.hpp"
#include "tools/run/metrics/statistics/survival.hpp"

namespace castaway::testbed {
namespace {

constexpr double kPercent = 100.0;

Survival times_of(const RunSet& set, const std::string& localizer) {
  Survival times;
  for (const SetRun& run : set.runs) {
    if (run.is_void) continue;
    for (const SummaryKidnap& kidnap : summary_kidnaps(run.summary, localizer)) {
      if (kidnap.scored) times.add(kidnap.lost_s, kidnap.recovered);
    }
  }
  return times;
}

void add_corner(double time_s, double survival, const Interval& interval, ChartLine& line) {
  line.points.emplace_back(time_s, kPercent * (1.0 - survival));
  line.low.emplace_back(kPercent * (1.0 - interval.high));
  line.high.emplace_back(kPercent * (1.0 - interval.low));
}

/// Stairs of the share that has recovered, to the end of the observation.
ChartLine recovery_stairs(const std::string& localizer, std::size_t style, const Survival& times) {
  ChartLine line{fmt::format("{}: {} of {}", localizer, times.events(), times.size()), style, {}};
  SurvivalStep last{0.0, times.size(), 0, 1.0, {1.0, 1.0}};
  add_corner(0.0, 1.0, last.interval, line);
  for (const SurvivalStep& step : times.steps()) {
    add_corner(step.time_s, last.survival, last.interval, line);
    add_corner(step.time_s, step.survival, step.interval, line);
    last = step;
  }
  add_corner(std::max(times.longest_s(), last.time_s), last.survival, last.interval, line);
  return line;
}

}  // namespace

std::string recoveries_chart(const RunSet& set) {
  const std::vector<std::size_t> styles = localizer_styles(set.localizers);
  LineChart chart{"Share of kidnaps recovered from over time",
                  {"time since the kidnap [s]", 1.0},
                  {"recovered [%]", kPercent},
                  {}};
  for (std::size_t i = 0; i < set.localizers.size(); ++i) {
    const Survival times = times_of(set, set.localizers[i]);
    if (times.size() == 0) continue;
    chart.x.most = std::max(chart.x.most, times.longest_s());
    chart.lines.push_back(recovery_stairs(set.localizers[i], styles[i], times));
  }
  return chart.lines.empty() ? "" : line_chart_html(chart);
}

}  // namespace castaway::testbed
