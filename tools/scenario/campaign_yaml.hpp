/// Specification of a campaign, as YAML.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/metrics/expectation.hpp"
#include "tools/scenario/draw_yaml.hpp"
#include "tools/scenario/localizers/foreign_yaml.hpp"
#include "tools/scenario/sample_design.hpp"

namespace castaway::testbed {

/// A scenario key with the values that a campaign goes through.
struct GridKey {
  std::string path;  ///< As for `--set`: "lidar.range_max", "events.0.kidnap.kind".
  std::vector<YamlNode> values;
  std::string where;  ///< "file:line"
};

/// A scenario key whose value is drawn for each seed.
struct DrawnKey {
  std::string path;
  Draw draw;
  std::string where;
};

/// What a campaign keeps of each cell besides its row in the tables.
enum class KeepOfCell : std::uint8_t {
  kSummary,   ///< Nothing.
  kErrors,    ///< errors.csv and events.csv
  kFolder,    ///< The run folder.
  kFailures,  ///< The run folder of cells that failed, are void, or in which a kidnap was not
              ///< recovered.
};

/// When a combination has enough seeds.
struct UntilSpec {
  std::string metric;  ///< As in an expectation: "mh_amcl.recovery.success".
  double width = 0.1;  ///< Widest interval of its mean, in its unit.
  int first = 16;      ///< Seeds before the first look.
};

/// A campaign.
struct CampaignSpec {
  std::string file;  ///< For errors.
  std::string name;
  std::uint64_t seed = 1;      ///< Root of all draws.
  std::filesystem::path base;  ///< Folder that relative paths of the scenario start from.
  FilePrograms programs = FilePrograms::kRefused;  ///< As the user said, not the file.
  YamlNode scenario;                               ///< Base scenario of all cells.
  std::vector<GridKey> grid;    ///< In the order of the file; later entries override earlier ones.
  std::vector<DrawnKey> drawn;  ///< They override the grid.
  std::uint64_t first_seed = 1;
  SampleDesign design;  ///< Of the seeds and the drawn keys.
  std::optional<UntilSpec> until;
  KeepOfCell keep = KeepOfCell::kSummary;
  double timeout_s = 0.0;  ///< [s] Wall time of a cell after which it has failed; 0: none.
  YamlNode expect;         ///< As written: `expectations_of` reads it.
  std::string effective;   ///< YAML that reproduces the campaign, the scenario included.

  /// Combinations of the grid's values.
  [[nodiscard]] int combinations() const;
  /// Cells of a combination; with `until`, at most.
  [[nodiscard]] int samples() const { return design.samples(); }
  [[nodiscard]] int cells() const { return combinations() * samples(); }
};

inline constexpr int kMostCells = 10'000'000;

/// Reads a specification:
///
///     name: range
///     scenario: office/people        # a shipped one, a path, or the scenario itself as a map
///     grid:
///       lidar.range_max: [4, 8, 12]
///       localizers: [[mh_amcl], [amcl]]
///     draw:                          # `read_draw` says how; drawn for each seed
///       events.0.kidnap.at_s: {uniform: [10, 20]}
///     design: sobol                  # of the draws; independent, latin_hypercube, saltelli
///     seeds: 20                      # or 5..24
///     until: {metric: mh_amcl.recovery.success, width: 0.1, first: 16}
///     keep: summary                  # errors, folder, failures
///     timeout_s: 600
///     expect: {mh_amcl.recovery.success: {is: ">= 0.9", for: mean}}
///
/// `overrides`: of the scenario, as key=value. Throws std::runtime_error or std::invalid_argument
/// naming file, line, key, value and remedy.
CampaignSpec load_campaign_spec(const std::filesystem::path& file, FilePrograms programs,
                                const std::vector<std::string>& overrides = {});

/// Expectations of the cells, as of the runs of `run --seeds`, if `localizers` run in them. Throws
/// as `read_expectations` does.
std::vector<Expectation> expectations_of(const CampaignSpec& spec,
                                         const std::vector<std::string>& localizers);

}  // namespace castaway::testbed
