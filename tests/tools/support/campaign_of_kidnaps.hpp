/// A small campaign with two localizers for tests of its page.
#pragma once

#include "tests/tools/support/campaign_rows.hpp"

namespace castaway::testbed {

/// Two values of a key, three seeds; "a" recovers after 1, 2, 3, ... s, "b" from every second
/// kidnap after 4 s.
inline std::unique_ptr<CampaignOfRows> campaign_of_kidnaps(const std::string& more = "") {
  auto campaign = std::make_unique<CampaignOfRows>(
      "name: <mine>\nscenario: {world: lab}\ngrid: {people.count: [0, 2]}\nseeds: 3\n" + more);
  for (int i = 0; i < 6; ++i) {
    CellRow row = campaign->row(i);
    const SE2 to{0.5 + i, 2.5, 0.0};
    const auto b_time = i % 2 == 0 ? std::optional(4.0) : std::nullopt;
    row.kidnaps = {kidnap_of("a", 5.0, 1.0 + i, to), kidnap_of("b", 5.0, b_time, to)};
    row.metrics["a.tracking_error_m.mean"] = 0.1 + 0.01 * i;
    row.metrics["b.tracking_error_m.mean"] = 0.3;
    row.metrics["a.position_error_m.max"] = 2.0;
    row.cpu_s = 1.0 + i;
    campaign->add(row);
  }
  return campaign;
}

/// The same specification, in which every cell failed.
inline std::unique_ptr<CampaignOfRows> campaign_of_failures() {
  auto campaign =
      std::make_unique<CampaignOfRows>("scenario: {world: lab}\ngrid: {people.count: [0, 2]}\n");
  for (int i = 0; i < 2; ++i) {
    CellRow row = campaign->row(i);
    row.metrics.clear();
    row.state = CellOutcome::kFailed;
    row.reason = "the <program> died";
    campaign->add(row);
  }
  return campaign;
}

/// How often `part` is in `text`.
inline int times_in(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

}  // namespace castaway::testbed
