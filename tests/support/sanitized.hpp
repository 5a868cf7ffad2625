/// Whether the tests run with sanitizers.
#pragma once

namespace castaway::test {

/// With sanitizers a test takes five to ten times as long: one of many random cases tries fewer.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace castaway::test
