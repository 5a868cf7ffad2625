#include "sim/world/sdf/notes.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/world/sdf/resource_finder.hpp"

namespace castaway::sim {
namespace {

constexpr std::size_t kNamed = 3;  // Number of subjects that a line names.

/// "a, b, c and 9 more", each once.
std::string name_first(const std::vector<std::string>& all) {
  std::vector<std::string> subjects;
  for (const std::string& subject : all) {
    if (std::find(subjects.begin(), subjects.end(), subject) == subjects.end()) {
      subjects.push_back(subject);
    }
  }
  const std::size_t named = std::min(subjects.size(), kNamed);
  const std::vector<std::string> first(subjects.begin(),
                                       subjects.begin() + static_cast<std::ptrdiff_t>(named));
  const std::size_t more = subjects.size() - named;
  return fmt::format("{}{}", fmt::join(first, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace

void Notes::leave_out(const std::string& name, const std::exception& error) {
  if (const auto* missing = dynamic_cast<const ResourceMissing*>(&error)) {
    add("left out, since it " + missing->remedy, missing->uri);
  } else {
    add(fmt::format("left out, since {}", error.what()), name);
  }
}

std::vector<std::string> Notes::lines() const {
  std::vector<std::string> lines;
  for (const auto& [what, all] : subjects_) {
    lines.push_back(fmt::format("{}: {}", what, name_first(all)));
  }
  std::vector<std::string> unread;
  for (const auto& [kind, all] : unread_) {
    unread.push_back(fmt::format("{} {} ({})", all.size(), kind, name_first(all)));
  }
  if (!unread.empty()) {
    lines.push_back(
        fmt::format("left out, since only what collides is read: {}", fmt::join(unread, ", ")));
  }
  return lines;
}

}  // namespace castaway::sim
