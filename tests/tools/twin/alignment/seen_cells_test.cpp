#include "tools/twin/alignment/seen_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <boost/random/uniform_real_distribution.hpp>

namespace castaway::testbed {
namespace {

using SeenBeam = SeenCells::Beam;

const localization::GridFrame kSeenFrame{10, 5, 0.05, {3.0, -2.0, 0.7}};

/// Counts by cell as digits, first line on top; '.' for 0.
std::vector<std::string> counts_art(const SeenCells& seen, bool returns) {
  std::vector<std::string> lines;
  for (int row = kSeenFrame.height - 1; row >= 0; --row) {
    std::string line;
    for (int column = 0; column < kSeenFrame.width; ++column) {
      const Eigen::Vector2d p(column + 0.5, row + 0.5);
      const int count = returns ? seen.returns(p) : seen.passes(p);
      line += count == 0 ? "." : std::to_string(count);
    }
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> passes_art(const SeenCells& seen) { return counts_art(seen, false); }
std::vector<std::string> returns_art(const SeenCells& seen) { return counts_art(seen, true); }

/// A beam along the middle row from column 0.
SeenBeam middle_beam(double end, bool returns) { return {{0.5, 2.5}, {end, 2.5}, returns}; }

/// Length of a segment within a cell, by fine steps. [cells]
double chord_in(const SeenBeam& beam, double until, const Eigen::Vector2i& cell) {
  constexpr double kFine = 1e-3;
  const Eigen::Vector2d direction = (beam.end - beam.from).normalized();
  double chord = 0.0;
  for (double t = 0.0; t < until; t += kFine) {
    const Eigen::Vector2d p = beam.from + t * direction;
    if (std::floor(p.x()) == cell.x() && std::floor(p.y()) == cell.y()) chord += kFine;
  }
  return chord;
}

TEST(SeenCells, ABeamPassesCellsUpToOneAndAHalfBeforeItsEnd) {
  SeenCells seen(kSeenFrame);
  seen.add_scan({middle_beam(8.5, true)});
  EXPECT_EQ(passes_art(seen), (std::vector<std::string>{
                                  "..........",  //
                                  "..........",  //
                                  "1111111...",  //
                                  "..........",  //
                                  "..........",
                              }));
  EXPECT_EQ(returns_art(seen), (std::vector<std::string>{
                                   "..........",  //
                                   "..........",  //
                                   "........1.",  //
                                   "..........",  //
                                   "..........",
                               }));
}

TEST(SeenCells, ABeamWithoutReturnOnlyPasses) {
  SeenCells seen(kSeenFrame);
  seen.add_scan({middle_beam(8.5, false)});
  EXPECT_EQ(passes_art(seen)[2], "1111111...");
  EXPECT_EQ(returns_art(seen)[2], "..........");
}

TEST(SeenCells, GoesUpwardsAndBackwards) {
  SeenCells seen(kSeenFrame);
  seen.add_scan({{{9.5, 0.5}, {4.5, 0.5}, true}, {{1.5, 0.5}, {1.5, 4.5}, true}});
  EXPECT_EQ(passes_art(seen), (std::vector<std::string>{
                                  "..........",  //
                                  "..........",  //
                                  ".1........",  //
                                  ".1........",  //
                                  ".1....1111",
                              }));
  EXPECT_EQ(returns_art(seen), (std::vector<std::string>{
                                   ".1........",  //
                                   "..........",  //
                                   "..........",  //
                                   "..........",  //
                                   "....1.....",
                               }));
}

TEST(SeenCells, CountsACellOnceInAScanAndAgainInTheNext) {
  SeenCells seen(kSeenFrame);
  const std::vector<SeenBeam> beams(5, middle_beam(8.5, true));
  seen.add_scan(beams);
  EXPECT_EQ(passes_art(seen)[2], "1111111...");
  EXPECT_EQ(returns_art(seen)[2], "........1.");
  seen.add_scan(beams);
  seen.add_scan({middle_beam(3.5, false)});
  EXPECT_EQ(passes_art(seen)[2], "3322222...");
  EXPECT_EQ(returns_art(seen)[2], "........2.");
}

TEST(SeenCells, AReturnCountsMoreThanPassing) {
  SeenCells seen(kSeenFrame);
  seen.add_scan({middle_beam(9.5, false), middle_beam(4.5, true)});
  EXPECT_EQ(passes_art(seen)[2], "1111.111..");
  EXPECT_EQ(returns_art(seen)[2], "....1.....");
}

TEST(SeenCells, MarksPointsOfTheScanAtHand) {
  SeenCells seen(kSeenFrame);
  for (int scan = 0; scan < 3; ++scan) {
    seen.begin_scan();
    seen.mark({2.5, 1.5}, true);
    seen.mark({2.1, 1.9}, true);   // the same cell
    seen.mark({2.5, 1.5}, false);  // after a return
    seen.mark({3.5, 1.5}, false);
    seen.mark({3.5, 1.5}, false);
  }
  EXPECT_EQ(returns_art(seen)[3], "..3.......");
  EXPECT_EQ(passes_art(seen)[3], "...3......");
}

TEST(SeenCells, AreCountedByIndexToo) {
  SeenCells seen(kSeenFrame);
  seen.add_scan({{{0.5, 3.5}, {6.5, 3.5}, true}});
  EXPECT_EQ(seen.returns(kSeenFrame.index({6, 3})), 1);
  EXPECT_EQ(seen.passes(kSeenFrame.index({2, 3})), 1);
  EXPECT_EQ(seen.passes(kSeenFrame.index({2, 2})), 0);
}

TEST(SeenCells, IgnoreWhatIsOffTheMap) {
  SeenCells seen(kSeenFrame);
  seen.add_scan({{{-6.0, 2.5}, {16.0, 2.5}, true}, {{4.5, 2.5}, {4.5, -0.5}, true}});
  EXPECT_EQ(passes_art(seen)[2], "1111111111");
  for (const std::string& line : returns_art(seen)) EXPECT_EQ(line, "..........");
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(-0.5, 2.5), Eigen::Vector2d(10.5, 2.5),
                                   Eigen::Vector2d(4.5, -0.5), Eigen::Vector2d(4.5, 5.5)}) {
    EXPECT_EQ(seen.returns(p), 0);
    EXPECT_EQ(seen.passes(p), 0);
  }
}

TEST(SeenCells, ABeamWithoutLengthReturnsWhereItBegins) {
  SeenCells seen(kSeenFrame);
  seen.add_scan({{{4.5, 2.5}, {4.5, 2.5}, true}});
  EXPECT_EQ(returns_art(seen)[2], "....1.....");
  EXPECT_EQ(passes_art(seen)[2], "..........");
}

TEST(SeenCells, StopCountingAtTheirLimit) {
  constexpr int kLimit = std::numeric_limits<std::uint16_t>::max();
  SeenCells seen(kSeenFrame);
  for (int scan = 0; scan < kLimit + 10; ++scan) {
    seen.begin_scan();
    seen.mark({0.5, 0.5}, true);
    seen.mark({1.5, 0.5}, false);
  }
  EXPECT_EQ(seen.returns({0.5, 0.5}), kLimit);
  EXPECT_EQ(seen.passes({1.5, 0.5}), kLimit);
}

TEST(SeenCells, AnyBeamPassesTheCellsThatItCrosses) {
  localization::Rng rng = localization::substream(1, "beams");
  boost::random::uniform_real_distribution<double> x(0.0, 10.0);
  boost::random::uniform_real_distribution<double> y(0.0, 5.0);
  for (int k = 0; k < 30; ++k) {
    SeenBeam beam;
    beam.from = {x(rng), y(rng)};
    beam.end = {x(rng), y(rng)};
    SeenCells seen(kSeenFrame);
    seen.add_scan({beam});
    const double until = (beam.end - beam.from).norm() - 1.5;
    for (int row = 0; row < kSeenFrame.height; ++row) {
      for (int column = 0; column < kSeenFrame.width; ++column) {
        const int passes = seen.passes(kSeenFrame.index({column, row}));
        const double chord = chord_in(beam, until, {column, row});
        EXPECT_GE(passes, chord > 0.71 ? 1 : 0) << column << " " << row;
        EXPECT_LE(passes, chord > 0.0 ? 1 : 0) << column << " " << row;
      }
    }
  }
}

}  // namespace
}  // namespace castaway::testbed
