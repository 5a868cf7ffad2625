// Compares ray casts with plain ones (support/plain_cast.hpp): random beams in a hall of boxes,
// cylinders, spheres, capsules, triangles and people. Usage: cast_check [millions of beams]; exit
// code 1 if a range differs by more than 0.1 mm.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "sim/sensor/lidar.hpp"
#include "tests/sim/support/people_scene.hpp"
#include "tests/sim/support/plain_cast.hpp"

namespace {

using namespace castaway::sim;

/// Boxes with some other shapes among them.
std::vector<RayPrimitive> clutter(Rng& rng) {
  std::vector<RayPrimitive> primitives = ray_primitives(hall(40));
  for (int i = 0; i < 20; ++i) {
    RayPrimitive primitive;
    primitive.object = 40 + i;
    const double a = draw_between(0.1, 0.5, rng);
    const double b = draw_between(0.2, 0.8, rng);
    if (i % 4 == 0) primitive.shape = RayCylinder{a, b};
    if (i % 4 == 1) primitive.shape = RaySphere{a};
    if (i % 4 == 2) primitive.shape = RayCapsule{a, b};
    if (i % 4 == 3) primitive.shape = RayTriangle{{0.0, 0.0, -b}, {2.0 * a, 0.0, b}, {0.0, b, b}};
    const Eigen::Vector3d axis(draw_between(-1.0, 1.0, rng), draw_between(-1.0, 1.0, rng), 0.7);
    primitive.T_map_shape =
        Eigen::Translation3d(draw_between(-9.0, 9.0, rng), draw_between(-9.0, 9.0, rng), 0.5) *
        Eigen::AngleAxisd(draw_between(-3.0, 3.0, rng), axis.normalized());
    primitives.push_back(primitive);
  }
  return primitives;
}

}  // namespace

int main(int argc, char** argv) {
  const double millions = argc > 1 ? std::atof(argv[1]) : 1.0;
  Rng rng(11);
  const auto primitives = clutter(rng);
  const auto bodies = strollers(20, rng);
  const RayScene scene(primitives);
  const MovingScene moving(bodies);
  const auto beams = static_cast<long>(1e6 * millions);
  double worst = 0.0;
  long wrong = 0;
  long grazes = 0;
  std::uint32_t guess = kNoPrimitive;
  for (long i = 0; i < beams; ++i) {
    const double bearing = draw_between(-3.2, 3.2, rng);
    const double rise = draw_between(-0.1, 0.1, rng);
    const Eigen::Vector3d origin(draw_between(-9.5, 9.5, rng), draw_between(-9.5, 9.5, rng),
                                 draw_between(0.05, 1.6, rng));
    const Ray ray{origin, Eigen::Vector3d(std::cos(bearing), std::sin(bearing), rise).normalized()};
    const auto hit = cast({scene, moving}, ray, 12.0, guess);
    if (hit) guess = hit->primitive;
    const double off = std::abs((hit ? hit->distance : 12.0) -
                                std::min(plain_cast(primitives, bodies, ray, 12.0), 12.0));
    worst = std::max(worst, off);
    wrong += off > 1e-4 ? 1 : 0;
    grazes += off > 1e-6 ? 1 : 0;
  }
  std::printf("%ld beams: %ld off by more than 0.1 mm, %ld by more than 1 um; worst %.2g m\n",
              beams, wrong, grazes, worst);
  return wrong == 0 ? 0 : 1;
}
