/// The chunks of MCAP files, opened.
#pragma once

#include <string>
#include <string_view>

namespace castaway::testbed {

/// The records in a chunk, from the content of its record. `whole`: false if the file ends in it;
/// what is there is unpacked then, and no checksum held against it. Throws std::runtime_error where
/// it is damaged, or claims more than 256 MiB.
std::string open_chunk(std::string_view content, bool whole);

}  // namespace castaway::testbed
