/// Reads the sqlite3 files of rosbag2: the tables `topics` and `messages`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "tools/ros/storage/mcap_directory.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace castaway::testbed {

/// True if a file begins as sqlite3's do.
bool is_sqlite(const std::filesystem::path& path);

/// A file being read; it is never written. Errors are std::runtime_error "file: what; remedy".
class SqliteBag {
 public:
  /// Throws if the file is damaged or holds no tables of rosbag2.
  explicit SqliteBag(const std::filesystem::path& path);

  /// The next message by log time, valid until the call after it; nothing at the end.
  std::optional<McapMessage> next();
  /// Schema of a channel: the type's name alone.
  [[nodiscard]] const McapSchema* schema_of(const McapChannel& channel) const;

 private:
  struct Closer {
    void operator()(sqlite3* database) const;
    void operator()(sqlite3_stmt* statement) const;
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Closer>;

  [[noreturn]] void fail(const std::string& what) const;
  Statement prepare(const char* query) const;
  bool step(sqlite3_stmt* statement) const;
  void require_tables() const;
  void read_topics();

  std::string name_;
  std::unique_ptr<sqlite3, Closer> database_;
  std::map<std::int64_t, McapChannel> channels_;  ///< By the topic's id.
  std::map<std::uint16_t, McapSchema> schemas_;   ///< By `McapChannel::schema`.
  Statement messages_;
};

}  // namespace castaway::testbed
