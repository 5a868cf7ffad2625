/// A simulated robot to step through, to drive and to kidnap.
///
///     castaway::Simulation simulation(castaway::Scenario{"lab/kidnap"}.set("seed", "3"));
///     while (const auto frame = simulation.next()) {
///       if (const auto* scan = std::get_if<castaway::ScanFrame>(&frame->data)) ...
///     }
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "castaway/frame.hpp"
#include "castaway/grid.hpp"
#include "castaway/scenario.hpp"

namespace castaway {

/// The simulation of a scenario, without its localizers. The same scenario, seed and commands give
/// the same frames, which are those of a run. Can be moved, not copied.
class Simulation {
 public:
  /// @throws std::runtime_error or std::invalid_argument as `effective_text` does, and for a robot
  /// or a world that cannot be simulated.
  explicit Simulation(const Scenario& scenario);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// The next frame, in order of time; nothing once the scenario's duration is over.
  std::optional<Frame> next();
  /// Drives the robot from the next control step (20 Hz) on, until it is changed. @throws
  /// std::invalid_argument for numbers that are not finite.
  void command(const BaseVelocity& velocity);
  /// Lets the scenario drive the robot again.
  void follow_route();
  /// Moves base to a pose in map at the next step; an Event tells of it. @throws
  /// std::invalid_argument if the robot has no room there.
  void kidnap(const Pose2& T_map_base);
  /// Tells the scenario a localizer's estimate: a robot whose `drive.by` is a localizer drives by
  /// it, and kidnaps that wait for a localizer watch it. Other scenarios ignore it.
  void set_estimate(const std::optional<Pose2>& T_map_base);

  /// True pose of base in map at the start.
  [[nodiscard]] Pose2 start_pose() const;
  /// Simulated time at which the frames end.
  [[nodiscard]] Stamp duration() const;
  /// The map given to localizers.
  [[nodiscard]] const OccupancyGrid& map() const;
  /// What a beam with this label hit (`ScanTruth::labels`), such as "wall".
  [[nodiscard]] std::string label_name(int label) const;
  /// The scenario with all defaults filled in, as YAML.
  [[nodiscard]] const std::string& scenario() const;
  /// Remarks about the robot, the world and the run so far, a sentence each.
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace castaway
