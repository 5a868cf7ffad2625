// Commands that end at any call that renames or removes a file: the same command afterwards leaves
// the same bytes as one that was not disturbed. CASTAWAY_KILLS sets how many of the calls are tried
// for each command, drawn at random; the default is 4.
#include <numeric>

#include <fmt/format.h>

#include "localization/geometry/random.hpp"
#include "tests/program/campaign_files.hpp"
#include "tests/program/killed.hpp"

namespace castaway::test {
namespace {

constexpr const char* kRun = R"(name: little
world: room.yaml
duration_s: 2
physics: kinematic
start: {random: true}
drive: {route: random}
lidar: {beams: 36, rate_hz: 5}
localizers: [mh_amcl]
events:
  - kidnap: {kind: teleport, at_s: 1.1, min_distance_m: 2}
expect:
  mh_amcl.wrong_lock_share: "< 0.9"
outputs: {player: true, report: true, snapshots: false, map: true, bag: true, tables: [csv]}
)";

/// A command line, and those before it.
struct Written {
  std::string name;
  std::string command;
  std::vector<std::string> before{};
};

void PrintTo(const Written& written, std::ostream* out) { *out << written.command; }

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool holds_no_file(const fs::path& folder) {
  return fs::is_directory(folder) &&
         std::all_of(fs::recursive_directory_iterator(folder), fs::recursive_directory_iterator{},
                     [](const auto& entry) { return entry.is_directory(); });
}

/// Files without what a clock measured; hidden folders and empty folders count.
std::map<std::string, std::string> lasting_files(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().lexically_relative(folder).string();
    const std::string name = entry.path().filename().string();
    if (entry.is_directory()) files[path] = "a folder";
    if (!entry.is_regular_file() || name.starts_with("std")) continue;
    if (name.starts_with("timing.") || name.starts_with("costs.")) continue;
    std::string text = text_of(entry.path());
    if (name == "report.html") {
      const std::size_t begin = text.find("<!-- timing: begin -->");
      text = text.substr(0, begin) + text.substr(text.find("<!-- timing: end -->"));
    }
    if (name == "junit.xml" || name == ".castaway.json" || name.starts_with("rows")) text = "there";
    files[path] = text;
  }
  return files;
}

class EndedAnywhere : public testing::TestWithParam<Written> {
 protected:
  EndedAnywhere() : folder_(folder_with_spec()), count_(folder_ / "count") {
    write(folder_ / "inputs/r.yaml", kRun);
    write(folder_ / "inputs/c.yaml", kGrid);
    for (const char* file : {"s.yaml", "room.yaml", "room.pgm"}) {
      fs::rename(folder_ / file, folder_ / "inputs" / file);
    }
    for (const std::string& command : GetParam().before) {
      const Outcome outcome = castaway(folder_ / "inputs", command);
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
  }

  /// A copy of the inputs with what the commands before leave.
  [[nodiscard]] fs::path prepare_folder(const std::string& name) const {
    const fs::path place = folder_ / name;
    fs::remove_all(place);
    fs::copy(folder_ / "inputs", place, fs::copy_options::recursive);
    return place;
  }

  /// Runs the command until call `at`; 0: to its end. Returns the number of calls.
  unsigned play_until(const fs::path& place, unsigned at, bool full) const {
    fs::remove(count_);
    std::vector<std::string> environment{"LD_PRELOAD=" CASTAWAY_ENDS_AT,
                                         "CASTAWAY_COUNT=" + count_.string(),
                                         "CASTAWAY_AT=" + std::to_string(at)};
    if (full) environment.emplace_back("CASTAWAY_FULL=1");
    play_in_group(place, words_of(GetParam().command), environment);
    unsigned calls = 0;
    std::ifstream(count_, std::ios::binary).read(reinterpret_cast<char*>(&calls), sizeof calls);
    return calls;
  }

  /// Some of the numbers 1 to `calls`.
  static std::vector<unsigned> draw_calls(unsigned calls) {
    std::vector<unsigned> all(calls);
    std::iota(all.begin(), all.end(), 1U);
    localization::Rng rng = localization::substream(1, GetParam().name);
    const auto most = static_cast<std::size_t>(wanted_kills());
    for (std::size_t i = 0; i < std::min(most, all.size()); ++i) {
      std::swap(all[i], all[i + rng() % (all.size() - i)]);
    }
    if (all.size() > most) all.resize(most);
    return all;
  }

  /// Disturbs the command at calls, repeats it, and compares.
  void expect_the_same_bytes(bool full) const {
    const fs::path whole = prepare_folder("whole");
    const unsigned calls = play_until(whole, 0, false);
    const auto expected = lasting_files(whole);
    ASSERT_GT(calls, 0U);
    for (const unsigned at : draw_calls(calls)) {
      SCOPED_TRACE(fmt::format("call {} of {}", at, calls));
      const fs::path place = prepare_folder("disturbed");
      play_until(place, at, full);
      const Outcome again = castaway(place, GetParam().command);
      ASSERT_EQ(again.exit_code, 0) << again.err;
      const auto files = lasting_files(place);
      for (const auto& [path, bytes] : expected) {
        ASSERT_TRUE(files.contains(path)) << path;
        EXPECT_TRUE(files.at(path) == bytes) << path;
      }
      for (const auto& [path, bytes] : files) {
        const bool stays = full && holds_no_file(place / path);  // It could not be removed.
        EXPECT_TRUE(stays || expected.contains(path)) << path;
      }
    }
  }

  fs::path folder_;
  fs::path count_;
};

TEST_P(EndedAnywhere, KilledItComesOutTheSame) { expect_the_same_bytes(false); }

TEST_P(EndedAnywhere, OnAFullDiskItComesOutTheSame) { expect_the_same_bytes(true); }

INSTANTIATE_TEST_SUITE_P(
    Commands, EndedAnywhere,
    testing::Values(
        Written{"run", "run r.yaml --out out --junit junit.xml"},
        Written{"run_again", "run r.yaml --out out", {"run r.yaml --out out --seed 2"}},
        Written{"seeds", "run r.yaml --seeds 2 -j 2 --out out --junit out/junit.xml"},
        Written{"seeds_again",
                "run r.yaml --seeds 2 -j 2 --out out",
                {"run r.yaml --seeds 3..4 -j 2 --out out"}},
        Written{"replay",
                "replay out/bag --map out/map/map.yaml --out again",
                {"run r.yaml --out out"}},
        Written{"report", "report out", {"run r.yaml --out out"}},
        Written{"reports", "report out", {"run r.yaml --seeds 2 --out out"}},
        Written{"compare", "compare a b --out page", {"run r.yaml --out a", "run r.yaml --out b"}},
        Written{"campaign", "campaign c.yaml -j 2 --out out"},
        Written{"campaign_retried",
                "campaign c.yaml -j 2 --retry-failed --out out",
                {"campaign c.yaml -j 2 --out out"}},
        Written{"dataset", "dataset s.yaml -n 3 -j 2 --out out"},
        Written{"dataset_extended",
                "dataset s.yaml -n 3 -j 2 --out out",
                {"dataset s.yaml -n 2 -j 2 --out out"}},
        Written{"map", "map lab --out map.yaml"},
        Written{"map_again", "map lab --out map.yaml", {"map lab --out map.yaml"}},
        Written{"check_robot", "check-robot waffle --out robot.png"},
        Written{"check_world", "check-world room.yaml --out world.png"},
        Written{"observation", "observation r.yaml --time 1 --out seen.png"}),
    [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace castaway::test
