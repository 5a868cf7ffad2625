#include "tools/batch/dataset/dataset_splits.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

using Shares = std::array<double, 3>;

constexpr std::array<int, 3> kSplitPriority{0, 2, 1};  // Test before validation: a data set without
                                                       // a test split proves nothing.

Shares shares_of(const SplitSpec& spec) {
  const double sum = spec.train + spec.val + spec.test;
  return {spec.train / sum, spec.val / sum, spec.test / sum};
}

/// Shuffles names by a random key per name, so that adding a name does not reorder the others.
std::vector<std::string> shuffle_names(std::vector<std::string> names, std::uint64_t seed) {
  const auto draw = [seed](const std::string& name) {
    return localization::substream(seed, "splits/" + name)();
  };
  std::sort(names.begin(), names.end(),
            [&](const auto& a, const auto& b) { return draw(a) < draw(b); });
  return names;
}

/// The split whose size is farthest below its requested share.
int farthest_below_share(const Shares& shares, const Shares& filled, double all) {
  int best = 0;
  double most = -1e300;
  for (int part = 0; part < 3; ++part) {
    const auto i = static_cast<std::size_t>(part);
    if (shares[i] <= 0.0) continue;
    const double missing = shares[i] * all - filled[i];
    if (missing > most) {
      most = missing;
      best = part;
    }
  }
  return best;
}

std::vector<int> parts_with_share(const Shares& shares) {
  std::vector<int> parts;
  for (const int part : kSplitPriority) {
    if (shares[static_cast<std::size_t>(part)] > 0.0) parts.push_back(part);
  }
  return parts;
}

/// Shuffles the worlds, then moves the one with the most sequences to the front, for training.
std::vector<std::string> world_order(const std::map<std::string, int>& sequences,
                                     std::uint64_t seed) {
  std::vector<std::string> names;
  for (const auto& [name, count] : sequences) names.push_back(name);
  names = shuffle_names(std::move(names), seed);
  const auto largest = std::max_element(
      names.begin(), names.end(),
      [&](const auto& a, const auto& b) { return sequences.at(a) < sequences.at(b); });
  if (largest != names.end()) std::rotate(names.begin(), largest, largest + 1);
  return names;
}

/// Assigns a split to each world.
std::map<std::string, int> assign_worlds(const std::map<std::string, int>& sequences,
                                         const Shares& shares, std::uint64_t seed) {
  double all = 0.0;
  for (const auto& [name, count] : sequences) all += count;
  const std::vector<int> first = parts_with_share(shares);
  Shares filled{};
  std::map<std::string, int> places;
  for (const std::string& name : world_order(sequences, seed)) {
    const int part = places.size() < first.size() ? first[places.size()]
                                                  : farthest_below_share(shares, filled, all);
    places[name] = part;
    filled[static_cast<std::size_t>(part)] += sequences.at(name);
  }
  return places;
}

std::string remark_on(std::size_t worlds, const std::vector<int>& parts) {
  if (worlds >= parts.size()) return "";
  std::vector<std::string> empty;
  for (std::size_t i = worlds; i < parts.size(); ++i) {
    empty.emplace_back(kSplitNames[static_cast<std::size_t>(parts[i])]);
  }
  return fmt::format(
      "{} world{} for {} splits: {} {} empty; add worlds, or set splits: {{by: sequence}}", worlds,
      worlds == 1 ? "" : "s", parts.size(), fmt::join(empty, " and "),
      empty.size() == 1 ? "is" : "are");
}

DatasetSplits by_sequence(std::size_t count, const Shares& shares, std::uint64_t seed) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.push_back(std::to_string(i));
  DatasetSplits splits;
  splits.part.resize(count);
  Shares filled{};
  for (const std::string& name : shuffle_names(names, seed)) {
    const int part = farthest_below_share(shares, filled, static_cast<double>(count));
    splits.part[std::stoul(name)] = part;
    filled[static_cast<std::size_t>(part)] += 1.0;
  }
  return splits;
}

}  // namespace

DatasetSplits split_dataset(const std::vector<std::string>& worlds, const SplitSpec& spec,
                            std::uint64_t seed) {
  const Shares shares = shares_of(spec);
  if (spec.by_sequence) return by_sequence(worlds.size(), shares, seed);
  std::map<std::string, int> sequences;
  for (const std::string& world : worlds) ++sequences[world];
  const std::map<std::string, int> places = assign_worlds(sequences, shares, seed);
  DatasetSplits splits;
  for (const std::string& world : worlds) splits.part.push_back(places.at(world));
  splits.remark = remark_on(sequences.size(), parts_with_share(shares));
  return splits;
}

}  // namespace castaway::testbed
