#include "tools/prediction/predict_logs.hpp"

#include <optional>
#include <set>
#include <stdexcept>

#include "tools/files/file.hpp"
#include "tools/output/exit_code.hpp"
#include "tools/workers/worker_pool.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// Exit code of a worker that left a message.
constexpr int kRefused = 3;

std::string name_of(const fs::path& folder) {
  return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
}

/// The names of the logs, which name their twins.
std::vector<std::string> names_of(const std::vector<std::string>& folders) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const std::string& folder : folders) {
    names.push_back(name_of(fs::absolute(folder).lexically_normal()));
    if (seen.insert(names.back()).second) continue;
    throw std::runtime_error(folder + ": two logs are in folders named '" + names.back() +
                             "'; rename one");
  }
  return names;
}

/// Predicts the log of an index with a number of workers.
using PredictOne = std::function<LogPrediction(std::size_t index, int workers)>;

/// Predicts each log in a process of its own. Results and messages of failed ones pass through
/// files in `out`.
std::vector<LogPrediction> predict_at_once(const std::vector<std::string>& names, int workers,
                                           const fs::path& out, const PredictOne& predict_one,
                                           const std::function<void(const std::string&)>& on_log) {
  const auto file_of = [&](int i) { return out / (std::to_string(i) + ".prediction"); };
  const auto job = [&](int i) {
    try {
      write_file(file_of(i), pack_prediction(predict_one(static_cast<std::size_t>(i), 1)));
    } catch (const std::exception& error) {
      write_file(file_of(i), error.what());
      return kRefused;
    }
    return static_cast<int>(kDone);
  };
  std::optional<std::string> failure;
  const auto on_done = [&](int i, int exit_code) {
    const std::string& name = names[static_cast<std::size_t>(i)];
    if (exit_code == kDone) return on_log(name);
    failure = exit_code == kRefused ? read_file(file_of(i)) : name + ": its process failed";
  };
  const auto count = static_cast<int>(names.size());
  run_jobs(count, workers, job, on_done, [&] { return failure.has_value(); });
  if (failure) throw std::runtime_error(*failure);
  std::vector<LogPrediction> all;
  for (int i = 0; i < count; ++i) {
    all.push_back(unpack_prediction(read_file(file_of(i))));
    fs::remove(file_of(i));
  }
  return all;
}

}  // namespace

std::vector<LogPrediction> predict_logs(const std::vector<std::string>& folders,
                                        const std::vector<LocalizerSpec>& localizers,
                                        const PredictionConfig& config, const fs::path& out,
                                        const std::function<void(const std::string&)>& on_log) {
  const std::vector<std::string> names = names_of(folders);
  const PredictOne predict_one = [&](std::size_t i, int workers) {
    PredictionConfig how = config;
    how.evaluation.workers = workers;
    RecordedPlace place = load_recorded_place(folders[i]);
    place.name = names[i];
    return predict_log(place, localizers, how, out / names[i]);
  };
  fs::create_directories(out);
  const int workers = config.evaluation.workers;
  if (folders.size() > 1 && workers > 1) {
    return predict_at_once(names, workers, out, predict_one, on_log);
  }
  std::vector<LogPrediction> all;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    all.push_back(predict_one(i, workers));
    on_log(names[i]);
  }
  return all;
}

}  // namespace castaway::testbed
