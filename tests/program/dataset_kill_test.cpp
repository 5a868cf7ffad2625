// Data sets whose process is killed while they are made.
#include <chrono>

#include "localization/geometry/random.hpp"
#include "tests/program/dataset_files.hpp"
#include "tests/program/killed.hpp"

namespace castaway::test {
namespace {

// CASTAWAY_KILLS sets the number of kills; the default is 4.
TEST(Dataset, KilledAtAnyMomentItGoesOnAndComesOutTheSame) {
  const fs::path folder = folder_with_spec();
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(castaway(folder, "dataset s.yaml -n 6 -j 2 --out whole").exit_code, 0);
  const auto whole = std::chrono::steady_clock::now() - begin;
  const int kills = wanted_kills();
  localization::Rng rng = localization::substream(1, "kills");
  int killed = 0;
  for (int tries = 0; killed < kills; ++tries) {
    const auto most = std::chrono::duration_cast<std::chrono::microseconds>(whole).count();
    const auto wait =
        std::chrono::microseconds(rng() % static_cast<std::uint64_t>(std::max<long>(most, 1)));
    const bool in_time =
        killed_after(folder, {"dataset", "s.yaml", "-n", "6", "-j", "2", "--out", "set"}, wait);
    killed += in_time ? 1 : 0;
    if (!fs::exists(folder / "set/manifest.json")) continue;
    // It finished before it could be killed, or was killed while it removed its drafts.
    ASSERT_EQ(castaway(folder, "dataset s.yaml -n 6 -j 2 --out set").exit_code, 0);
    expect_equal(folder / "whole", folder / "set");
    fs::remove_all(folder / "set");
  }
  const Outcome last = castaway(folder, "dataset s.yaml -n 6 -j 2 --out set");
  ASSERT_EQ(last.exit_code, 0) << last.err;
  expect_equal(folder / "whole", folder / "set");
}

}  // namespace
}  // namespace castaway::test
