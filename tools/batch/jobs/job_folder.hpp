/// The folder of a batch of jobs.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace castaway::testbed {

/// What a batch is made from. It never changes within one folder.
struct JobIdentity {
  std::string kind;     ///< "campaign", "evaluation": names its files.
  std::string version;  ///< Version of the program.
  std::string program;  ///< Its hash.
  std::string data;     ///< Hash of the worlds, robots and logs that it reads.
  std::string spec;     ///< What is asked for, as YAML.
};

/// The files <kind>.json and <kind>.yaml say whose a folder is.
struct FolderMark {
  std::string kind;     ///< "dataset"
  std::string name;     ///< In words: "data set".
  std::string version;  ///< Of the program.
  /// What else differs from the <kind>.json that is there, as the end of a sentence; empty:
  /// nothing.
  std::function<std::string(const nlohmann::ordered_json& there)> difference;
};

/// Throws std::runtime_error with one line if the folder is none, holds other files, or differs.
void check_folder(const std::filesystem::path& folder, const FolderMark& mark);

/// The identity of a batch of this program.
JobIdentity identity_of_this_program(std::string kind, std::string data, std::string spec);

/// The folder of a campaign:
///
///     campaign.json, campaign.yaml       the identity
///     rows.jsonl, rows-2-of-8.jsonl      a line for each job: RowsFile
///     .work-rows.jsonl/                  drafts of the process that adds to rows.jsonl
///     results.csv, ...                   tables, once all rows are there
///     .castaway.json                     the list of the identity and the tables
class JobFolder {
 public:
  /// Creates the folder or goes on in it. Throws std::runtime_error with one line if it holds other
  /// files, or a batch of another identity; FileError where nothing can be written.
  JobFolder(std::filesystem::path folder, const JobIdentity& identity);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  /// Writes a table; `write` is called with the path of a draft. Throws as `put_own_file` does.
  void put(const std::string& name,
           const std::function<void(const std::filesystem::path& draft)>& write) const;
  void put(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path folder_;
};

/// Throws std::runtime_error if `folder` is not the folder of a batch of this kind.
void require_job_folder(const std::filesystem::path& folder, const std::string& kind);

}  // namespace castaway::testbed
