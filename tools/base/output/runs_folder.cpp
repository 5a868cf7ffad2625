#include "tools/base/output/runs_folder.hpp"

#include <algorithm>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/output/listed_files.hpp"
#include "tools/base/output/listed_path.hpp"
#include "tools/base/output/make_folder.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

void check_all(const OutputRequest& request, const std::vector<PlannedRun>& runs) {
  check_output(request);
  const std::optional<FileRecord> record = load_record(request.target);
  for (const std::string& run : record.value_or(FileRecord{}).runs) {
    if (is_folder_below(request.target, run)) static_cast<void>(load_record(request.target / run));
  }
  OutputRequest one = request;
  for (const PlannedRun& run : runs) {
    require_no_link(request.target, run.folder);
    one.target = request.target / run.folder;
    check_output(one);
  }
}

/// Removes the drafts of runs that were killed, or ended by an error, when they had just finished.
void clear_drafts(const fs::path& target, const std::vector<PlannedRun>& runs) {
  std::error_code none;
  for (const PlannedRun& run : runs) {
    if (load_record(target / run.folder)) fs::remove_all(target / run.folder / kStagingName, none);
  }
}

std::vector<std::string> folders_of(const std::vector<PlannedRun>& runs) {
  std::vector<std::string> folders;
  for (const PlannedRun& run : runs) folders.push_back(run.folder);
  return folders;
}

}  // namespace

std::string program_hash() { return sha256_of_file("/proc/self/exe"); }

RunsFolder::RunsFolder(OutputRequest request, std::vector<PlannedRun> runs, RunsShare share)
    : request_(std::move(request)), runs_(std::move(runs)) {
  check_all(request_, runs_);
  make_folder(request_.target);
  const bool shared = share == RunsShare::kSome;
  work_.emplace(request_.target, shared ? kPatience : 0.0);
  FileRecord& record = work_->record();
  earlier_ = record;
  record.made_by = request_.made_by;
  record.settings = request_.settings;
  record.program = program_hash();
  record.finished = false;
  const bool same_work =
      earlier_.finished ? share == RunsShare::kCollect : earlier_.program == record.program;
  goes_on_ =
      same_work && earlier_.made_by == record.made_by && earlier_.settings == record.settings;
  if (goes_on_ && !shared) clear_drafts(request_.target, runs_);
  for (const std::string& folder : folders_of(runs_)) {
    const auto& known = record.runs;
    if (std::find(known.begin(), known.end(), folder) == known.end()) record.runs.push_back(folder);
  }
  work_->save();
  work_->begin(record);
  if (shared) work_.reset();
  kept_.emplace("finished runs are kept in " + request_.target.string() +
                "; the same command resumes");
}

bool RunsFolder::has_run(std::size_t index) const {
  if (!goes_on_) return false;
  const PlannedRun& run = runs_[index];
  const auto record = load_record(request_.target / run.folder);
  return record && record->finished && record->settings == run.settings;
}

void RunsFolder::put(const std::string& name, std::string_view bytes) {
  put_by(name, [&](const fs::path& file) { write_file(file, bytes); });
}

void RunsFolder::put_by(const std::string& name,
                        const std::function<void(const fs::path& file)>& write) {
  const std::string hash = work_->put(name, write);
  work_->record().files[name] = hash;
  earlier_.files.erase(name);
}

void RunsFolder::finish() {
  FileRecord& record = work_->record();
  for (const auto& [name, hash] : earlier_.files) {
    if (!is_replaceable(request_.target, name, earlier_)) continue;
    std::error_code none;
    fs::remove(request_.target / name, none);
    record.files.erase(name);
  }
  const std::vector<std::string> made = folders_of(runs_);
  for (const std::string& run : record.runs) {
    if (std::find(made.begin(), made.end(), run) != made.end()) continue;
    if (is_folder_below(request_.target, run)) remove_output(request_.target / run);
  }
  record.runs = made;
  record.program.clear();
  record.finished = true;
  work_->save();
  work_.reset();
  kept_.reset();
  kept_.emplace("all runs are finished, in " + request_.target.string());
}

}  // namespace castaway::testbed
