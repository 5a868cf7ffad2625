/// Parts that the work of one process has in common, by a text that is equal for equal parts only.
#pragma once

#include <map>
#include <memory>
#include <string>

namespace castaway::testbed {

/// Keeps the latest few parts.
template <typename Part>
class LatestFew {
 public:
  /// Null if it is not kept.
  [[nodiscard]] std::shared_ptr<const Part> find(const std::string& key) const {
    const auto found = parts_.find(key);
    return found == parts_.end() ? nullptr : found->second;
  }
  void keep(const std::string& key, std::shared_ptr<const Part> part) {
    constexpr std::size_t kMost = 4;
    if (parts_.size() >= kMost) parts_.clear();
    parts_.emplace(key, std::move(part));
  }

 private:
  std::map<std::string, std::shared_ptr<const Part>> parts_;
};

}  // namespace castaway::testbed
