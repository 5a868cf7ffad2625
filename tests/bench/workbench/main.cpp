// What the project measures of itself: no user needs it, pages in docs/figures show it.
#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "tests/bench/workbench/commands.hpp"
#include "tools/base/output/any_error.hpp"
#include "tools/base/output/say.hpp"

namespace castaway::testbed {
namespace {

int run(const std::vector<std::string>& words) {
  CommandLine line("workbench measures the simulator and the published localizer.", "workbench 1");
  Command app = line.root();
  add_crowds_command(app);
  add_odometry_command(app);
  add_physics_command(app);
  add_published_command(app);
  if (const auto trouble = line.unknown_command(words)) {
    fmt::print(stderr, "{}\n", *trouble);
    return kBadInput;
  }
  const CommandLine::Parsed parsed = line.parse(words);
  if (parsed.act) return parsed.act();
  if (!parsed.trouble.empty()) fmt::print(stderr, "{}\n", parsed.trouble);
  return parsed.exit_code;
}

}  // namespace
}  // namespace castaway::testbed

int main(int argc, char** argv) {
  using namespace castaway::testbed;
  try {
    return run({argv + std::min(argc, 1), argv + argc});
  } catch (...) {
    fmt::print(stderr, "workbench: {}\n", current_error_text());
    return kBadInput;
  }
}
