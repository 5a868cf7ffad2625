#include "tools/base/process/worker_pool.hpp"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "tools/base/output/interruption.hpp"

namespace castaway::testbed {
namespace {

using Clock = std::chrono::steady_clock;

/// A process with its job.
struct BusyWorker {
  WorkerProcess process;
  std::optional<int> job;
  Clock::time_point begun;

  [[nodiscard]] double age_s() const {
    return std::chrono::duration<double>(Clock::now() - begun).count();
  }
};

/// The processes at work.
class WorkerPool {
 public:
  WorkerPool(const std::vector<int>& jobs, const Work& work, const JobOutcomes& outcomes,
             double timeout_s)
      : jobs_(jobs), work_(work), outcomes_(outcomes), timeout_s_(timeout_s) {}

  void run(int count) {
    while (static_cast<int>(workers_.size()) < count && has_more()) start_one();
    while (!workers_.empty()) step();
  }

 private:
  [[nodiscard]] bool has_more() const {
    return next_ < jobs_.size() && !(outcomes_.stopped && outcomes_.stopped());
  }

  void start_one() {
    workers_.push_back({WorkerProcess(work_), std::nullopt, {}});
    give(workers_.back());
  }

  /// Hands the next job out, or the end.
  void give(BusyWorker& worker) {
    worker.job = has_more() ? std::optional(jobs_[next_++]) : std::nullopt;
    worker.begun = Clock::now();
    worker.process.give(worker.job);
  }

  /// [ms] Until the first job is too slow; -1: no limit.
  [[nodiscard]] int patience() const {
    if (timeout_s_ <= 0.0) return -1;
    double least = timeout_s_;
    for (const BusyWorker& worker : workers_) least = std::min(least, timeout_s_ - worker.age_s());
    return static_cast<int>(1000.0 * std::max(least, 0.0)) + 1;
  }

  void step() {
    std::vector<pollfd> files;
    for (const BusyWorker& worker : workers_) files.push_back({worker.process.file(), POLLIN, 0});
    poll(files.data(), files.size(), interruption() == 0 ? patience() : 0);
    if (interruption() != 0) stop_all();
    for (std::size_t i = workers_.size(); i-- > 0;) {
      if (files[i].revents != 0) {
        take(i);
      } else if (timeout_s_ > 0.0 && workers_[i].job && workers_[i].age_s() > timeout_s_) {
        workers_[i].process.signal(SIGKILL);
        replace(i, fmt::format("took longer than {} s", timeout_s_));
      }
    }
  }

  /// Takes an answer, or the end of a process.
  void take(std::size_t i) {
    const std::optional<WorkAnswer> answer = workers_[i].process.take();
    if (!answer) return replace(i, "");
    const int job = workers_[i].job.value();
    // A caller that may stop hears of this job before the next one is handed out.
    if (!outcomes_.stopped) give(workers_[i]);
    (answer->failed ? outcomes_.on_failure : outcomes_.on_result)(job, answer->text);
    if (outcomes_.stopped) give(workers_[i]);
  }

  /// Takes leave of a process, and starts another one if it died at a job and there are more.
  void replace(std::size_t i, const std::string& reason) {
    if (interruption() != 0) stop_all();
    const std::optional<int> job = workers_[i].job;
    const std::string death = workers_[i].process.end();
    std::swap(workers_[i], workers_.back());
    workers_.pop_back();
    if (interruption() != 0) stop_all();
    if (!job) return;
    outcomes_.on_failure(*job, reason.empty() ? death : reason);
    if (has_more()) start_one();
  }

  [[noreturn]] void stop_all() {
    for (const BusyWorker& worker : workers_) worker.process.signal(SIGTERM);
    for (BusyWorker& worker : workers_) worker.process.end();
    throw_if_interrupted();
    throw std::logic_error("stopped without an interruption");
  }

  const std::vector<int>& jobs_;
  const Work& work_;
  const JobOutcomes& outcomes_;
  double timeout_s_;
  std::size_t next_ = 0;
  std::vector<BusyWorker> workers_;
};

}  // namespace

void work_through(const std::vector<int>& jobs, int workers, const Work& work,
                  const JobOutcomes& outcomes, double timeout_s) {
  if (workers < 1) throw std::invalid_argument("the number of workers must be at least 1");
  const Interruptible interruptible;
  WorkerPool(jobs, work, outcomes, timeout_s).run(workers);
}

std::vector<int> jobs_up_to(int count) {
  std::vector<int> jobs(static_cast<std::size_t>(count));
  std::iota(jobs.begin(), jobs.end(), 0);
  return jobs;
}

}  // namespace castaway::testbed
