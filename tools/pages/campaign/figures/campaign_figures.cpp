#include "tools/pages/campaign/figures/campaign_figures.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/pages/campaign/figures/cell_groups.hpp"

namespace castaway::testbed {
namespace {

int bin_along(double metres) {
  const double rounded = std::round(metres * 1e6) / 1e6;
  return static_cast<int>(std::floor(rounded / kBinEdge));
}

constexpr std::size_t kMostWorst = 200;
constexpr std::size_t kMostReasons = 100;
constexpr const char* kWorldKey = "world";

/// Gathers cells into figures.
class FigureGatherer {
 public:
  FigureGatherer(CampaignFigures& figures, const std::vector<std::string>& localizers,
                 std::string world)
      : figures_(figures), localizers_(localizers), world_(std::move(world)) {}

  void add_group(const std::vector<CellRow>& rows) {
    std::vector<PairedCell> cells;
    for (const CellRow& row : rows) {
      ++figures_.states[row.state];
      if (row.state == CellOutcome::kDone) {
        add_done(row, cells);
      } else {
        add_unscored(row);
      }
    }
    figures_.pairs.add(cells);
  }

 private:
  void add_unscored(const CellRow& row) {
    auto& reasons = figures_.reasons;
    if (reasons.size() >= kMostReasons && !reasons.contains(row.reason)) return;
    UnscoredCells& cells =
        reasons.try_emplace(row.reason, UnscoredCells{row.state, 0, row.index}).first->second;
    ++cells.cells;
    cells.first = std::min(cells.first, row.index);
  }

  void add_done(const CellRow& row, std::vector<PairedCell>& cells) {
    add_run_metrics(row);
    for (std::size_t k = 0; k < figures_.series.size(); ++k) {
      const CampaignSeries& series = figures_.series[k];
      if (!series.in(row)) continue;
      add_metrics(row, k);
      const auto tracking = row.metrics.find(series.localizer + "." + kTracking);
      PairedCell cell{k, row.seed, scored_kidnaps(row, series.localizer), std::nullopt};
      if (tracking != row.metrics.end()) cell.tracking_error_m = tracking->second;
      for (const ScoredKidnap& kidnap : cell.kidnaps) add_kidnap(row, k, kidnap);
      cells.push_back(std::move(cell));
    }
  }

  /// Metrics that belong to no localizer.
  void add_run_metrics(const CellRow& row) {
    for (const auto& [name, value] : row.metrics) {
      const std::string& metric = name;
      const bool of_localizer = std::any_of(
          localizers_.begin(), localizers_.end(),
          [&](const std::string& localizer) { return metric.starts_with(localizer + "."); });
      if (value && !of_localizer) figures_.figures.add(row, figures_.series.size(), name, *value);
    }
  }

  void add_metrics(const CellRow& row, std::size_t series) {
    const std::string prefix = figures_.series[series].localizer + ".";
    for (auto it = row.metrics.lower_bound(prefix);
         it != row.metrics.end() && it->first.starts_with(prefix); ++it) {
      const std::string name = it->first.substr(prefix.size());
      if (!it->second || name.ends_with("_interval") || name == kRecovered) continue;
      figures_.figures.add(row, series, name, *it->second);
    }
  }

  void add_kidnap(const CellRow& row, std::size_t series, const ScoredKidnap& kidnap) {
    figures_.figures.add_trial(row, series, kRecovered, kidnap.kidnap.recovered);
    figures_.recoveries.add(row, series, kidnap);
    const std::string* varied = value_of(row, kWorldKey);
    const std::string& world = varied == nullptr ? world_ : *varied;
    figures_.heat.add(world, series, kidnap);
    figures_.worlds.try_emplace(world, row.index);
    WorstKidnap worst{row.index, row.cell, row.seed, row.values, series, kidnap, std::nullopt};
    const auto error =
        row.metrics.find(figures_.series[series].localizer + ".position_error_m.max");
    if (error != row.metrics.end()) worst.largest_error_m = error->second;
    figures_.worst.add(std::move(worst));
  }

  CampaignFigures& figures_;
  const std::vector<std::string>& localizers_;
  std::string world_;  // Of all cells, unless it varies.
};

std::vector<CampaignSeries> series_of(const FinishedCampaign& campaign) {
  SeriesFinder finder(campaign.localizers, ValueLabels(campaign.spec));
  for (const int cell : campaign.rows.jobs()) finder.add(campaign.rows.row(cell));
  return finder.series();
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

bool WorstKidnap::operator<(const WorstKidnap& other) const {
  const auto rank = [](const WorstKidnap& each) {
    return std::tuple(-each.kidnap.lost_s, each.kidnap.kidnap.recovered,
                      -each.largest_error_m.value_or(0.0), each.cell, each.series,
                      each.kidnap.number);
  };
  return rank(*this) < rank(other);
}

void WorstKidnaps::add(WorstKidnap kidnap) {
  kidnaps_.insert(std::move(kidnap));
  if (kidnaps_.size() > most_) kidnaps_.erase(std::prev(kidnaps_.end()));
}

CampaignFigures::CampaignFigures(std::vector<CampaignSeries> of_localizers,
                                 const std::vector<KeyAxis>& axes)
    : series(std::move(of_localizers)),
      figures(axes, series.size() + 1),
      recoveries(axes, series.size()),
      pairs(series.size()),
      heat(series.size()),
      worst(kMostWorst) {}

std::vector<std::string> CampaignFigures::labels() const {
  std::vector<std::string> labels;
  for (const CampaignSeries& each : series) labels.push_back(each.label);
  labels.emplace_back("run");
  return labels;
}

int CampaignFigures::cells(CellOutcome state) const {
  const auto found = states.find(state);
  return found == states.end() ? 0 : found->second;
}

CampaignFigures gather_figures(const FinishedCampaign& campaign) {
  CampaignFigures figures(series_of(campaign), key_axes(campaign.spec, campaign.rows));
  const std::string world = campaign_cell(campaign.spec, 0).loaded.scenario.world.file;
  FigureGatherer gatherer(figures, campaign.localizers, world);
  each_cell_group(campaign.spec, campaign.rows, [&](const std::vector<int>& cells) {
    std::vector<CellRow> rows;
    for (const int cell : cells) rows.push_back(campaign.rows.row(cell));
    gatherer.add_group(rows);
  });
  return figures;
}

}  // namespace castaway::testbed
