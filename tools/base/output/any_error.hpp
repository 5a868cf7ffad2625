/// Describes an exception of any type.
#pragma once

#include <string>

namespace castaway::testbed {

/// Text of the exception that is being handled; libraries also throw types that are no
/// std::exception, of which only the type's name is known. Call it in a handler. Rethrows
/// Interrupted.
std::string current_error_text();

}  // namespace castaway::testbed
