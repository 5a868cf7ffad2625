/// The domains that this process is in.
#pragma once

#include <memory>

#include "tools/ros/dds/dds_participant.hpp"

namespace castaway::testbed {

/// A domain of CycloneDDS, configured by us: the environment's configuration is not read.
class DdsDomain {
 public:
  /// The domain, which exists as long as anyone holds it. Throws std::runtime_error as
  /// `DdsParticipant` does.
  static std::shared_ptr<DdsDomain> join(const DdsNetwork& network);

  explicit DdsDomain(const DdsNetwork& network);

  [[nodiscard]] const DdsNetwork& network() const { return network_; }

 private:
  DdsNetwork network_;
  DdsEntity domain_;
};

}  // namespace castaway::testbed
