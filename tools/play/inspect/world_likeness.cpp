#include "tools/play/inspect/world_likeness.hpp"

#include "sim/map/ground.hpp"
#include "sim/map/rasterise.hpp"

namespace castaway::testbed {

sim::Grid obstacle_grid(const LoadedWorld& world) {
  sim::Grid grid = world.grid;
  std::vector<double> heights;
  for (double z = 0.02; z < 0.35; z += 0.04) heights.push_back(z);
  const std::vector<float> ground = sim::ground_heights(world.file.spec, grid);
  sim::free_raised(grid, ground);
  sim::mark_objects(grid, world.file.spec, heights);
  sim::mark_ledges(grid, ground);
  return grid;
}

sim::FreeSpace place_space(const LoadedWorld& world) {
  sim::Grid grid = obstacle_grid(world);
  sim::mark_raised(grid, sim::ground_heights(world.file.spec, grid));
  return {grid, kPlaceRadius};
}

sim::PlaceLikeness world_likeness(const LoadedWorld& world, const sim::PlaceView& view) {
  return sim::place_likeness(sim::level_scene(world.file.spec, view.z), place_space(world), view);
}

}  // namespace castaway::testbed
