/// The folder of a campaign.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

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
class CampaignFolder {
 public:
  /// Creates the folder or goes on in it. Throws std::runtime_error with one line if it holds other
  /// files, or a campaign of another identity; FileError where nothing can be written.
  CampaignFolder(std::filesystem::path folder, const CampaignIdentity& identity);
  /// Opens the folder of a campaign, whatever made it. Throws std::runtime_error if it is none.
  explicit CampaignFolder(std::filesystem::path folder);

  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
  /// Writes a table; `write` is called with the path of a draft. Throws std::runtime_error if it
  /// would replace a file that castaway did not write or that was changed since.
  template <typename Write>
  void put(const std::string& name, Write write) {
    clear_draft(name);
    write(draft_of(name));
    commit(name);
  }

 private:
  [[nodiscard]] std::filesystem::path draft_of(const std::string& name) const;
  /// Removes what a killed process left, or a link that would be written through.
  void clear_draft(const std::string& name) const;
  void commit(const std::string& name) const;

  std::filesystem::path folder_;
};

}  // namespace castaway::testbed
