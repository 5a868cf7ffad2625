// Runs docs/your-localizer.md word by word, as a reader would, and checks messages against the
// schema of the protocol.
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace castaway::test {
namespace {

using Json = nlohmann::json;

const fs::path kRoot = CASTAWAY_SOURCE_DIR;

/// All shell blocks of a page, in their order.
std::string shell_blocks(const fs::path& page) {
  std::istringstream text(text_of(page));
  std::string script = "set -e\n";
  bool block = false;
  for (std::string line; std::getline(text, line);) {
    if (line == "```sh") {
      block = true;
    } else if (line == "```") {
      block = false;
    } else if (block) {
      script += line + "\n";
    }
  }
  return script;
}

TEST(YourLocalizerPage, RunsWordByWord) {
  const fs::path folder = fresh_folder();
  fs::create_directories(folder / "bin");
  fs::create_symlink(CASTAWAY_PROGRAM, folder / "bin/castaway");
  for (const char* part : {"examples", "include"}) fs::create_symlink(kRoot / part, folder / part);
  write(folder / "page.sh", shell_blocks(kRoot / "docs/your-localizer.md"));
  const std::string command =
      "cd '" + folder.string() + "' && PATH=\"$PWD/bin:$PATH\" bash page.sh >page.log 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << text_of(folder / "page.log");
  for (const char* report : {"mine/run/report.html", "mine/still/report.html"}) {
    EXPECT_TRUE(fs::exists(folder / report)) << report;
  }
  const Json summary = Json::parse(text_of(folder / "mine/run/summary.json"));
  EXPECT_TRUE(summary.at("localizers").contains("mine"));
  EXPECT_FALSE(summary.contains("failed"));
  EXPECT_NE(text_of(folder / "mine/run/report.html").find("mine"), std::string::npos);
}

/// A program that records the conversation, and Debian's python3-jsonschema as the judge.
TEST(Protocol, EveryMessageFitsItsSchema) {
  const std::string python = python_with("jsonschema");
  if (python.empty()) GTEST_SKIP() << "needs python3-jsonschema";
  const fs::path folder = fresh_folder();
  write(folder / "tee.sh", "tee to.jsonl | \"$@\" | tee from.jsonl\n");
  const Outcome outcome =
      castaway(folder,
               "run --duration 12 --set events.0.kidnap.at_s=5 --set outputs.snapshots=false --out "
               "run --localizer "
               "'program:sh tee.sh " CASTAWAY_PROGRAM " serve amcl:amcl-global'");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  write(folder / "judge.py", R"(
import collections, json, sys
import jsonschema
validator = jsonschema.Draft202012Validator(json.load(open(sys.argv[1])))
counts = collections.Counter()
for name in ["to.jsonl", "from.jsonl"]:
    for line in open(name):
        validator.validate(json.loads(line))
        counts[json.loads(line)["type"]] += 1
for wrong in [{"type": "estimate"}, {"type": "ready", "x": 1}, {"type": "dance"},
              {"type": "estimate", "stamp_ns": 1, "probability": 2}]:
    assert not validator.is_valid(wrong), wrong
print(json.dumps(counts))
)");
  const std::string command = "cd '" + folder.string() + "' && " + python + " judge.py '" +
                              (kRoot / "docs/protocol.schema.json").string() + "' >counts 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << text_of(folder / "counts");
  const Json counts = Json::parse(text_of(folder / "counts"));
  for (const char* type : {"hello", "initialize", "ready", "bye"}) EXPECT_EQ(counts.at(type), 1);
  EXPECT_GT(counts.at("scan"), 100);
  EXPECT_EQ(counts.at("estimate"), counts.at("scan"));
  EXPECT_GT(counts.at("odometry"), 200);
}

}  // namespace
}  // namespace castaway::test
