#include "tools/outputs/records/thinned_sample.hpp"

#include <algorithm>

namespace castaway::testbed {

void ThinnedSample::add(double value) {
  sum_ += value;
  max_ = count_ == 0 ? value : std::max(max_, value);
  if (count_++ % stride_ != 0) return;
  values_.push_back(value);
  if (values_.size() <= most_) return;
  for (std::size_t i = 0; 2 * i < values_.size(); ++i) values_[i] = values_[2 * i];
  values_.resize((values_.size() + 1) / 2);
  stride_ *= 2;
}

}  // namespace castaway::testbed
