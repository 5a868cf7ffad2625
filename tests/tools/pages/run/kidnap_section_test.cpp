#include "tools/pages/run/kidnap_section.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

Json window_at(double at_s, const Json& time_s, bool scored = true) {
  return {{"kind", "teleport"},
          {"taken_s", at_s},
          {"at_s", at_s},
          {"scored", scored},
          {"recovered", time_s.is_number()},
          {"time_s", time_s}};
}

ReportEvent kidnap_event(double at_s, const localization::SE2& from, const localization::SE2& to) {
  ReportEvent event;
  event.stamp_s = at_s;
  event.what = KidnapEvent{"<teleport>"};
  event.T_map_from = from;
  event.T_map_to = to;
  return event;
}

/// Kidnaps at 5 and 20 s; "a" recovers from both, "<b>" from none of those given.
RunFolder kidnapped_run(const Json& first_of_b, const Json& second_of_b) {
  RunFolder run;
  run.summary = {{"duration_s", 40.0}, {"truth_share", 1.0}};
  run.summary["localizers"]["a"]["recovery"]["each"] = {window_at(5.0, 0.5), window_at(20.0, 1.25)};
  run.summary["localizers"]["<b>"]["recovery"]["each"] = {first_of_b, second_of_b};
  run.events = {kidnap_event(5.0, {0.0, 0.0, 0.0}, {3.0, -4.0, 1.0}),
                kidnap_event(20.0, {1.0, 1.0, 0.0}, {1.0, 3.5, 0.0})};
  return run;
}

RunFolder quiet_run() {
  RunFolder run;
  run.summary["localizers"] = Json::object();
  return run;
}

TEST(KidnapSection, HasARowForEachKidnapAndAColumnForEachLocalizer) {
  const std::string html =
      kidnap_section(kidnapped_run(window_at(5.0, 2.0), window_at(20.0, nullptr)));
  EXPECT_TRUE(contains(html, "&lt;b&gt;</th></tr>"));
  EXPECT_TRUE(contains(html,
                       "<tr data-time=\"5.000\"><td>5.00 s</td>"
                       "<td data-head=\"kidnap\"><span>&lt;teleport&gt;</span></td>"
                       "<td data-head=\"from [m]\"><span>(0.00, 0.00)</span></td>"
                       "<td data-head=\"to [m]\"><span>(3.00, -4.00)</span></td>"
                       "<td data-head=\"distance\"><span>5.00 m</span></td>"
                       "<td data-head=\"a\"><span>0.500 s</span></td>"
                       "<td data-head=\"&lt;b&gt;\"><span>2.00 s</span></td></tr>"));
  EXPECT_TRUE(contains(html, "<span>2.50 m</span></td><td data-head=\"a\"><span>1.25 s</span>"));
  EXPECT_TRUE(
      contains(html, "<span><span class=\"bad\">not recovered</span>, lost for 20.0 s</span>"));
}

TEST(KidnapSection, SaysWhatIsNotScoredAndListsUnknownStarts) {
  RunFolder run = kidnapped_run(window_at(5.0, 2.0), window_at(20.0, nullptr, false));
  Json start = window_at(0.1, 1.0);
  start["kind"] = "start";
  run.summary["localizers"]["a"]["recovery"]["each"].insert(
      run.summary["localizers"]["a"]["recovery"]["each"].begin(), start);
  const std::string html = kidnap_section(run);
  EXPECT_TRUE(contains(html, "<span><span class=\"soft\">not scored</span></span></td></tr>"));
  EXPECT_LT(html.find("unknown start"), html.find("data-time=\"5.000\""));
  EXPECT_EQ(kidnap_section(quiet_run()), "");
}

TEST(OpeningTime, IsThatOfTheFirstFailureElseOfTheFirstKidnap) {
  EXPECT_EQ(opening_time(kidnapped_run(window_at(5.0, 2.0), window_at(20.0, nullptr))), 20.0);
  EXPECT_EQ(opening_time(kidnapped_run(window_at(5.0, nullptr), window_at(20.0, nullptr))), 5.0);
  EXPECT_EQ(opening_time(kidnapped_run(window_at(5.0, 2.0), window_at(20.0, nullptr, false))), 5.0);
  EXPECT_FALSE(opening_time(quiet_run()));
}

}  // namespace
}  // namespace castaway::testbed
