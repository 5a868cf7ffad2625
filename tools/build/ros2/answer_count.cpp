#include "tools/build/ros2/answer_count.hpp"

namespace castaway::testbed {

bool AnswerCount::is_open() const { return scan_ && !answered_ && !given_up_; }

void AnswerCount::expect(localization::Stamp scan) {
  if (is_open()) give_up();
  ++sent_;
  scan_ = scan;
  answered_ = given_up_ = false;
}

void AnswerCount::give_up() {
  ++missing_;
  given_up_ = true;
}

void AnswerCount::take(localization::Stamp stamp) {
  const bool again = newest_ && stamp == *newest_;
  newest_ = stamp;
  if (again && repeats_ > 0) {
    --repeats_;
  } else if (again) {
    ++doubled_;
  } else if (scan_ && (stamp < *scan_ || given_up_)) {
    ++late_;
  } else if (is_open()) {
    answered_ = true;
    ++in_time_;
  }
}

std::map<std::string, std::int64_t> AnswerCount::counts() const {
  return {{"sent", sent_},
          {"answered", in_time_},
          {"missing", missing_ + (is_open() ? 1 : 0)},
          {"late", late_},
          {"doubled", doubled_}};
}

}  // namespace castaway::testbed
