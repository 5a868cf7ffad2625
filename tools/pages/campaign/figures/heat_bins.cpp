#include "tools/pages/campaign/figures/heat_bins.hpp"

#include <cmath>

namespace castaway::testbed {
namespace {

int bin_along(double metres) {
  const double rounded = std::round(metres * 1e6) / 1e6;
  return static_cast<int>(std::floor(rounded / kBinEdge));
}

}  // namespace

BinNumber bin_of(double x, double y) { return {bin_along(x), bin_along(y)}; }

double HeatBin::failure_share() const {
  return kidnaps == 0 ? 0.0 : static_cast<double>(failures) / kidnaps;
}

void HeatMap::add(const std::string& world, std::size_t series, const ScoredKidnap& kidnap) {
  const std::optional<SE2>& target = kidnap.kidnap.T_map_to;
  if (!target) {
    ++without_target_;
    return;
  }
  std::vector<HeatBins>& of_world = worlds_.try_emplace(world, series_).first->second;
  HeatBin& bin = of_world[series][bin_of(target->x, target->y)];
  ++bin.kidnaps;
  bin.failures += kidnap.kidnap.recovered ? 0 : 1;
  bin.times.add(kidnap.lost_s, kidnap.kidnap.recovered);
}

std::vector<std::string> HeatMap::worlds() const {
  std::vector<std::string> names;
  for (const auto& [name, bins] : worlds_) names.push_back(name);
  return names;
}

const HeatBins& HeatMap::bins(const std::string& world, std::size_t series) const {
  return worlds_.at(world).at(series);
}

}  // namespace castaway::testbed
