#include "tools/pages/dataset/dataset_card.hpp"

#include <algorithm>
#include <charconv>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/output/file_name.hpp"
#include "tools/pages/dataset/dataset_card_formats.hpp"
#include "tools/pages/dataset/dataset_plots.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using Lines = std::back_insert_iterator<std::string>;

void add_head(const DatasetContents& contents, Lines out) {
  const DatasetSpec& spec = contents.spec;
  fmt::format_to(out, "# {}\n\n", spec.name);
  if (!spec.description.empty()) fmt::format_to(out, "{}\n\n", spec.description);
  fmt::format_to(out,
                 "{} sequences of a simulated robot with a lidar, {:.1f} minutes, {:.0f} m, {} "
                 "scans, {:.1f} MB. Poses, labels, people and events are the truth, not "
                 "measurements.\n\n",
                 contents.names.size(), contents.sum("/duration_s") / 60.0,
                 contents.sum("/distance_m"), static_cast<std::int64_t>(contents.sum("/scans")),
                 static_cast<double>(contents.all_bytes()) / 1e6);
  fmt::format_to(out, "Licence: {}. Made by castaway {}:\n\n",
                 spec.license.empty() ? "none stated" : spec.license, CASTAWAY_VERSION);
  fmt::format_to(out,
                 "```\ncastaway dataset dataset.yaml -n {0} --out DIR        # all of it, byte for "
                 "byte\ncastaway dataset dataset.yaml --only 0 --out DIR    # one sequence\n"
                 "castaway dataset --verify DIR                       # or: sha256sum -c "
                 "SHA256SUMS\n```\n\n",
                 contents.names.size());
  fmt::format_to(out, "Root seed: {}. Specification: [dataset.yaml](dataset.yaml).\n", spec.seed);
}

/// Adds a table row with the smallest, median and largest value of a figure.
void add_spread(const DatasetContents& contents, const char* name, const char* pointer, Lines out) {
  const std::vector<double> all = contents.figures(pointer);
  if (all.empty()) {
    fmt::format_to(out, "| {} | | | |\n", name);
    return;
  }
  fmt::format_to(out, "| {} | {:.4g} | {:.4g} | {:.4g} |\n", name, quantile(all, 0.0),
                 quantile(all, 0.5), quantile(all, 1.0));
}

void add_difficulty(const DatasetContents& contents, Lines out) {
  fmt::format_to(
      out,
      "\n"
      "## Difficulty\n"
      "\n"
      "By sequence; every figure of every sequence is in [sequences.csv](sequences.csv).\n"
      "\n"
      "| | minimum | median | maximum |\n"
      "|---|---|---|---|\n");
  add_spread(contents, "ambiguity: similarity of the place most similar to the robot's, mean",
             "/difficulty/ambiguity", out);
  add_spread(contents, "the same over all places of the map", "/difficulty/map_ambiguity", out);
  add_spread(contents, "places of the map with a twin, share", "/difficulty/map_twins", out);
  add_spread(contents, "share of beams that end elsewhere than on the map",
             "/difficulty/map_difference", out);
  add_spread(contents, "occluded beams, share, mean", "/difficulty/occluded_mean", out);
  add_spread(contents, "occluded beams, share, worst scan", "/difficulty/occluded_max", out);
  add_spread(contents, "odometry: error per metre [m]", "/difficulty/odometry_error_per_m", out);
  add_spread(contents, "odometry: yaw error per metre [rad]",
             "/difficulty/odometry_yaw_error_rad_per_m", out);
}

/// Totals of the sequences of a world.
struct WorldSums {
  int sequences = 0;
  double seconds = 0.0;
  double metres = 0.0;
  std::size_t kidnaps = 0;
  int part = 0;
};

void add_worlds(const DatasetContents& contents, Lines out) {
  std::map<std::string, WorldSums> worlds;
  for (std::size_t i = 0; i < contents.sequences.size(); ++i) {
    const Json& sequence = contents.sequences[i];
    WorldSums& sums = worlds[sequence.at("world").get<std::string>()];
    ++sums.sequences;
    sums.seconds += sequence.at("duration_s").get<double>();
    sums.metres += sequence.at("distance_m").get<double>();
    sums.kidnaps += sequence.at("kidnaps").size();
    sums.part = contents.splits.part[i];
  }
  fmt::format_to(out,
                 "\n"
                 "## Worlds and splits\n"
                 "\n"
                 "| world | sequences | minutes | metres | kidnaps | split |\n"
                 "|---|---|---|---|---|---|\n");
  for (const auto& [name, sums] : worlds) {
    fmt::format_to(out, "| {} | {} | {:.1f} | {:.0f} | {} | {} |\n", name, sums.sequences,
                   sums.seconds / 60.0, sums.metres, sums.kidnaps,
                   contents.spec.splits.by_sequence
                       ? "by sequence"
                       : kSplitNames[static_cast<std::size_t>(sums.part)]);
  }
  fmt::format_to(
      out, "\nsplits/train.txt, val.txt and test.txt name the sequences, {}.{}\n",
      contents.spec.splits.by_sequence ? "drawn one by one" : "no world is in two splits",
      contents.splits.remark.empty() ? "" : " " + contents.splits.remark + ".");
}

/// "0.2 to 0.6" for numbers; otherwise how often each value was drawn.
std::string range_of(const DatasetContents& contents, const std::string& key) {
  constexpr std::size_t kMostNamed = 8;
  std::map<std::string, int> values;
  std::vector<double> numbers;
  for (const Json& sequence : contents.sequences) {
    const auto text = sequence.at("drawn").at(key).get<std::string>();
    ++values[text];
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc{} && end == text.data() + text.size()) numbers.push_back(number);
  }
  if (numbers.size() == contents.sequences.size()) {
    return fmt::format("{:g} to {:g}", quantile(numbers, 0.0), quantile(numbers, 1.0));
  }
  if (values.size() > kMostNamed) return fmt::format("{} different values", values.size());
  std::string text;
  for (const auto& [value, count] : values) {
    text += fmt::format("{}`{}` {} times", text.empty() ? "" : ", ", value, count);
  }
  return text;
}

void add_drawn(const DatasetContents& contents, Lines out) {
  if (contents.spec.vary.empty()) return;
  fmt::format_to(out, "\n## What was drawn\n\n| key | values |\n|---|---|\n");
  for (const VariedKey& key : contents.spec.vary) {
    fmt::format_to(out, "| {} | {} |\n", key.path, range_of(contents, key.path));
  }
}

void add_distributions(const DatasetContents& contents, Lines out) {
  fmt::format_to(out, "\n## Distributions\n\n{}\n[{}]({}) plots them.\n",
                 describe_distributions(contents), kPlotsPage, kPlotsPage);
  for (const auto& [world, map] : contents.maps) {
    fmt::format_to(out,
                   "\nWhere the robot was in {0}, yellow to dark red:\n\n"
                   "![Coverage of {0}](plots/coverage-{1}.png)\n",
                   world, file_name_of(world));
  }
}

}  // namespace

std::string dataset_card(const DatasetContents& contents) {
  std::string text;
  const auto out = std::back_inserter(text);
  add_head(contents, out);
  text += describe_formats(contents);
  add_worlds(contents, out);
  add_difficulty(contents, out);
  add_drawn(contents, out);
  add_distributions(contents, out);
  return text;
}

}  // namespace castaway::testbed
