#include "tools/pages/run/thinned_curve.hpp"

#include <utility>

namespace castaway::testbed {
namespace {

/// The more informative row: a row without an error (the localizer had no output), else the larger
/// error.
const ReportRow& more_informative(const ReportRow& a, const ReportRow& b) {
  if (!a.position_error_m || !b.position_error_m) return a.position_error_m ? b : a;
  return *b.position_error_m > *a.position_error_m ? b : a;
}

}  // namespace

void ThinnedCurve::add(const ReportRow& row) {
  if (open_ == 0 || open_ == stride_) {
    if (rows_.size() >= most_) halve();
    rows_.push_back(row);
    open_ = 1;
    return;
  }
  rows_.back() = ReportRow(more_informative(rows_.back(), row));
  ++open_;
}

void ThinnedCurve::halve() {
  std::vector<ReportRow> half;
  half.reserve(most_);
  for (std::size_t i = 0; i + 1 < rows_.size(); i += 2) {
    half.push_back(more_informative(rows_[i], rows_[i + 1]));
  }
  if (rows_.size() % 2 != 0) half.push_back(rows_.back());
  rows_ = std::move(half);
  stride_ *= 2;
}

std::vector<ReportRow> ThinnedCurve::take() { return std::move(rows_); }

}  // namespace castaway::testbed
