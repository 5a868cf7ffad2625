#include "tools/ros2/answer_count.hpp"

namespace castaway::testbed {

void AnswerCount::expect(localization::Stamp scan) {
  ++sent_;
  scan_ = scan;
  answered_ = false;
}

void AnswerCount::take(localization::Stamp stamp) {
  const bool again = newest_ && stamp == *newest_;
  newest_ = stamp;
  if (again) {
    ++doubled_;
  } else if (scan_ && stamp < *scan_) {
    ++late_;
  } else if (scan_ && !answered_) {
    answered_ = true;
    ++in_time_;
  }
}

std::map<std::string, std::int64_t> AnswerCount::counts() const {
  return {{"sent", sent_},
          {"answered", in_time_},
          {"missing", missing_},
          {"late", late_},
          {"doubled", doubled_}};
}

}  // namespace castaway::testbed
