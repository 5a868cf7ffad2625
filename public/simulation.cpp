#include "castaway/simulation.hpp"

#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include "public/read_scenario.hpp"
#include "sim/casting/surfaces.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/run/event_names.hpp"

namespace castaway {
namespace {

Event as_public(const testbed::RunEvent& event) {
  testbed::EventNames names = testbed::names_of(event.what);
  return {event.stamp,      std::move(names.kind), std::move(names.detail),
          event.T_map_from, event.T_map_to,        event.since};
}

}  // namespace

struct Simulation::Parts {
  std::string effective;
  std::vector<std::string> warnings;  ///< Before the first step.
  sim::WorldSpec world;
  OccupancyGrid map;
  std::unique_ptr<testbed::SimulatorSource> source;
};

Simulation::Simulation(const Scenario& scenario) {
  const ReadScenario read = read_scenario(scenario);
  testbed::PreparedSimulation prepared =
      testbed::build_simulation(read.loaded.scenario, read.file.parent_path());
  parts_ = std::make_unique<Parts>(Parts{read.loaded.effective, std::move(prepared.warnings),
                                         prepared.config.world, to_occupancy_grid(prepared.map),
                                         nullptr});
  parts_->source = testbed::build_source(read.loaded.scenario, std::move(prepared.config));
}

Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

std::optional<Frame> Simulation::next() {
  std::optional<testbed::Frame> frame = parts_->source->next();
  if (!frame) return std::nullopt;
  return std::visit(
      [&](auto& data) {
        if constexpr (std::is_same_v<std::decay_t<decltype(data)>, testbed::RunEvent>) {
          return Frame{frame->stamp, as_public(data)};
        } else {
          return Frame{frame->stamp, std::move(data)};
        }
      },
      frame->data);
}

void Simulation::command(const BaseVelocity& velocity) {
  if (!std::isfinite(velocity.v) || !std::isfinite(velocity.w)) {
    throw std::invalid_argument("v and w must be finite numbers");
  }
  parts_->source->set_velocity(velocity);
}

void Simulation::follow_route() { parts_->source->set_command(std::nullopt); }

void Simulation::kidnap(const Pose2& T_map_base) { parts_->source->kidnap(T_map_base); }

void Simulation::set_estimate(const std::optional<Pose2>& T_map_base) {
  parts_->source->set_drive_pose(T_map_base);
  parts_->source->set_watched_pose(T_map_base, 0.0);
}

Pose2 Simulation::start_pose() const { return parts_->source->start_pose().value(); }

Stamp Simulation::duration() const { return parts_->source->duration(); }

const OccupancyGrid& Simulation::map() const { return parts_->map; }

std::string Simulation::label_name(int label) const { return sim::hit_name(parts_->world, label); }

const std::string& Simulation::scenario() const { return parts_->effective; }

std::vector<std::string> Simulation::warnings() const {
  std::vector<std::string> all = parts_->warnings;
  for (const std::string& warning : parts_->source->warnings()) all.push_back(warning);
  return all;
}

}  // namespace castaway
