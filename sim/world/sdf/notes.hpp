/// Warnings of one kind gathered into one line each.
#pragma once

#include <exception>
#include <map>
#include <string>
#include <vector>

namespace castaway::sim {

/// What was noticed, and of what.
class Notes {
 public:
  /// `what`: the same words for all subjects of a kind.
  void add(const std::string& what, const std::string& subject) {
    subjects_[what].push_back(subject);
  }
  /// A piece is left out because of an error: by what is missing, or else by its own name.
  void leave_out(const std::string& name, const std::exception& error);
  /// One line a kind, in order of the kinds: "what: a, b, c and 9 more".
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  std::map<std::string, std::vector<std::string>> subjects_;
};

}  // namespace castaway::sim
