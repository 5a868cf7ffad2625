#include "tools/scenario/sample_design.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/random/sobol.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

using localization::Rng;

double draw_unit(Rng& rng) {
  return boost::random::uniform_real_distribution<double>(0.0, 1.0)(rng);
}

/// A random order of 0 to count - 1.
std::vector<int> draw_order(int count, Rng& rng) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    boost::random::uniform_int_distribution<std::size_t> any(0, i - 1);
    std::swap(order[i - 1], order[any(rng)]);
  }
  return order;
}

std::vector<double> latin_hypercube(std::uint64_t root, int seeds,
                                    const std::vector<std::string>& keys) {
  std::vector<double> points(static_cast<std::size_t>(seeds) * keys.size());
  for (std::size_t k = 0; k < keys.size(); ++k) {
    Rng rng = localization::substream(root, "latin/" + keys[k]);
    const std::vector<int> strata = draw_order(seeds, rng);
    for (std::size_t i = 0; i < strata.size(); ++i) {
      points[i * keys.size() + k] = (strata[i] + draw_unit(rng)) / seeds;
    }
  }
  return points;
}

/// Points of a shifted Sobol sequence, by seed and then by dimension.
std::vector<double> sobol_points(std::uint64_t root, int seeds,
                                 const std::vector<std::string>& dimensions) {
  if (dimensions.empty()) return {};
  std::vector<double> shifts;
  for (const std::string& name : dimensions) {
    Rng rng = localization::substream(root, "sobol/" + name);
    shifts.push_back(draw_unit(rng));
  }
  boost::random::sobol sequence(dimensions.size());
  std::vector<double> points(static_cast<std::size_t>(seeds) * dimensions.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double even = std::ldexp(static_cast<double>(sequence()), -64);
    const double shifted = even + shifts[i % dimensions.size()];
    points[i] = shifted - std::floor(shifted);
  }
  return points;
}

std::vector<std::string> twice(const std::vector<std::string>& keys) {
  std::vector<std::string> both = keys;
  for (const std::string& key : keys) both.push_back("second/" + key);
  return both;
}

}  // namespace

const std::vector<std::string> kDesignNames{"independent", "latin_hypercube", "sobol", "saltelli"};

SampleDesign::SampleDesign(Design design, std::uint64_t root, int seeds,
                           const std::vector<std::string>& keys)
    : design_(design), seeds_(seeds), keys_(keys.size()) {
  if (design == Design::kLatinHypercube) quantiles_ = latin_hypercube(root, seeds, keys);
  if (design == Design::kSobol) quantiles_ = sobol_points(root, seeds, keys);
  if (design == Design::kSaltelli) quantiles_ = sobol_points(root, seeds, twice(keys));
}

int SampleDesign::samples() const {
  return design_ == Design::kSaltelli ? seeds_ * static_cast<int>(keys_ + 3) : seeds_;
}

bool SampleDesign::from_second(std::size_t block, std::size_t key) const {
  return block == 1 || block == key + 2;
}

int SampleDesign::seed_offset(int sample) const {
  const int within = sample % seeds_;
  return from_second(block(sample), keys_) ? within + seeds_ : within;
}

double SampleDesign::quantile(int sample, std::size_t key) const {
  const auto within = static_cast<std::size_t>(sample % seeds_);
  const std::size_t width = design_ == Design::kSaltelli ? 2 * keys_ : keys_;
  const std::size_t column = from_second(block(sample), key) ? keys_ + key : key;
  return quantiles_[within * width + column];
}

}  // namespace castaway::testbed
