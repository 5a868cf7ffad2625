/// A run, built and ready to start.
#pragma once

#include <memory>
#include <vector>

#include "tools/run/loop.hpp"

namespace castaway::testbed {

/// What senses, what localizes and what writes. Sinks are called in their order.
struct Run {
  LoopConfig loop;
  std::unique_ptr<SensorSource> source;
  std::vector<NamedLocalizer> localizers;
  std::vector<std::unique_ptr<RunSink>> sinks;
};

}  // namespace castaway::testbed
