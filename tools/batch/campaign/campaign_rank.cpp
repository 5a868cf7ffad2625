#include "tools/batch/campaign/campaign_rank.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/formats/csv.hpp"

namespace castaway::testbed {
namespace {

/// The metric in a cell; nothing if the cell does not count.
std::optional<double> value_in(CellRows& rows, int cell, const std::string& metric) {
  if (!rows.has(cell)) return std::nullopt;
  const CellRow row = rows.row(cell);
  const auto found = row.metrics.find(metric);
  if (row.state != CellOutcome::kDone || found == row.metrics.end()) return std::nullopt;
  return found->second;
}

/// Values by group, then by seed; seeds that any group lacks are left out.
using Groups = std::vector<std::vector<double>>;

/// `cell_of(group, seed)`
template <typename CellOf>
Groups take_groups(CellRows& rows, const std::string& metric, int groups, int seeds,
                   const CellOf& cell_of) {
  Groups taken(static_cast<std::size_t>(groups));
  std::vector<double> values(taken.size());
  for (int seed = 0; seed < seeds; ++seed) {
    bool whole = true;
    for (int group = 0; group < groups && whole; ++group) {
      const auto value = value_in(rows, cell_of(group, seed), metric);
      whole = value.has_value();
      if (whole) values[static_cast<std::size_t>(group)] = *value;
    }
    for (std::size_t group = 0; group < taken.size() && whole; ++group) {
      taken[group].push_back(values[group]);
    }
  }
  return taken;
}

MetricRank rank_drawn(const CampaignSpec& spec, CellRows& rows, MetricRank rank) {
  const int seeds = spec.design.seeds();
  Groups groups = take_groups(rows, rank.metric, spec.samples() / seeds, seeds,
                              [&](int group, int seed) { return group * seeds + seed; });
  SwappedOutcomes outcomes;
  outcomes.first = groups[0];
  outcomes.second = groups[1];
  outcomes.swapped.assign(groups.begin() + 2, groups.end());
  for (const DrawnKey& key : spec.drawn) rank.factors.push_back(key.path);
  rank.seeds = outcomes.first.size();
  rank.effects = swapped_effects(outcomes);
  return rank;
}

MetricRank rank_grid(const CampaignSpec& spec, CellRows& rows, MetricRank rank) {
  const int samples = spec.samples();
  FactorialOutcomes outcomes;
  outcomes.values = take_groups(rows, rank.metric, spec.combinations(), samples,
                                [&](int group, int seed) { return group * samples + seed; });
  for (const GridKey& key : spec.grid) {
    rank.factors.push_back(key.path);
    outcomes.levels.push_back(static_cast<int>(key.values.size()));
  }
  rank.seeds = outcomes.values.front().size();
  rank.effects = factorial_effects(outcomes);
  return rank;
}

bool is_saltelli(const CampaignSpec& spec) { return spec.design.design() == Design::kSaltelli; }

std::vector<std::size_t> by_total(const MetricRank& rank) {
  std::vector<std::size_t> order(rank.effects.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rank.effects[a].total > rank.effects[b].total;
  });
  return order;
}

std::string share_text(double value, const Interval& interval) {
  return fmt::format("{:6.3f}  {:.3f} to {:.3f}", value, interval.low, interval.high);
}

}  // namespace

std::vector<std::string> ranked_metrics(CellRows& rows) {
  std::set<std::string> names;
  for (const int cell : rows.jobs()) {
    for (const auto& [name, value] : rows.row(cell).metrics) {
      const bool ranked =
          name.ends_with(".recovery.success") || name.ends_with(".position_error_m.rmse");
      if (ranked) names.insert(name);
    }
  }
  return {names.begin(), names.end()};
}

void require_rankable(const CampaignSpec& spec) {
  const bool drawn = is_saltelli(spec);
  if (drawn && spec.combinations() > 1) {
    throw std::runtime_error(fmt::format(
        "{}: --rank needs either a grid, or draws with `design: saltelli`, not both", spec.file));
  }
  if (!drawn && spec.combinations() == 1) {
    throw std::runtime_error(fmt::format(
        "{}: no key of its grid has two values; --rank needs a grid, or draws with `design: "
        "saltelli`",
        spec.file));
  }
}

MetricRank rank_keys(const CampaignSpec& spec, CellRows& rows, const std::string& metric) {
  require_rankable(spec);
  MetricRank rank;
  rank.metric = metric;
  rank = is_saltelli(spec) ? rank_drawn(spec, rows, std::move(rank))
                           : rank_grid(spec, rows, std::move(rank));
  rank.factors.emplace_back("seed");
  return rank;
}

std::string rank_text(const MetricRank& rank) {
  std::string text =
      fmt::format("{}, over {} seeds: shares of its variance\n", rank.metric, rank.seeds);
  if (rank.effects.empty()) return text + "  it does not vary\n";
  std::size_t width = 0;
  for (const std::string& name : rank.factors) width = std::max(width, name.size());
  text += fmt::format("  {:{}}  {:>6}  {:14}  {:>6}  {}\n", "", width, "alone", "95 %", "in all",
                      "95 %");
  for (const std::size_t k : by_total(rank)) {
    const FactorEffect& effect = rank.effects[k];
    text += fmt::format("  {:{}}  {}  {}\n", rank.factors[k], width,
                        share_text(effect.first, effect.first_interval),
                        share_text(effect.total, effect.total_interval));
  }
  return text;
}

void write_ranks(const std::vector<MetricRank>& ranks, const std::filesystem::path& file) {
  CsvWriter csv(file, {"metric", "key", "first", "first_low", "first_high", "total", "total_low",
                       "total_high", "seeds"});
  for (const MetricRank& rank : ranks) {
    for (std::size_t k = 0; k < rank.effects.size(); ++k) {
      const FactorEffect& effect = rank.effects[k];
      csv.text(rank.metric).text(rank.factors[k]);
      for (const double value :
           {effect.first, effect.first_interval.low, effect.first_interval.high, effect.total,
            effect.total_interval.low, effect.total_interval.high}) {
        csv.number(value);
      }
      csv.count(static_cast<std::int64_t>(rank.seeds)).end_row();
    }
  }
  csv.commit();
}

}  // namespace castaway::testbed
