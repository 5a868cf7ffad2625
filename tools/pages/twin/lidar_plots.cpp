#include "tools/pages/twin/lidar_plots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tools/pages/html/plot_data.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// Dots of the log on a line of the model.
Json series_of(const PlotPoints& model, const PlotPoints& data) {
  return {point_series("model", "reference", model), point_series("log", "dots", data)};
}

Json noise_plot(const RangeNoiseFit& noise) {
  PlotPoints data;
  PlotPoints model;
  for (const RangeNoiseFit::Bin& bin : noise.bins) {
    data.emplace_back(bin.range_m, bin.sigma_m);
    model.emplace_back(bin.range_m, noise.sigma_m.value + noise.sigma_relative.value * bin.range_m);
  }
  return {{"title", "Noise of ranges"},
          {"x", {{"label", "range [m]"}}},
          {"y", {{"label", "standard deviation [m]"}}},
          {"series", series_of(model, data)},
          {"nothing", "Too few beams on straight walls."}};
}

/// Lost beams of the log, and of the model, among those at one range or incidence.
struct LossBin {
  double at = 0.0;
  double beams = 0.0;
  double lost = 0.0;
  double modelled = 0.0;
};

Json loss_plot(const LossFit& fit, const char* title, const char* label,
               double LossCell::*coordinate) {
  constexpr int kBins = 12;
  const LossShares shares{fit.dropout.value, fit.dropout_far.value, fit.dropout_grazing.value};
  std::vector<LossBin> bins(kBins);
  for (const LossCell& cell : fit.cells) {
    const int index = std::clamp(static_cast<int>(kBins * cell.*coordinate), 0, kBins - 1);
    LossBin& bin = bins[static_cast<std::size_t>(index)];
    bin.at += cell.beams * cell.*coordinate;
    bin.beams += cell.beams;
    bin.lost += cell.lost;
    bin.modelled += cell.beams * lost_share(shares, cell);
  }
  constexpr double kFewest = 50.0;  // Beams.
  PlotPoints data;
  PlotPoints model;
  for (const LossBin& bin : bins) {
    if (bin.beams < kFewest) continue;
    data.emplace_back(bin.at / bin.beams, bin.lost / bin.beams);
    model.emplace_back(bin.at / bin.beams, bin.modelled / bin.beams);
  }
  return {{"title", title},
          {"x", {{"label", label}, {"range", {0, 1}}}},
          {"y", {{"label", "share lost"}}},
          {"series", series_of(model, data)},
          {"nothing", "Too few beams on straight walls."}};
}

Json mixed_plot(const MixedFit& fit, double spacing_deg) {
  PlotPoints data;
  PlotPoints model;
  const double share = fit.divergence_deg.value / spacing_deg;
  for (const MixedFit::Bin& bin : fit.bins) {
    const double mixed = bin.step_m < fit.reach_m ? share : 0.0;
    data.emplace_back(bin.step_m, bin.mixed / bin.steps);
    model.emplace_back(bin.step_m, ((mixed + fit.other) * bin.visible + bin.other) / bin.steps);
  }
  return {{"title", "Mixed pixels: depth steps with a beam in between"},
          {"x", {{"label", "step [m]"}, {"range", {0, 8}}}},
          {"y", {{"label", "share of steps"}}},
          {"series", series_of(model, data)}};
}

Json dust_plot(const DustFit& dust) {
  PlotPoints data;
  for (const DustBin& bin : dust.bins) data.emplace_back(bin.range_m, bin.hits / bin.metres);
  const double near = dust.per_m.value + dust.other_per_m;
  const double far = std::max(dust.range_m, data.empty() ? 0.0 : data.back().first);
  const PlotPoints model{
      {0.0, near}, {dust.range_m, near}, {dust.range_m, dust.other_per_m}, {far, dust.other_per_m}};
  return {{"title", "Dust: single short returns that are not seen again"},
          {"x", {{"label", "range [m]"}}},
          {"y", {{"label", "returns per metre of beam"}}},
          {"series", series_of(model, data)},
          {"nothing", "Too few beams on straight walls."}};
}

Json offset_plot(const BeamBiasFit& fit) {
  const double widest =
      fit.means_m.empty() ? 0.0 : std::max(-fit.means_m.front(), fit.means_m.back());
  constexpr int kSteps = 60;
  PlotPoints model;
  for (int k = 0; k <= kSteps && fit.means_sigma_m > 0.0; ++k) {
    const double x = widest * (2.0 * k / kSteps - 1.0);
    model.emplace_back(x, 0.5 * std::erfc(-x / fit.means_sigma_m / std::numbers::sqrt2));
  }
  return {{"title", "Offsets of beams: their mean distance from straight surfaces"},
          {"x", {{"label", "mean residual [m]"}}},
          {"y", {{"label", "share of beams below"}, {"range", {0, 1}}}},
          {"series", series_of(model, cumulative(fit.means_m))},
          {"nothing", "Too few straight surfaces."}};
}

/// The model: below the limit as many return as did, beyond it none.
Json limit_plot(const RangeLimitFit& fit) {
  PlotPoints data;
  double beams = 0.0;
  double returned = 0.0;
  for (const RangeLimitFit::Bin& bin : fit.bins) {
    if (bin.beams < 1.0) continue;
    data.emplace_back(bin.range_m, bin.returned / bin.beams);
    if (bin.range_m > fit.limit_m.value) continue;
    beams += bin.beams;
    returned += bin.returned;
  }
  const double limit = fit.limit_m.value;
  const double within = beams > 0.0 ? returned / beams : 1.0;
  const double far = std::max(limit, data.empty() ? 0.0 : data.back().first);
  return {{"title", "Maximum range: walls that return beams"},
          {"x", {{"label", "range of the map's wall [m]"}}},
          {"y", {{"label", "share returned"}, {"range", {0, 1}}}},
          {"series", series_of({{0.0, within}, {limit, within}, {limit, 0.0}, {far, 0.0}}, data)}};
}

}  // namespace

Json lidar_plots(const FittedLog& fitted) {
  Json plots = Json::array();
  const LogFit& fit = fitted.fit;
  if (fit.noise) plots.push_back(noise_plot(*fit.noise));
  if (fit.loss) {
    plots.push_back(loss_plot(*fit.loss, "Lost beams by range", "range / maximum range",
                              &LossCell::range_per_max));
    plots.push_back(loss_plot(*fit.loss, "Lost beams by incidence",
                              "cosine of the angle of incidence", &LossCell::cosine));
  }
  if (fit.mixed) {
    const double increment = std::abs(fitted.log.scans.front().scan.angle_increment);
    plots.push_back(mixed_plot(*fit.mixed, increment * 180.0 / std::numbers::pi));
  }
  if (fit.dust) plots.push_back(dust_plot(*fit.dust));
  if (fit.beam_bias) plots.push_back(offset_plot(*fit.beam_bias));
  if (fit.range_limit) plots.push_back(limit_plot(*fit.range_limit));
  return plots;
}

}  // namespace castaway::testbed
