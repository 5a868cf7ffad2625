// A robot that is driven and kidnapped, and a localizer of one's own in a run and on its log.
#include <cstdio>
#include <memory>
#include <optional>
#include <variant>

#include <castaway/amcl.hpp>
#include <castaway/evaluate.hpp>
#include <castaway/run.hpp>
#include <castaway/simulation.hpp>

namespace {

/// AMCL that does not trust itself: it says that it is lost.
class Doubter final : public castaway::Localizer {
 public:
  explicit Doubter(const castaway::LocalizerSetup& setup)
      : amcl_(setup.map, castaway::AmclOptions{setup.seed}.set("max_particles", "500")) {}

  void initialize(const std::optional<castaway::PoseWithCovariance>& start) override {
    amcl_.initialize(start);
  }
  void on_odometry(const castaway::Odometry& odometry) override { amcl_.on_odometry(odometry); }
  void on_scan(const castaway::LaserScan& scan) override { amcl_.on_scan(scan); }
  std::optional<castaway::Estimate> estimate() const override {
    std::optional<castaway::Estimate> estimate = amcl_.estimate();
    if (estimate) estimate->lost = true;
    return estimate;
  }

 private:
  castaway::Amcl amcl_;
};

/// Drives in a circle, and is put back to where it was at first.
void step_through(const castaway::Scenario& scenario) {
  castaway::Simulation simulation(scenario);
  simulation.command({0.2, 0.3});
  int scans = 0;
  while (const std::optional<castaway::Frame> frame = simulation.next()) {
    if (std::holds_alternative<castaway::ScanFrame>(frame->data) && ++scans == 10) {
      simulation.kidnap(simulation.start_pose());
    } else if (const auto* event = std::get_if<castaway::Event>(&frame->data)) {
      std::printf("%s after %d scans\n", event->kind.c_str(), scans);
    }
  }
}

}  // namespace

int main() {
  castaway::set_data_folder(DATA_FOLDER);
  castaway::Scenario scenario{"lab/kidnap"};
  scenario.set("duration_s", "4").set("events", "[]");
  step_through(scenario);

  const castaway::OwnLocalizer doubter{
      "doubter", [](const auto& setup) { return std::make_unique<Doubter>(setup); }};
  scenario.set("outputs", "{snapshots: false, carmen: true, map: true}");
  const castaway::RunResult result = castaway::run(scenario, {"log", {"mh_amcl", doubter}});
  std::printf("run: %zu localizers failed\n", result.failed.size());

  castaway::EvaluateOptions trials;
  trials.starts = trials.kidnaps = 1;
  trials.window_s = 1.0;
  for (const std::string& row : castaway::evaluate({"log"}, {"mh_amcl", doubter}, trials)) {
    std::printf("%s\n", row.c_str());
  }
}
