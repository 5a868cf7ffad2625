// Tests castaway dataset: making, verifying, reading and reproducing data sets.
#include <nlohmann/json.hpp>

#include "tests/program/dataset_files.hpp"

namespace castaway::test {
namespace {

using OrderedJson = nlohmann::ordered_json;

TEST(Dataset, IsTheSameWhateverTheNumberOfWorkers) {
  const fs::path folder = folder_with_spec();
  const Outcome one = castaway(folder, "dataset s.yaml -n 3 --out one");
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.err, "");
  expect_contains(one.out, "little: 3 sequences, 0.2 min");
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 3 -j 3 --out three").exit_code, 0);
  expect_equal(folder / "one", folder / "three");
  EXPECT_FALSE(fs::exists(folder / "one/.work"));
  const auto files = files_of(folder / "one");
  for (const char* path :
       {"README.md", "manifest.json", "SHA256SUMS", "dataset.yaml", "sequences.csv",
        "splits/train.txt", "maps/room.yaml", "maps/room.pgm", "plots/index.html",
        "plots/coverage-room.png", "sequences/000002/tables.h5",
        "sequences/000002/tables/scans.csv", "sequences/000002/truth.tum",
        "sequences/000002/bag/metadata.yaml", "sequences/000002/scenario.yaml"}) {
    EXPECT_TRUE(files.contains(path)) << path;
  }
  EXPECT_FALSE(files.contains("sequences/000000/timing.json"));
  EXPECT_FALSE(files.contains("sequences/000000/report.html"));
}

TEST(Dataset, IsMadeAgainFromItsOwnSpecification) {
  const fs::path folder = folder_with_spec();
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 3 --seed 5 --out set").exit_code, 0);
  const Outcome again = castaway(folder, "dataset set/dataset.yaml -n 3 --out again --json");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(OrderedJson::parse(again.out).at("sequences"), 3);
  expect_equal(folder / "set", folder / "again");
  const Outcome only = castaway(folder, "dataset set/dataset.yaml --only 2 --out two");
  ASSERT_EQ(only.exit_code, 0) << only.err;
  expect_equal(folder / "set/sequences/000002", folder / "two");
  const Outcome full = castaway(folder, "dataset set/dataset.yaml --only 2 --out two");
  EXPECT_EQ(full.exit_code, 2);
  expect_contains(full.err, "two: is not empty");
}

TEST(Dataset, VerifiesEveryFile) {
  const fs::path folder = folder_with_spec();
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 1 --out set").exit_code, 0);
  const Outcome good = castaway(folder, "dataset --verify set");
  EXPECT_EQ(good.exit_code, 0) << good.out;
  expect_contains(good.out, "set: every file matches its manifest.json");
  if (std::system("sha256sum --version >/dev/null 2>&1") == 0) {
    const std::string check =
        "cd '" + (folder / "set").string() + "' && sha256sum -c --quiet SHA256SUMS";
    EXPECT_EQ(std::system(check.c_str()), 0);
  }
  std::ofstream(folder / "set/sequences/000000/truth.tum") << "1 2 3";
  fs::remove(folder / "set/maps/room.pgm");
  std::ofstream(folder / "set/notes.txt") << "mine";
  const Outcome bad = castaway(folder, "dataset --verify set");
  EXPECT_EQ(bad.exit_code, 1);
  expect_contains(bad.out, "maps/room.pgm: missing\n");
  expect_contains(bad.out, "sequences/000000/truth.tum: changed: 5 bytes instead of ");
  expect_contains(bad.out, "notes.txt: not listed in manifest.json\n");
  expect_contains(bad.err, "3 of its files differ from its manifest.json");
  const Outcome json = castaway(folder, "dataset --verify set --json");
  EXPECT_EQ(json.exit_code, 1);
  EXPECT_EQ(OrderedJson::parse(json.out).at("troubles").size(), 3U);
}

/// Python snippets of a card.
std::vector<std::string> snippets(const std::string& card) {
  const std::string begin = "```python\n";
  std::vector<std::string> found;
  for (std::size_t at = card.find(begin); at != std::string::npos; at = card.find(begin, at + 1)) {
    const std::size_t from = at + begin.size();
    found.push_back(card.substr(from, card.find("```", from) - from));
  }
  return found;
}

/// A Python with the modules that the card's snippets import; empty if there is none.
std::string python_with_readers() {
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    const std::string import = std::string(python) + " -c 'import h5py, numpy, pandas' 2>/dev/null";
    if (std::system(import.c_str()) == 0) return python;
  }
  return "";
}

TEST(Dataset, IsReadByThePythonOfItsCard) {
  const std::string python = python_with_readers();
  if (python.empty()) GTEST_SKIP() << "no python3 with h5py and pandas (python3-h5py, -pandas)";
  const fs::path folder = folder_with_spec();
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 1 --out set").exit_code, 0);
  const auto pieces = snippets(text_of(folder / "set/README.md"));
  ASSERT_EQ(pieces.size(), 2U);
  // Both give the same ranges and classes, within the precision of the text.
  const std::string compare =
      "\nassert np.array_equal(classes, from_h5[1]) and ranges.shape == (20, 36)\n"
      "assert np.allclose(ranges, from_h5[0], atol=1e-4)\n";
  std::ofstream(folder / "set/read.py") << pieces[0] << "\nfrom_h5 = (ranges, classes)\n"
                                        << pieces[1] << compare;
  const std::string run = "cd '" + (folder / "set").string() + "' && " + python + " read.py";
  EXPECT_EQ(std::system((run + " >read.txt").c_str()), 0);
  expect_contains(text_of(folder / "set/read.txt"), "(20, 36)");
}

TEST(Dataset, KeepsToOneSpecificationAndGrows) {
  const fs::path folder = folder_with_spec();
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 1 --out set").exit_code, 0);
  const Outcome same = castaway(folder, "dataset s.yaml -n 1 --out set");
  EXPECT_EQ(same.exit_code, 0);
  expect_contains(same.out, "all 1 sequences are already finished");
  const Outcome json = castaway(folder, "dataset s.yaml -n 1 --out set --json");
  EXPECT_EQ(OrderedJson::parse(json.out).at("timing").at("made"), 0);
  const Outcome seed = castaway(folder, "dataset s.yaml -n 1 --seed 2 --out set");
  EXPECT_EQ(seed.exit_code, 2);
  expect_contains(seed.err, "set: was made with seed 1, not 2; choose another folder");
  const Outcome other = castaway(folder, "dataset s.yaml -n 1 --set duration_s=3 --out set");
  EXPECT_EQ(other.exit_code, 2);
  expect_contains(other.err, "is 'duration_s: 4', now it would be 'duration_s: 3'");
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 2 --out set").exit_code, 0);
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 2 --out at-once").exit_code, 0);
  expect_equal(folder / "set", folder / "at-once");
}

TEST(Dataset, FindsWhatCannotBeBeforeAnythingIsMade) {
  const fs::path folder = folder_with_spec(
      "scenario: {world: lab, duration_s: 5}\nvary:\n  drive.route: {choice: [loop, moon]}\n");
  const Outcome outcome = castaway(folder, "dataset s.yaml -n 9 --out set");
  EXPECT_EQ(outcome.exit_code, 2);
  expect_contains(outcome.err, "s.yaml: sequence ");
  expect_contains(outcome.err, "drive.route = moon");
  EXPECT_FALSE(fs::exists(folder / "set"));
}

TEST(Dataset, TellsTroubleWithTheDiskInOneLine) {
  const fs::path folder = folder_with_spec();
  std::ofstream(folder / "file") << "";
  const Outcome outcome = castaway(folder, "dataset s.yaml -n 1 --out file/set");
  EXPECT_EQ(outcome.exit_code, 2);  // Another folder would do, as in every command.
  expect_contains(outcome.err, "castaway: file/set: cannot be made (Not a directory)");
}

TEST(Dataset, IsMadeByShards) {
  const fs::path folder = folder_with_spec();
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 5 --out one").exit_code, 0);
  const Outcome first = castaway(folder, "dataset s.yaml -n 5 --out set --shard 1/2");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  expect_contains(first.out, "Shard 1 of 2: 3 sequences made");
  EXPECT_FALSE(fs::exists(folder / "set/manifest.json"));
  const Outcome early = castaway(folder, "dataset s.yaml -n 5 --out set --collect");
  EXPECT_EQ(early.exit_code, 1);
  expect_contains(early.err, "3 of 5 sequences are finished; run the shards of the rest again");
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 5 --out set --shard 2/2").exit_code, 0);
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 5 --out set --collect").exit_code, 0);
  expect_equal(folder / "one", folder / "set");
  expect_refused(castaway(folder, "dataset s.yaml -n 5 --out none --collect"),
                 {"none", "no dataset.json"});
}

}  // namespace
}  // namespace castaway::test
