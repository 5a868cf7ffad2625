#include "tools/batch/jobs/trial_runner.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/process/worker_pool.hpp"
#include "tools/run/localizer_failure.hpp"

namespace castaway::testbed {
namespace {

// First characters of what a worker answers.
constexpr char kText = '=';
constexpr char kLocalizerFailed = '!';

std::string answer_of(const Work& run_trial, int trial) try {
  return kText + run_trial(trial);
} catch (const LocalizerFailure& failure) {
  return kLocalizerFailed + std::string(failure.what());
}

std::vector<std::string> run_in_workers(int trials, int workers, const Work& run_trial,
                                        const std::function<void()>& on_trial) {
  std::vector<std::string> texts(static_cast<std::size_t>(trials));
  JobOutcomes outcomes;
  outcomes.on_result = [&](int trial, const std::string& answer) {
    if (answer.front() == kLocalizerFailed) throw LocalizerFailure(answer.substr(1));
    texts[static_cast<std::size_t>(trial)] = answer.substr(1);
    on_trial();
  };
  outcomes.on_failure = [](int trial, const std::string& reason) {
    throw std::runtime_error(fmt::format("trial {}: {}", trial, reason));
  };
  const auto work = [&](int trial) { return answer_of(run_trial, trial); };
  work_through(jobs_up_to(trials), workers, work, outcomes);
  return texts;
}

}  // namespace

TrialRunner run_at_once(int workers) {
  return [workers](int trials, const Work& run_trial, const std::function<void()>& on_trial) {
    if (workers > 1) return run_in_workers(trials, workers, run_trial, on_trial);
    std::vector<std::string> texts;
    for (int trial = 0; trial < trials; ++trial) {
      texts.push_back(run_trial(trial));
      on_trial();
    }
    return texts;
  };
}

}  // namespace castaway::testbed
