#include "tests/sim/support/test_people.hpp"

#include "sim/map/rasterise.hpp"

namespace castaway::sim {

Grid TestHall::empty_map() const { return rasterise(world, 0.2, 0.05); }

}  // namespace castaway::sim
