// Loads a robot with the installed castaway::sim.
#include <cstdio>

#include <sim/robot/load_robot.hpp>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const castaway::sim::RobotModel robot = castaway::sim::load_robot(argv[1]);
  std::printf("%s: %zu wheels\n", robot.name.c_str(), robot.wheels.size());
}
