#include "tools/batch/dataset/dataset_sequence.hpp"

#include <cmath>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "tools/base/files/file.hpp"
#include "tools/base/files/file_error.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/output/any_error.hpp"
#include "tools/batch/dataset/dataset_manifest.hpp"
#include "tools/batch/dataset/sequence_statistics.hpp"
#include "tools/play/play.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// Rounds to six decimal places.
double round_digits(double value) { return std::round(value * 1e6) / 1e6; }

Json drawn_json(const SampledSequence& sequence) {
  Json drawn = Json::object();
  for (const auto& [key, value] : sequence.drawn) drawn[key] = value;
  return drawn;
}

Json files_json(const std::filesystem::path& folder) {
  Json files = Json::array();
  for (const ManifestFile& file : survey_files(folder)) {
    files.push_back({{"path", file.path}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  }
  return files;
}

/// Simulates the sequence and returns its metadata and statistics.
Json play_sequence(const DatasetSpec& spec, const MapScores& scores,
                   const SampledSequence& sequence, const std::filesystem::path& draft,
                   PartsOfSequences& parts) {
  SequenceStatistics statistics;
  RunInfo info;
  PlayOptions options;
  options.base = spec.base;
  options.out = draft;
  options.keep_list = false;
  options.quiet = true;
  options.timing = false;
  options.worlds = &parts.worlds;
  options.report = parts.report;
  options.scores = std::make_shared<const PlaceScores>(scores.places);
  options.sinks.push_back([&](const RunInfo& built, const auto& labels) {
    info = built;
    return std::make_unique<StatisticsSink>(statistics, labels);
  });
  play_silently(sequence.loaded, options);
  if (const auto reason = void_sentence_of(draft)) {
    throw std::runtime_error("its run is void: " + *reason);
  }
  Json root{{"sequence", sequence_name(sequence.index)},
            {"castaway", CASTAWAY_VERSION},
            {"seed", sequence.seed},
            {"world", info.world},
            {"robot", info.robot},
            {"drawn", drawn_json(sequence)}};
  root.update(statistics.json());
  root["difficulty"]["map_ambiguity"] = round_digits(scores.ambiguity.mean);
  root["difficulty"]["map_twins"] = round_digits(scores.ambiguity.twins);
  root["difficulty"]["map_difference"] =
      info.difference ? round_digits(info.difference->beams) : 0.0;
  return root;
}

}  // namespace

void make_sequence(const DatasetSpec& spec, const DatasetWorlds& worlds,
                   const SampledSequence& sequence, const std::filesystem::path& draft,
                   PartsOfSequences& parts) {
  try {
    const MapScores& scores = worlds.scores(sequence.loaded.scenario);
    Json root = play_sequence(spec, scores, sequence, draft, parts);
    root["files"] = files_json(draft);
    write_file(draft / "sequence.json", json_text(root) + "\n");
  } catch (const FileError&) {
    throw;
  } catch (...) {
    throw std::runtime_error(sequence_error(spec, sequence, current_error_text()));
  }
}

}  // namespace castaway::testbed
