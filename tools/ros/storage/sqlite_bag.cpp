#include "tools/ros/storage/sqlite_bag.hpp"

#include <sqlite3.h>

#include <fstream>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "tools/base/files/file.hpp"

namespace castaway::testbed {
namespace {

constexpr std::string_view kSqliteMagic{"SQLite format 3\0", 16};
constexpr int kLargestBlob = 256 << 20;

/// Text of a column; empty for NULL.
std::string text_in(sqlite3_stmt* row, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(row, column));
  const int size = sqlite3_column_bytes(row, column);
  return text != nullptr ? std::string(text, static_cast<std::size_t>(size)) : std::string();
}

/// The file's URI. Without a journal beside it, it is read as it is, so that nothing is written
/// beside it.
std::string uri_of(const std::filesystem::path& path) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    const auto byte = static_cast<unsigned char>(c);
    uri += c == '%' || c == '?' || c == '#' ? fmt::format("%{:02x}", byte) : std::string(1, c);
  }
  std::error_code none;
  const bool journal = std::filesystem::exists(path.string() + "-wal", none) ||
                       std::filesystem::exists(path.string() + "-journal", none);
  return uri + (journal ? "?mode=ro" : "?mode=ro&immutable=1");
}

}  // namespace

bool is_sqlite(const std::filesystem::path& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return false;
  std::string head(kSqliteMagic.size(), ' ');
  std::ifstream(path, std::ios::binary)
      .read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == kSqliteMagic;
}

void SqliteBag::Closer::operator()(sqlite3* database) const { sqlite3_close_v2(database); }
void SqliteBag::Closer::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

SqliteBag::SqliteBag(const std::filesystem::path& path) : name_(path.string()) {
  require_regular_file(path);
  sqlite3* database = nullptr;
  const int code = sqlite3_open_v2(uri_of(path).c_str(), &database,
                                   SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  database_.reset(database);
  if (code != SQLITE_OK) fail("cannot be opened");
  sqlite3_limit(database, SQLITE_LIMIT_LENGTH, kLargestBlob);
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  require_tables();
  read_topics();
  messages_ = prepare("SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp, id");
}

void SqliteBag::fail(const std::string& what) const {
  throw std::runtime_error(
      fmt::format("{}: {} ({}); record it again, or repair it by sqlite3's .recover", name_, what,
                  database_ ? sqlite3_errmsg(database_.get()) : "no memory"));
}

SqliteBag::Statement SqliteBag::prepare(const char* query) const {
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database_.get(), query, -1, &statement, nullptr) != SQLITE_OK) {
    fail("is no bag of ROS 2");
  }
  return Statement(statement);
}

/// Takes a statement to its next row; false at the end.
bool SqliteBag::step(sqlite3_stmt* statement) const {
  const int code = sqlite3_step(statement);
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) fail("is damaged");
  return false;
}

/// Views could compute anything, for any time.
void SqliteBag::require_tables() const {
  const Statement count = prepare(
      "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name IN ('topics', 'messages')");
  if (!step(count.get()) || sqlite3_column_int(count.get(), 0) != 2) {
    throw std::runtime_error(name_ +
                             ": is a database of sqlite3, but no bag of ROS 2: it has no tables "
                             "'topics' and 'messages'");
  }
}

void SqliteBag::read_topics() {
  const Statement rows = prepare("SELECT id, name, type, serialization_format FROM topics");
  while (step(rows.get())) {
    const auto schema = static_cast<std::uint16_t>(schemas_.size() + 1);
    if (schema == std::numeric_limits<std::uint16_t>::max()) fail("holds too many topics");
    schemas_[schema] = {text_in(rows.get(), 2), "ros2msg", ""};
    channels_[sqlite3_column_int64(rows.get(), 0)] = {
        schema, text_in(rows.get(), 1), text_in(rows.get(), 3), {}};
  }
}

std::optional<McapMessage> SqliteBag::next() {
  if (!step(messages_.get())) return std::nullopt;
  const auto channel = channels_.find(sqlite3_column_int64(messages_.get(), 0));
  if (channel == channels_.end()) fail("holds a message of a topic that it does not name");
  const auto* data = static_cast<const char*>(sqlite3_column_blob(messages_.get(), 2));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(messages_.get(), 2));
  return McapMessage{&channel->second, sqlite3_column_int64(messages_.get(), 1),
                     data != nullptr ? std::string_view(data, size) : std::string_view()};
}

const McapSchema* SqliteBag::schema_of(const McapChannel& channel) const {
  const auto found = schemas_.find(channel.schema);
  return found != schemas_.end() ? &found->second : nullptr;
}

}  // namespace castaway::testbed
