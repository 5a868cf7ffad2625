#include "tools/batch/dataset/dataset_contents.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

/// Adds a sequence: its sequence.json and the files listed there.
void add_sequence(const DatasetFolder& folder, const std::string& name, DatasetContents& contents) {
  const std::string text = read_file(folder.sequence(name) / "sequence.json");
  Json root = Json::parse(text);
  std::uintmax_t bytes = text.size();
  const std::string path = "sequences/" + name + "/";
  for (const Json& file : root.at("files")) {
    contents.files.push_back({path + file.at("path").get<std::string>(),
                              file.at("bytes").get<std::uintmax_t>(),
                              file.at("sha256").get<std::string>()});
    bytes += contents.files.back().bytes;
  }
  contents.files.push_back({path + "sequence.json", text.size(), sha256(text)});
  root.erase("files");
  contents.sequences.push_back(std::move(root));
  contents.bytes.push_back(bytes);
}

}  // namespace

double DatasetContents::sum(const char* pointer) const {
  const std::vector<double> all = figures(pointer);
  return std::accumulate(all.begin(), all.end(), 0.0);
}

std::vector<double> DatasetContents::figures(const char* pointer) const {
  std::vector<double> all;
  for (const Json& sequence : sequences) {
    const Json& value = sequence.at(Pointer(pointer));
    if (value.is_number()) all.push_back(value.get<double>());
  }
  return all;
}

std::vector<double> DatasetContents::counts(const char* pointer) const {
  std::vector<double> sums;
  for (const Json& sequence : sequences) {
    const Json& list = sequence.at(Pointer(pointer));
    sums.resize(std::max(sums.size(), list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) sums[i] += list[i].get<double>();
  }
  return sums;
}

std::uintmax_t DatasetContents::all_bytes() const {
  return std::accumulate(bytes.begin(), bytes.end(), std::uintmax_t{0});
}

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return percentile(values, q);
}

DatasetContents load_contents(const DatasetFolder& folder, const DatasetSpec& spec,
                              const std::vector<std::string>& names,
                              const std::map<std::string, RosMap>& maps) {
  DatasetContents contents;
  contents.spec = spec;
  contents.names = names;
  contents.maps = maps;
  std::vector<std::string> worlds;
  for (const std::string& name : names) {
    try {
      add_sequence(folder, name, contents);
    } catch (const Json::exception& error) {
      throw std::runtime_error((folder.sequence(name) / "sequence.json").string() +
                               ": is damaged (" + error.what() +
                               "); remove the folder and make it again");
    }
    worlds.push_back(contents.sequences.back().value("world", std::string()));
  }
  contents.splits = split_dataset(worlds, spec.splits, spec.seed);
  return contents;
}

}  // namespace castaway::testbed
