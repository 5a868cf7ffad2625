/// A type of CycloneDDS whose samples are the bytes of a message.
#pragma once

#include <string>

struct ddsi_sertype;

namespace castaway::testbed {

/// A new type without keys whose samples are `std::string`s: CDR with its header of four bytes
/// (OMG DDSI-RTPS 10.2). `name`: as other participants know it, such as
/// "sensor_msgs::msg::dds_::LaserScan_". CycloneDDS frees it.
ddsi_sertype* make_raw_type(const std::string& name);

}  // namespace castaway::testbed
