#include "tools/ros/storage/bag_file.hpp"

#include <sqlite3.h>

#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/tools/support/ros_bag.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/bytes/compression.hpp"

namespace castaway::testbed {
namespace {

/// A bag as ROS 2 Humble's rosbag2 stores it.
class HumbleBag {
 public:
  explicit HumbleBag(const std::filesystem::path& path) {
    EXPECT_EQ(sqlite3_open(path.c_str(), &database_), SQLITE_OK);
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
        "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL)");
    run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, "
        "timestamp INTEGER NOT NULL, data BLOB NOT NULL)");
  }
  ~HumbleBag() { sqlite3_close(database_); }
  HumbleBag(const HumbleBag&) = delete;
  HumbleBag& operator=(const HumbleBag&) = delete;

  void run(const std::string& command) {
    ASSERT_EQ(sqlite3_exec(database_, command.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(database_);
  }
  void add_topic(int id, const std::string& name, const std::string& type) {
    run("INSERT INTO topics VALUES(" + std::to_string(id) + ",'" + name + "','" + type +
        "','cdr','')");
  }
  void add(int topic, std::int64_t log_time_ns, const std::string& data) {
    std::string hex;
    for (const char c : data) hex += fmt::format("{:02x}", static_cast<unsigned char>(c));
    run("INSERT INTO messages(topic_id, timestamp, data) VALUES(" + std::to_string(topic) + "," +
        std::to_string(log_time_ns) + ",x'" + hex + "')");
  }

 private:
  sqlite3* database_ = nullptr;
};

/// Topic, type, log time and data of all messages.
std::vector<std::string> messages_in(const std::filesystem::path& path) {
  BagFile file(path);
  std::vector<std::string> messages;
  while (const auto message = file.next()) {
    messages.push_back(message->channel->topic + " " + message->channel->encoding + " " +
                       file.schema_of(*message->channel)->name + " " +
                       std::to_string(message->log_time_ns) + " " + std::string(message->data));
  }
  return messages;
}

TEST(BagFile, ReadsSqliteByLogTime) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a%20?#.db3";
  {
    HumbleBag bag(path);
    bag.add_topic(7, "/b", "t/msg/B");
    bag.add_topic(3, "/a", "t/msg/A");
    bag.add(7, 20, "two");
    bag.add(3, 10, "one");
    bag.add(3, 20, "three");
  }
  const std::string before = read_file(path);
  EXPECT_EQ(messages_in(path),
            (std::vector<std::string>{"/a cdr t/msg/A 10 one", "/b cdr t/msg/B 20 two",
                                      "/a cdr t/msg/A 20 three"}));
  EXPECT_EQ(read_file(path), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(BagFile, UnpacksMessagesThatAreCompressedOneByOne) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.db3";
  const std::string text(1000, 'x');
  {
    HumbleBag bag(path);
    bag.add_topic(1, "/a", "t/msg/A");
    bag.add(1, 10, pack_chunk(text, Compression::kZstd));
    bag.add(1, 11, std::string("\0\1\0\0plain", 9));
  }
  const auto messages = messages_in(path);
  EXPECT_EQ(messages.at(0), "/a cdr t/msg/A 10 " + text);
  EXPECT_EQ(messages.at(1), "/a cdr t/msg/A 11 " + std::string("\0\1\0\0plain", 9));
  {
    HumbleBag bag(folder.path() / "cut.db3");
    bag.add_topic(1, "/a", "t/msg/A");
    bag.add(1, 10, pack_chunk(text, Compression::kZstd).substr(0, 12));
  }
  EXPECT_TRUE(contains(error_of([&] { messages_in(folder.path() / "cut.db3"); }),
                       "cut.db3: topic /a at 10 ns: its compressed message"));
}

TEST(BagFile, RefusesOtherDatabases) {
  const TemporaryFolder folder;
  const auto refusal = [&](const char* name) {
    return error_of([&] { messages_in(folder.path() / name); });
  };
  std::ofstream(folder.path() / "cut.db3") << std::string("SQLite format 3\0cut", 19);
  EXPECT_TRUE(contains(refusal("cut.db3"), "cut.db3: is no bag of ROS 2")) << refusal("cut.db3");
  HumbleBag(folder.path() / "view.db3")
      .run(
          "DROP TABLE messages; CREATE VIEW messages AS WITH RECURSIVE endless(id) AS (SELECT 1 "
          "UNION ALL SELECT id FROM endless) SELECT id, 1 AS topic_id, id AS timestamp, 'x' AS "
          "data FROM endless");
  EXPECT_TRUE(contains(refusal("view.db3"), "it has no tables 'topics' and 'messages'"));
  {
    HumbleBag bag(folder.path() / "topicless.db3");
    bag.add(9, 10, "data");
  }
  EXPECT_TRUE(contains(refusal("topicless.db3"), "a message of a topic that it does not name"));
}

}  // namespace
}  // namespace castaway::testbed
