/// Unpacks the chunks of MCAP files.
#pragma once

#include <string>
#include <string_view>

namespace castaway::testbed {

/// Returns the records in a chunk, given the content of the chunk's record. `whole` is false if the
/// file ends within the record; the available part is then unpacked without checking the checksum.
/// Throws std::runtime_error if the chunk is damaged or claims more than 256 MiB.
std::string open_chunk(std::string_view content, bool whole);

}  // namespace castaway::testbed
