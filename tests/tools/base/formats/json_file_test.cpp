#include "tools/base/formats/json_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

std::string nested(int depth) {
  return std::string(static_cast<std::size_t>(depth), '[') +
         std::string(static_cast<std::size_t>(depth), ']');
}

TEST(JsonFile, IsReadWithItsKeysInOrder) {
  const TemporaryFolder folder;
  const auto path = folder.put("a.json", R"({"b": 1, "a": "[[[{\"{"})");
  EXPECT_EQ(read_json(path).dump(), R"({"b":1,"a":"[[[{\"{"})");
}

TEST(JsonFile, ThatIsBrokenOrNotThereIsNamed) {
  const TemporaryFolder folder;
  const auto path = folder.put("a.json", "{\"b\": ");
  EXPECT_TRUE(contains(error_of([&] { read_json(path); }), path.string() + ": broken JSON"));
  EXPECT_TRUE(contains(error_of([&] { read_json(folder.path() / "b"); }), "cannot be read"));
}

TEST(JsonFile, ThatIsNestedTooDeepIsRefused) {
  const TemporaryFolder folder;
  EXPECT_NO_THROW(read_json(folder.put("a.json", nested(100))));
  for (const int depth : {101, 5000, 1000000}) {
    const auto path = folder.put("a.json", nested(depth));
    EXPECT_TRUE(contains(error_of([&] { read_json(path); }), "nested more than 100 deep"));
  }
}

TEST(JsonFile, WithOtherFieldsThanCastawaysIsNamed) {
  const nlohmann::ordered_json json{{"seed", "x"}};
  EXPECT_EQ(error_of([&] { read_fields("run/s.json", [&] { json.at("seed").get<int>(); }); }),
            "run/s.json: damaged, or not castaway's: type must be number, but is string; run it "
            "again");
  EXPECT_NO_THROW(read_fields("run/s.json", [&] { json.at("seed").get<std::string>(); }));
}

TEST(JsonText, NestsInBracketsOutsideOfTexts) {
  EXPECT_FALSE(nests_too_deep("[\"" + std::string(1000, '[') + "\"]"));
  EXPECT_TRUE(nests_too_deep("[\"\\\"\"," + std::string(1000, '{')));
  std::string wide;
  for (int i = 0; i < 1000; ++i) wide += "[],";
  EXPECT_FALSE(nests_too_deep(wide));
}

}  // namespace
}  // namespace castaway::testbed
