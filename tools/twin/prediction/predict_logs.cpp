#include "tools/twin/prediction/predict_logs.hpp"

#include <set>
#include <stdexcept>

#include "tools/base/output/output_folder.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

std::string name_of(const fs::path& folder) {
  return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
}

}  // namespace

std::vector<std::string> names_of_logs(const std::vector<std::string>& folders) {
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

std::vector<LogPrediction> predict_logs(const std::vector<std::string>& folders,
                                        const std::vector<LocalizerSpec>& localizers,
                                        const PredictionConfig& config, const fs::path& out,
                                        const TrialRunner& run) {
  const std::vector<std::string> names = names_of_logs(folders);
  const auto predict_one = [&](int trial) {
    const auto i = static_cast<std::size_t>(trial);
    RecordedPlace place = load_recorded_place(folders[i]);
    place.name = names[i];
    OutputFolder twin({.target = out / names[i], .made_by = "twin", .settings = ""});
    std::string text = pack_prediction(predict_log(place, localizers, config, twin.folder()));
    twin.commit();
    return text;
  };
  std::vector<LogPrediction> all;
  for (const std::string& text : run(static_cast<int>(names.size()), predict_one, [] {})) {
    if (!text.empty()) all.push_back(unpack_prediction(text));
  }
  return all;
}

}  // namespace castaway::testbed
