/// A file of a ROS 2 bag, whatever stores it: MCAP, or sqlite3, the default of ROS 2 Humble.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tools/ros/storage/mcap_reader.hpp"
#include "tools/ros/storage/sqlite_bag.hpp"

namespace castaway::testbed {

/// Reads messages in the order of the file (sqlite3: of their log times). Messages that
/// `ros2 bag record --compression-mode message` compressed are unpacked.
class BagFile {
 public:
  /// Throws std::runtime_error if the file cannot be opened or is neither MCAP nor sqlite3.
  explicit BagFile(const std::filesystem::path& path);

  /// The next message, valid until the call after it; nothing at the end. Throws as the reader of
  /// the storage does, and if a compressed message is damaged or longer than 256 MiB.
  std::optional<McapMessage> next();
  /// Schema of a channel; nothing if it has none.
  [[nodiscard]] const McapSchema* schema_of(const McapChannel& channel) const;
  /// Attachments and metadata of the part that was read; sqlite3 has none.
  [[nodiscard]] std::vector<McapAttachmentInfo> attachments() const;
  [[nodiscard]] std::map<std::string, std::map<std::string, std::string>> metadata() const;
  /// After the end: why the file is incomplete; nothing if it is complete.
  [[nodiscard]] std::optional<std::string> warning() const;

 private:
  std::string name_;
  std::variant<McapReader, SqliteBag> reader_;
  std::string unpacked_;  ///< The newest message, if it was compressed.
};

}  // namespace castaway::testbed
