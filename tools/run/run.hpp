/// A run, built and ready to start.
#pragma once

#include <memory>
#include <vector>

#include "tools/run/loop.hpp"

namespace castaway::testbed {

/// A sensor source, localizers and sinks. Sinks are called in this order.
struct Run {
  LoopConfig loop;
  std::unique_ptr<SensorSource> source;
  std::vector<NamedLocalizer> localizers;
  std::vector<std::unique_ptr<RunSink>> sinks;
};

}  // namespace castaway::testbed
