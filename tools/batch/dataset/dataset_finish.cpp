#include "tools/batch/dataset/dataset_finish.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/csv.hpp"
#include "tools/base/output/file_name.hpp"
#include "tools/batch/dataset/sequence_rows.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string csv_text(const std::vector<std::vector<std::string>>& rows, const fs::path& draft) {
  CsvWriter csv(draft, rows.front());
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    for (const std::string& cell : *row) csv.text(cell);
    csv.end_row();
  }
  csv.commit();
  std::string text = read_file(draft);
  fs::remove(draft);
  return text;
}

std::vector<DatasetFile> split_files(const DatasetContents& contents) {
  std::vector<DatasetFile> files;
  for (std::size_t part = 0; part < kSplitNames.size(); ++part) {
    std::string names;
    for (std::size_t i = 0; i < contents.names.size(); ++i) {
      if (contents.splits.part[i] == static_cast<int>(part)) names += contents.names[i] + "\n";
    }
    files.emplace_back(fmt::format("splits/{}.txt", kSplitNames[part]), std::move(names));
  }
  return files;
}

std::vector<DatasetFile> map_files(const DatasetContents& contents, const fs::path& drafts) {
  std::vector<DatasetFile> files;
  for (const auto& [world, map] : contents.maps) {
    const std::string name = file_name_of(world);
    write_ros_map(map, drafts / (name + ".yaml"));
    for (const char* ending : {".yaml", ".pgm"}) {
      files.emplace_back("maps/" + name + ending, read_file(drafts / (name + ending)));
    }
  }
  return files;
}

void append_files(std::vector<DatasetFile> more, std::vector<DatasetFile>& files) {
  for (DatasetFile& file : more) files.push_back(std::move(file));
}

}  // namespace

void finish_dataset(const DatasetFolder& folder, const DatasetContents& contents,
                    const DatasetPages& pages) {
  std::vector<DatasetFile> files{
      {"sequences.csv", csv_text(sequence_rows(contents), folder.draft("sequences.csv"))}};
  append_files(split_files(contents), files);
  append_files(map_files(contents, folder.draft("maps")), files);
  append_files(pages(contents), files);
  std::vector<ManifestFile> listed = contents.files;
  for (const auto& [path, bytes] : files) {
    if (path == kPlotsPage) {
      folder.put(path, bytes);
      continue;
    }
    folder.put_new(path, bytes);
    listed.push_back({path, bytes.size(), sha256(bytes)});
  }
  for (const char* path : {"dataset.json", "dataset.yaml"}) {
    const std::string bytes = read_file(folder.path() / path);
    listed.push_back({path, bytes.size(), sha256(bytes)});
  }
  std::sort(listed.begin(), listed.end(),
            [](const auto& a, const auto& b) { return a.path < b.path; });
  folder.put_new("SHA256SUMS", sums_text(listed));
  folder.put_new("manifest.json", manifest_text(listed));
  folder.clear_work();
}

std::string describe_dataset(const DatasetFolder& folder, const DatasetContents& contents,
                             const DatasetInvocation& invocation) {
  const double scans = std::max(contents.sum("/scans"), 1.0);
  const auto bytes = static_cast<double>(contents.all_bytes());
  std::string text = fmt::format(
      "{}: {} sequences, {:.1f} min, {:.0f} m, {:.0f} scans, {:.1f} MB, {:.0f} bytes a scan\n",
      contents.spec.name, contents.names.size(), contents.sum("/duration_s") / 60.0,
      contents.sum("/distance_m"), contents.sum("/scans"), bytes / 1e6, bytes / scans);
  text += fmt::format(
      "{} made now in {:.1f} s, {} at a time: workers busy {:.0f} %, the largest took {:.0f} MB\n",
      invocation.made, invocation.wall_s, invocation.workers,
      100.0 * invocation.cpu_s / std::max(invocation.wall_s * invocation.workers, 1e-9),
      invocation.largest_mb);
  if (!contents.splits.remark.empty()) text += "Splits: " + contents.splits.remark + "\n";
  text += fmt::format("Folder: {0}\nCard:   {0}/README.md\n", folder.path().string());
  return text;
}

std::string dataset_json(const DatasetFolder& folder, const DatasetContents& contents,
                         const DatasetInvocation& invocation) {
  const Json root{{"castaway", CASTAWAY_VERSION},
                  {"kind", "dataset"},
                  {"name", contents.spec.name},
                  {"folder", folder.path().string()},
                  {"sequences", contents.names.size()},
                  {"duration_s", contents.sum("/duration_s")},
                  {"distance_m", contents.sum("/distance_m")},
                  {"scans", contents.sum("/scans")},
                  {"bytes", contents.all_bytes()},
                  {"splits", contents.splits.remark},
                  {"timing",
                   {{"made", invocation.made},
                    {"wall_s", invocation.wall_s},
                    {"workers", invocation.workers},
                    {"cpu_s", invocation.cpu_s},
                    {"largest_mb", invocation.largest_mb}}}};
  return json_text(root, 2) + "\n";
}

}  // namespace castaway::testbed
