#include "localization/matching/tile_sums.hpp"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "localization/geometry/random.hpp"

namespace castaway::localization {
namespace {

/// Random deficits of 0 ... `highest`, and shifts that read all of them.
struct Case {
  Case(int points, int highest, Rng& rng) : deficits(static_cast<std::size_t>(points) + 15) {
    for (std::uint8_t& d : deficits) {
      d = static_cast<std::uint8_t>(rng() % static_cast<unsigned>(highest + 1));
    }
    shifts.resize(static_cast<std::size_t>(points));
    std::iota(shifts.begin(), shifts.end(), 0);
  }
  /// Sum of a node (c, r), by a naive loop.
  [[nodiscard]] int sum(std::size_t c, std::size_t r) const {
    int sum = 0;
    for (std::size_t i = 0; i < shifts.size(); ++i) sum += deficits[i + 2 * c + r];
    return sum;
  }

  std::vector<std::uint8_t> deficits;
  std::vector<std::int32_t> shifts;
};

void expect_naive_sums(const DeficitSums& sums, const Case& expected) {
  const TileWords words = sums.words();
  int least = expected.sum(0, 0);
  for (std::size_t c = 0; c < 8; ++c) {
    EXPECT_EQ(words.lower[c], expected.sum(c, 0));
    EXPECT_EQ(words.upper[c], expected.sum(c, 1));
    least = std::min({least, expected.sum(c, 0), expected.sum(c, 1)});
  }
  EXPECT_TRUE(sums.any_within(least));
  EXPECT_FALSE(sums.any_within(least - 1));
}

TEST(DeficitSums, EqualTheNaiveLoop) {
  Rng rng = substream(1, "deficit_sums");
  for (const int points : {1, 7, 16, 256}) {
    const Case fine(points, 255, rng);
    DeficitSums sums;
    sums.add_fine(fine.deficits.data(), fine.shifts);
    expect_naive_sums(sums, fine);
  }
}

TEST(DeficitSums, EqualTheNaiveLoopAtCoarseLevels) {
  Rng rng = substream(2, "deficit_sums");
  for (const int points : {1, 7, 16}) {
    const Case coarse(points, 15, rng);
    DeficitSums sums;
    sums.add_coarse(coarse.deficits.data(), coarse.shifts);
    expect_naive_sums(sums, coarse);
  }
}

TEST(DeficitSums, DoNotOverflow) {
  Rng rng = substream(3, "deficit_sums");
  Case worst(256, 255, rng);
  std::fill(worst.deficits.begin(), worst.deficits.end(), std::uint8_t{255});
  DeficitSums fine;
  fine.add_fine(worst.deficits.data(), worst.shifts);
  expect_naive_sums(fine, worst);
  Case coarse(16, 15, rng);
  std::fill(coarse.deficits.begin(), coarse.deficits.end(), std::uint8_t{15});
  DeficitSums sums;
  sums.add_coarse(coarse.deficits.data(), coarse.shifts);
  expect_naive_sums(sums, coarse);
}

}  // namespace
}  // namespace castaway::localization
