/// The folder of a campaign.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace castaway::testbed {

/// What a campaign is made from. It never changes within one folder.
struct CampaignIdentity {
  std::string version;  ///< Version of the program.
  std::string program;  ///< Its hash.
  std::string data;     ///< Hash of the worlds, robots and logs that it reads.
  std::string spec;     ///< `CampaignSpec::effective`
};

/// The folder:
///
///     campaign.json, campaign.yaml       the identity
///     rows.jsonl, rows-2-of-8.jsonl      a line for each cell: RowsFile
///     cells/000042-0123456789abcdef/     what is kept of a cell
///     .work-rows.jsonl/                  drafts of the process that adds to rows.jsonl
///     results.csv, ...                   tables, once all cells are there
///     .castaway.json                     the list of the identity and the tables
class CampaignFolder {
 public:
  /// Creates the folder or goes on in it. Throws std::runtime_error with one line if it holds other
  /// files, or a campaign of another identity; FileError where nothing can be written.
  CampaignFolder(std::filesystem::path folder, const CampaignIdentity& identity);
  /// Opens the folder of a campaign, whatever made it. Throws std::runtime_error if it is none.
  explicit CampaignFolder(std::filesystem::path folder);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  /// Writes a table; `write` is called with the path of a draft. Throws as `put_own_file` does.
  void put(const std::string& name,
           const std::function<void(const std::filesystem::path& draft)>& write) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace castaway::testbed
