#include "tools/run/loop.hpp"

#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/dead_reckoning.hpp"
#include "tools/run/event_names.hpp"

namespace castaway::testbed {
namespace {

/// Plays a list of frames and records the poses it is given.
class ListSource final : public SensorSource {
 public:
  explicit ListSource(std::vector<Frame> frames) : frames_(std::move(frames)) {}
  std::optional<Frame> next() override {
    if (next_ == frames_.size()) return std::nullopt;
    return frames_[next_++];
  }
  void set_drive_pose(const std::optional<SE2>& pose) override { driven.push_back(pose); }
  void set_watched_pose(const std::optional<SE2>& pose, double) override {
    watched.push_back(pose);
  }
  void set_velocity(const BaseVelocity& velocity) override { speeds.push_back(velocity.v); }
  [[nodiscard]] std::optional<SE2> start_pose() const override { return SE2{}; }
  [[nodiscard]] Stamp duration() const override { return Stamp(1000); }
  [[nodiscard]] std::map<std::string, std::chrono::nanoseconds> cpu_by_stage() const override {
    return {{"physics", std::chrono::seconds(2)}};
  }
  [[nodiscard]] std::vector<std::string> warnings() const override { return {}; }
  std::vector<std::optional<SE2>> driven;
  std::vector<std::optional<SE2>> watched;
  std::vector<double> speeds;  ///< Commanded.

 private:
  std::vector<Frame> frames_;
  std::size_t next_ = 0;
};

/// Records the order of calls.
class ListSink : public RunSink {
 public:
  void on_event(const RunEvent& event) override {
    calls.push_back("event " + names_of(event.what).kind);
    details.push_back(names_of(event.what).detail);
  }
  void on_odometry(const OdometryFrame&) override { calls.emplace_back("odometry"); }
  void on_scan(const ScanRecord& record) override {
    calls.emplace_back("scan");
    records.push_back(record);
  }
  void finish(Stamp end, const RunTiming& timing) override {
    calls.push_back("finish " + std::to_string(end.count()));
    cpu_s = timing.cpu_s;
  }
  std::vector<std::string> calls;
  std::vector<std::string> details;  ///< Of events.
  std::vector<ScanRecord> records;
  std::map<std::string, double> cpu_s;
};

Frame odometry(std::int64_t stamp, const SE2& pose) {
  return {Stamp(stamp), OdometryFrame{{Stamp(stamp), pose}, std::nullopt}};
}

Frame scan(std::int64_t stamp, const SE2& truth) {
  ScanFrame frame;
  frame.scan.stamp = Stamp(stamp);
  frame.true_pose = truth;
  return {Stamp(stamp), frame};
}

class LoopTest : public testing::Test {
 protected:
  LoopTest() {
    localizers_.push_back({"dead_reckoning", std::make_unique<test::DeadReckoning>()});
    auto sink = std::make_unique<ListSink>();
    sink_ = sink.get();
    sinks_.push_back(std::move(sink));
    config_.start = localization::PoseWithCovariance{{5.0, 0.0, 0.0}, Eigen::Matrix3d::Zero()};
  }
  ListSource source_{
      {odometry(0, {1.0, 0.0, 0.0}), odometry(10, {2.0, 0.0, 0.0}), scan(10, {6.0, 0.0, 0.0}),
       Frame{Stamp(15), RunEvent{Stamp(15), KidnapEvent{}}}, odometry(20, {4.0, 0.0, 0.0})}};
  LoopConfig config_;
  std::vector<NamedLocalizer> localizers_;
  std::vector<std::unique_ptr<RunSink>> sinks_;
  ListSink* sink_ = nullptr;
};

TEST_F(LoopTest, TellsSinksEverythingInOrder) {
  Loop(config_, localizers_, sinks_).run(source_);
  EXPECT_EQ(sink_->calls, (std::vector<std::string>{"odometry", "odometry", "scan", "event kidnap",
                                                    "odometry", "finish 1000"}));
}

/// Writes nothing, and says so.
struct FailingSink : ListSink {
  void finish(Stamp, const RunTiming&) override { throw std::runtime_error("disk full"); }
};

TEST_F(LoopTest, ASinkThatFailsToFinishLeavesTheOthers) {
  sinks_.insert(sinks_.begin(), std::make_unique<FailingSink>());
  Loop loop(config_, localizers_, sinks_);
  EXPECT_THROW(loop.run(source_), std::runtime_error);
  EXPECT_TRUE(loop.is_finished());
  EXPECT_EQ(sink_->calls.back(), "finish 1000");
}

/// Fails at its second odometry, as on a full disk.
struct BreakingSink : ListSink {
  void on_odometry(const OdometryFrame& frame) override {
    if (!calls.empty()) throw std::runtime_error("disk full");
    ListSink::on_odometry(frame);
  }
};

TEST_F(LoopTest, ASinkThatFailsInTheRunLeavesTheOthersAndHearsNoMore) {
  auto breaking = std::make_unique<BreakingSink>();
  const BreakingSink& broken = *breaking;
  sinks_.insert(sinks_.begin(), std::move(breaking));
  Loop loop(config_, localizers_, sinks_);
  EXPECT_THROW(loop.run(source_), std::runtime_error);
  EXPECT_TRUE(loop.is_finished());
  EXPECT_EQ(broken.calls, (std::vector<std::string>{"odometry"}));
  EXPECT_EQ(sink_->calls, (std::vector<std::string>{"odometry", "odometry", "scan", "event kidnap",
                                                    "odometry", "finish 1000"}));
}

TEST_F(LoopTest, DrivesByALocalizersCommandsAtEveryOdometry) {
  localizers_.front().velocity = [] { return BaseVelocity{0.3, 0.1}; };
  config_.orders = {{Stamp(12), localizers_.front().name, LocalizerOrder::What::kOff, {}}};
  Loop(config_, localizers_, sinks_).run(source_);
  EXPECT_EQ(source_.speeds, (std::vector<double>{0.3, 0.3, 0.0}));
}

TEST_F(LoopTest, OneLocalizerDrivesAtMost) {
  localizers_.push_back({"again", nullptr});
  for (NamedLocalizer& each : localizers_) each.velocity = [] { return BaseVelocity{}; };
  EXPECT_THROW(Loop(config_, localizers_, sinks_), std::invalid_argument);
}

TEST_F(LoopTest, TellsWhatHappenedOutsideAfterTheScan) {
  std::vector<std::string> news{"the node went"};
  localizers_.front().news = [&news] { return std::exchange(news, {}); };
  Loop(config_, localizers_, sinks_).run(source_);
  EXPECT_EQ(sink_->calls, (std::vector<std::string>{"odometry", "odometry", "scan", "event node",
                                                    "event kidnap", "odometry", "finish 1000"}));
  EXPECT_EQ(sink_->details.front(), "the node went");
}

TEST_F(LoopTest, RecordsEveryLocalizersAnswerBesideTheTruth) {
  Loop(config_, localizers_, sinks_).run(source_);
  ASSERT_EQ(sink_->records.size(), 1U);
  const ScanRecord& record = sink_->records[0];
  EXPECT_EQ(record.true_pose->T_map_base.x, 6.0);
  EXPECT_EQ(record.T_odom_base.x, 2.0);
  ASSERT_EQ(record.localizers.size(), 1U);
  EXPECT_EQ(record.localizers[0].name, "dead_reckoning");
  EXPECT_EQ(record.localizers[0].estimate->T_map_base.x, 6.0);
}

TEST_F(LoopTest, LeavesAnUnknownStartToTheLocalizer) {
  config_.start.reset();
  Loop(config_, localizers_, sinks_).run(source_);
  EXPECT_FALSE(sink_->records[0].localizers[0].estimate);
}

/// Initial poses and counts of what a localizer is told.
class Told final : public localization::Localizer {
 public:
  explicit Told(std::vector<std::string>& log) : log_(log) {}
  void initialize(const std::optional<localization::PoseWithCovariance>& start) override {
    log_.push_back(start ? "start " + std::to_string(start->T_map_base.x) : "anywhere");
  }
  void on_odometry(const Odometry&) override { log_.emplace_back("odometry"); }
  void on_scan(const LaserScan&) override { log_.emplace_back("scan"); }
  [[nodiscard]] std::optional<localization::Estimate> estimate() const override {
    return localization::Estimate{};
  }
  [[nodiscard]] localization::Diagnostics diagnostics() const override { return {}; }

 private:
  std::vector<std::string>& log_;
};

TEST_F(LoopTest, CarriesOrdersOutAfterTheDeliveriesOfTheirTime) {
  std::vector<std::string> log;
  localizers_.push_back({"told", std::make_unique<Told>(log)});
  using What = LocalizerOrder::What;
  const auto pose = localization::PoseWithCovariance{{7.0, 0.0, 0.0}, Eigen::Matrix3d::Zero()};
  config_.orders = {{Stamp(0), "told", What::kOff, {}},
                    {Stamp(10), "told", What::kOn, {}},
                    {Stamp(15), "told", What::kInitialize, pose}};
  Loop(config_, localizers_, sinks_).run(source_);
  EXPECT_EQ(log, (std::vector<std::string>{"start 5.000000", "odometry", "anywhere",
                                           "start 7.000000", "odometry"}));
  EXPECT_EQ(sink_->calls, (std::vector<std::string>{"odometry", "event operator", "odometry",
                                                    "scan", "event operator", "event kidnap",
                                                    "event operator", "odometry", "finish 1000"}));
  EXPECT_FALSE(sink_->records[0].localizers[1].estimate);
}

TEST_F(LoopTest, AnOrderThatIsAddedEqualsOneThatIsConfigured) {
  const auto log_of = [&](bool configured) {
    std::vector<std::string> log;
    localizers_.clear();
    localizers_.push_back({"told", std::make_unique<Told>(log)});
    ListSource source({odometry(0, {}), odometry(10, {}), scan(10, {}), odometry(20, {})});
    const LocalizerOrder order{Stamp(10), "told", LocalizerOrder::What::kRelocalize, {}};
    config_.orders.clear();
    if (configured) config_.orders.push_back(order);
    Loop loop(config_, localizers_, sinks_);
    loop.begin();
    loop.step(source);
    loop.step(source);
    if (!configured) loop.add(order);
    while (loop.step(source)) {
    }
    return log;
  };
  EXPECT_EQ(log_of(false), log_of(true));
  EXPECT_EQ(log_of(true), (std::vector<std::string>{"start 5.000000", "odometry", "odometry",
                                                    "scan", "anywhere", "odometry"}));
}

TEST_F(LoopTest, AnOrderNeedsALocalizerOfTheRun) {
  config_.orders = {{Stamp(0), "nobody", LocalizerOrder::What::kOff, {}}};
  EXPECT_THROW(Loop(config_, localizers_, sinks_), std::invalid_argument);
}

/// Answers every scan and always raises the alarm.
class AlwaysLost final : public localization::Localizer {
 public:
  void initialize(const std::optional<localization::PoseWithCovariance>&) override {}
  void on_odometry(const Odometry&) override {}
  void on_scan(const LaserScan& laser) override {
    estimate_.emplace();
    estimate_->stamp = laser.stamp;
    estimate_->lost = true;
  }
  [[nodiscard]] std::optional<localization::Estimate> estimate() const override {
    return estimate_;
  }
  [[nodiscard]] localization::Diagnostics diagnostics() const override { return {}; }

 private:
  std::optional<localization::Estimate> estimate_;
};

/// Answers the first scan and ignores all others.
class FirstScanOnly final : public localization::Localizer {
 public:
  void initialize(const std::optional<localization::PoseWithCovariance>&) override {}
  void on_odometry(const Odometry&) override {}
  void on_scan(const LaserScan& laser) override {
    if (estimate_) return;
    estimate_.emplace();
    estimate_->stamp = laser.stamp;
  }
  [[nodiscard]] std::optional<localization::Estimate> estimate() const override {
    return estimate_;
  }
  [[nodiscard]] localization::Diagnostics diagnostics() const override { return {}; }

 private:
  std::optional<localization::Estimate> estimate_;
};

TEST_F(LoopTest, TakesNoAnswerForADroppedScan) {
  localizers_[0].localizer = std::make_unique<FirstScanOnly>();
  ListSource source({odometry(0, {}), scan(5, {}), scan(10, {})});
  Loop(config_, localizers_, sinks_).run(source);
  ASSERT_EQ(sink_->records.size(), 2U);
  EXPECT_TRUE(sink_->records[0].localizers[0].estimate);
  EXPECT_FALSE(sink_->records[1].localizers[0].estimate);
}

TEST_F(LoopTest, TellsAKidnapOnlyToThoseWhoAreToBeTold) {
  localizers_.push_back({"driven", std::make_unique<test::DeadReckoning>(), true});
  const Frame kidnap{Stamp(7), RunEvent{Stamp(7), KidnapEvent{}}};
  const Frame collision{Stamp(3), RunEvent{Stamp(3), sim::Collision{}}};
  ListSource source({odometry(0, {}), collision, scan(5, {}), kidnap, scan(10, {})});
  Loop(config_, localizers_, sinks_).run(source);
  ASSERT_EQ(sink_->records.size(), 2U);
  EXPECT_TRUE(sink_->records[0].localizers[1].estimate);
  EXPECT_TRUE(sink_->records[1].localizers[0].estimate);
  EXPECT_FALSE(sink_->records[1].localizers[1].estimate);  // dead reckoning cannot relocalize
}

TEST_F(LoopTest, DrivesByALocalizersOutputCarriedOnByOdometry) {
  config_.drive_by = "dead_reckoning";
  Loop(config_, localizers_, sinks_).run(source_);
  ASSERT_EQ(source_.driven.size(), 3U);
  EXPECT_FALSE(source_.driven[0]);
  EXPECT_EQ(source_.driven[2]->x, 8.0);  // 6 at the scan, 2 m by odometry since
}

TEST_F(LoopTest, TellsWhereTheWatchedLocalizerIsSureToBe) {
  config_.watch = "dead_reckoning";
  Loop(config_, localizers_, sinks_).run(source_);
  EXPECT_TRUE(source_.driven.empty());
  ASSERT_EQ(source_.watched.size(), 3U);
  EXPECT_FALSE(source_.watched[0]);
  EXPECT_EQ(source_.watched[2]->x, 8.0);
}

TEST_F(LoopTest, SaysNothingOfAWatchedLocalizerThatIsLost) {
  localizers_[0].localizer = std::make_unique<AlwaysLost>();
  config_.watch = "dead_reckoning";
  Loop(config_, localizers_, sinks_).run(source_);
  for (const auto& pose : source_.watched) EXPECT_FALSE(pose);
}

TEST_F(LoopTest, RefusesADriverOrAWatchedOneThatIsNotThere) {
  config_.watch = "nobody";
  EXPECT_THROW(Loop(config_, localizers_, sinks_), std::invalid_argument);
  config_.watch.clear();
  config_.drive_by = "nobody";
  EXPECT_THROW(Loop(config_, localizers_, sinks_), std::invalid_argument);
}

TEST_F(LoopTest, ReportsCpuByStage) {
  Loop(config_, localizers_, sinks_).run(source_);
  EXPECT_EQ(sink_->cpu_s.at("physics"), 2.0);
  EXPECT_TRUE(sink_->cpu_s.contains("localizers"));
  EXPECT_TRUE(sink_->cpu_s.contains("sinks"));
}

}  // namespace
}  // namespace castaway::testbed
