#include "tools/base/output/default_folder.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "tools/base/output/say.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// True if the folder is free or was made by the same subcommand with the same settings.
bool is_same_or_free(const fs::path& folder, const std::string& made_by,
                     const std::string& settings) {
  try {
    const auto record = load_record(folder);
    if (!record || record->made_by.empty()) return true;
    return record->made_by == made_by && record->settings == settings;
  } catch (const std::exception&) {
    return false;
  }
}

bool is_allowed(const OutputRequest& request) {
  try {
    check_output(request);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

OutputRequest with_suffix(OutputRequest request, const std::string& suffix) {
  request.target += "-" + suffix;
  return request;
}

/// The request with its label behind the folder's name or, where that is taken, too, with the
/// settings' hash.
template <typename IsFree>
fs::path beside(const OutputRequest& request, const IsFree& is_free) {
  constexpr std::size_t kDigits = 8;
  const OutputRequest labelled = with_suffix(request, request.label);
  if (!request.label.empty() && is_free(labelled)) return labelled.target;
  return with_suffix(request, request.settings.substr(0, kDigits)).target;
}

bool is_usable(const OutputRequest& request) {
  return is_same_or_free(request.target, request.made_by, request.settings) && is_allowed(request);
}

fs::path report_choice(const OutputRequest& request, const fs::path& folder) {
  if (folder != request.target) {
    say(fmt::format("{} holds something else; writing to {}", request.target.string(),
                    folder.string()));
  }
  return folder;
}

}  // namespace

fs::path free_folder(const OutputRequest& request) {
  return is_usable(request) ? request.target : beside(request, is_usable);
}

fs::path announced_free_folder(const OutputRequest& request) {
  return report_choice(request, free_folder(request));
}

fs::path announced_free_runs_folder(const OutputRequest& request,
                                    const std::vector<PlannedRun>& runs) {
  const auto is_free = [&](const OutputRequest& candidate) {
    return is_usable(candidate) &&
           std::all_of(runs.begin(), runs.end(), [&](const PlannedRun& run) {
             return is_same_or_free(candidate.target / run.folder, "run", run.settings);
           });
  };
  return report_choice(request, is_free(request) ? request.target : beside(request, is_free));
}

}  // namespace castaway::testbed
