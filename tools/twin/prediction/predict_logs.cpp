#include "tools/twin/prediction/predict_logs.hpp"

#include <optional>
#include <set>
#include <stdexcept>

#include "tools/base/files/file.hpp"
#include "tools/base/output/exit_code.hpp"
#include "tools/base/process/worker_pool.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

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

/// Predicts several logs at once, each in one process.
std::vector<LogPrediction> predict_at_once(const std::vector<std::string>& names, int workers,
                                           const PredictOne& predict_one,
                                           const std::function<void(const std::string&)>& on_log) {
  std::vector<LogPrediction> all(names.size());
  JobOutcomes outcomes;
  outcomes.on_result = [&](int i, const std::string& text) {
    const auto index = static_cast<std::size_t>(i);
    all[index] = unpack_prediction(text);
    on_log(names[index]);
  };
  outcomes.on_failure = [&](int i, const std::string& reason) {
    const std::string& name = names[static_cast<std::size_t>(i)];
    throw std::runtime_error(reason.find(name) == std::string::npos ? name + ": " + reason
                                                                    : reason);
  };
  const auto work = [&](int i) {
    return pack_prediction(predict_one(static_cast<std::size_t>(i), 1));
  };
  work_through(jobs_up_to(static_cast<int>(names.size())), workers, work, outcomes);
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
    return predict_at_once(names, workers, predict_one, on_log);
  }
  std::vector<LogPrediction> all;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    all.push_back(predict_one(i, workers));
    on_log(names[i]);
  }
  return all;
}

}  // namespace castaway::testbed
