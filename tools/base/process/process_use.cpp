#include "tools/base/process/process_use.hpp"

#include <algorithm>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "tools/base/process/cpu_clock.hpp"

namespace castaway::testbed {

std::vector<pid_t> process_tree(pid_t process) {
  std::vector<pid_t> tree{process};
  for (std::size_t i = 0; i < tree.size(); ++i) {
    std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", tree[i]));
    for (pid_t child = 0; children >> child;) tree.push_back(child);
  }
  return tree;
}

double peak_memory_mb_of(pid_t process) {
  std::ifstream status(fmt::format("/proc/{}/status", process));
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1000.0;  // In kB.
  }
  return 0.0;
}

void ProcessUse::look() {
  for (const pid_t process : process_tree(process_)) {
    cpu_.emplace(process, 0);
    double& memory = memory_mb_[process];
    memory = std::max(memory, peak_memory_mb_of(process));
  }
}

std::chrono::nanoseconds ProcessUse::cpu() {
  constexpr int kEvery = 100;
  if (calls_++ % kEvery == 0) look();
  std::chrono::nanoseconds sum{};
  for (auto& [process, cpu] : cpu_) {
    if (const auto now = process_cpu_time(process)) cpu = *now;
    sum += cpu;
  }
  return sum;
}

double ProcessUse::peak_memory_mb() {
  look();
  double sum = 0.0;
  for (const auto& [process, memory] : memory_mb_) sum += memory;
  return sum;
}

}  // namespace castaway::testbed
