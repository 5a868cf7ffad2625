/// Collects warnings of one kind into one line.
#pragma once

#include <exception>
#include <map>
#include <string>
#include <vector>

namespace castaway::sim {

/// Warnings by kind, with their subjects.
class Notes {
 public:
  /// `what`: the same text for all subjects of a kind.
  void add(const std::string& what, const std::string& subject) {
    subjects_[what].push_back(subject);
  }
  /// Notes that a piece is left out because of an error, under the missing file or else the piece's
  /// name.
  void leave_out(const std::string& name, const std::exception& error);
  /// Counts something that is not read because it does not collide, such as an actor. All of it
  /// becomes one line.
  void count_unread(const std::string& kind, const std::string& subject) {
    unread_[kind].push_back(subject);
  }
  /// One line per kind, ordered by kind: "what: a, b, c and 9 more".
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  std::map<std::string, std::vector<std::string>> subjects_;
  std::map<std::string, std::vector<std::string>> unread_;
};

}  // namespace castaway::sim
