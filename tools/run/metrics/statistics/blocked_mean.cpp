#include "tools/run/metrics/statistics/blocked_mean.hpp"

#include <cmath>

#include <boost/math/distributions/students_t.hpp>

namespace castaway::testbed {

void BlockedMean::Products::add(double total, double count) {
  totals += total * total;
  mixed += total * count;
  counts += count * count;
}

void BlockedMean::add(double value, std::uint64_t block) {
  if (count_ == 0) origin_ = value;
  if (count_ == 0 || block != block_) {
    products_.add(block_total_, block_count_);
    block_ = block;
    block_total_ = 0.0;
    block_count_ = 0.0;
    ++blocks_;
  }
  block_total_ += value - origin_;
  block_count_ += 1.0;
  ++count_;
  mean_ += (value - mean_) / static_cast<double>(count_);
}

double BlockedMean::standard_error() const {
  Products all = products_;
  all.add(block_total_, block_count_);
  const double mean = mean_ - origin_;
  const double squares = all.totals - 2.0 * mean * all.mixed + mean * mean * all.counts;
  const double rounding = 1e-12 * all.totals;
  const auto blocks = static_cast<double>(blocks_);
  const double scale = blocks / (blocks - 1.0);
  return std::sqrt(scale * (squares > rounding ? squares : 0.0)) / static_cast<double>(count_);
}

std::optional<Interval> BlockedMean::interval() const {
  if (blocks_ < 2) return std::nullopt;
  const boost::math::students_t student(static_cast<double>(blocks_ - 1));
  const double half = boost::math::quantile(student, 0.975) * standard_error();
  return Interval{mean_ - half, mean_ + half};
}

double BlockedMean::p_value() const {
  if (blocks_ < 2) return 1.0;
  const double error = standard_error();
  if (error == 0.0) return mean_ == 0.0 ? 1.0 : 0.0;
  const boost::math::students_t student(static_cast<double>(blocks_ - 1));
  return 2.0 * boost::math::cdf(boost::math::complement(student, std::abs(mean_) / error));
}

}  // namespace castaway::testbed
