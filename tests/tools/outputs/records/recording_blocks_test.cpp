#include "tools/outputs/records/recording_blocks.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tools/base/bytes/varint.hpp"

namespace castaway::testbed {
namespace {

using localization::PopulationView;

/// The numbers of a block that holds only signed ones.
std::vector<std::int64_t> signed_numbers(std::string_view block) {
  std::vector<std::int64_t> numbers;
  for (VarintReader reader(block); !reader.done();) numbers.push_back(reader.next_signed());
  return numbers;
}

PopulationView population(int id, std::vector<SE2> particles) {
  PopulationView view;
  view.id = id;
  view.T_map_base = {1.0, 2.0, 0.5};
  view.quality = 0.25;
  view.share = 0.75;
  view.selected = true;
  view.particles = std::move(particles);
  return view;
}

TEST(BeamStride, KeepsNoMoreThanAsked) {
  EXPECT_EQ(beam_stride(0, 360), 1U);
  EXPECT_EQ(beam_stride(360, 360), 1U);
  EXPECT_EQ(beam_stride(361, 360), 2U);
  EXPECT_EQ(beam_stride(1081, 360), 4U);
}

TEST(PackBeams, CountsHundredthsAndTellsWhatDidNotComeBack) {
  LaserScan scan;
  const float none = std::numeric_limits<float>::infinity();
  scan.ranges = {1.0F, 1.02F, none, -none, std::nanf(""), 0.0F};
  // 1.00 m is 101, 1.02 m is 103, a miss is 0, 0 m is 1. The lidar's index 3 is unsigned; read as
  // signed it is -2.
  EXPECT_EQ(signed_numbers(pack_beams(3, scan, 1)),
            (std::vector<std::int64_t>{-2, 101, 2, -103, 0, 0, 1}));
}

TEST(PackBeams, TakesEverySecond) {
  LaserScan scan;
  scan.ranges = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F};
  EXPECT_EQ(signed_numbers(pack_beams(0, scan, 2)), (std::vector<std::int64_t>{0, 101, 200, 200}));
}

TEST(PackPopulations, TellsMeanAndParticlesAboutIt) {
  const std::string block =
      pack_populations({population(-1, {{1.1, 2.0, 0.0}, {0.9, 1.97, 0.0}})}, 100);
  VarintReader reader(block);
  EXPECT_EQ(reader.next(), 1U);          // populations
  EXPECT_EQ(reader.next_signed(), -1);   // id
  EXPECT_EQ(reader.next(), 1U);          // the output
  EXPECT_EQ(reader.next_signed(), 750);  // share
  EXPECT_EQ(reader.next_signed(), 250);  // quality
  EXPECT_EQ(reader.next_signed(), 100);  // x
  EXPECT_EQ(reader.next_signed(), 200);  // y
  EXPECT_EQ(reader.next_signed(), 50);   // yaw
  EXPECT_EQ(reader.next(), 2U);          // particles
  EXPECT_EQ(reader.next_signed(), -10);  // x of the left particle
  EXPECT_EQ(reader.next_signed(), -3);   // y of the left particle
  EXPECT_EQ(reader.next_signed(), 20);   // the next one is 0.2 m to the right
  EXPECT_EQ(reader.next_signed(), 0);
  EXPECT_TRUE(reader.done());
}

TEST(PackPopulations, SharesTheRoomAmongPopulations) {
  const std::vector<SE2> many(1000, SE2{1.0, 2.0, 0.0});
  const auto size = [&](std::size_t populations, std::size_t most) {
    return pack_populations(std::vector(populations, population(0, many)), most).size();
  };
  const std::size_t head = size(1, 100) - 200;  // a particle takes two bytes
  EXPECT_EQ(size(2, 100) - 1, 2 * (head - 1 + 100));
  EXPECT_EQ(size(50, 100) - 1, 50 * (head - 1 + 16));  // never fewer than 8 particles
}

TEST(PackPeople, TellsWhoIsWhere) {
  PersonTruth person;
  person.id = 7;
  person.T_map_person = {-1.0, 2.5, 1.0};
  // One person; the count is unsigned: read as signed it is -1.
  EXPECT_EQ(signed_numbers(pack_people({person})),
            (std::vector<std::int64_t>{-1, 7, -100, 250, 100}));
}

TEST(PackPopulations, TellsTheHeightOnSeveralFloors) {
  PopulationView view = population(4, {});
  view.footing = {.z = 3.25, .level = 1};
  const std::string block = pack_populations({view}, 100, true);
  VarintReader reader(block);
  for (int i = 0; i < 3; ++i) reader.next();         // populations, id, selected
  for (int i = 0; i < 5; ++i) reader.next_signed();  // share, quality, x, y, yaw
  EXPECT_EQ(reader.next_signed(), 325);
  EXPECT_EQ(reader.next(), 0U);  // particles
  EXPECT_TRUE(reader.done());
}

}  // namespace
}  // namespace castaway::testbed
