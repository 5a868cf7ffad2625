/// Makes path components from names in files (of scenarios, localizers, lidars, worlds).
#pragma once

#include <string>
#include <string_view>

namespace castaway::testbed {

/// Why a text cannot name a file or a folder, as the end of a sentence ("must not hold '/'"). Empty
/// if it can: 1 to 100 bytes of UTF-8, no slash, backslash or control character, no leading '.' or
/// '-', no blank at either end.
std::string file_name_error(std::string_view name);

/// Why a text cannot name a file in a folder or, with slashes, in folders of it: every part must be
/// a name, and there are at most 12. Empty if it can.
std::string file_path_error(std::string_view path);

/// Converts a text to a file name: invalid characters become '_'; "unnamed" if nothing is left.
std::string file_name_of(std::string_view text);

}  // namespace castaway::testbed
