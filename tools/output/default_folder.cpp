#include "tools/output/default_folder.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "tools/output/say.hpp"

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

fs::path with_suffix(const OutputRequest& request) {
  constexpr std::size_t kDigits = 8;
  fs::path folder = request.target;
  folder += "-" + request.settings.substr(0, kDigits);
  return folder;
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
  const bool free = is_same_or_free(request.target, request.made_by, request.settings);
  return free && is_allowed(request) ? request.target : with_suffix(request);
}

fs::path announced_free_folder(const OutputRequest& request) {
  return report_choice(request, free_folder(request));
}

fs::path announced_free_runs_folder(const OutputRequest& request,
                                    const std::vector<PlannedRun>& runs) {
  const bool free = std::all_of(runs.begin(), runs.end(), [&](const PlannedRun& run) {
    return is_same_or_free(request.target / run.folder, "run", run.settings);
  });
  return report_choice(request, free ? free_folder(request) : with_suffix(request));
}

}  // namespace castaway::testbed
