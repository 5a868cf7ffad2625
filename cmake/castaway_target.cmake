# Headers that most files include, compiled once for each target of many files. Off by default: they hide a missing #include, and
# optimising with them GCC 12 raises false warnings of strings (-Wstringop-overflow).
option(CASTAWAY_PRECOMPILE_HEADERS "Precompile common headers" OFF)
set(CASTAWAY_PRECOMPILED_HEADERS
  <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <numbers> <optional> <set>
  <sstream> <stdexcept> <string> <vector> <Eigen/Geometry>)

# Options of every target of ours: warnings as errors, bit-reproducible floating point, includes from the root.
function(castaway_target name)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_options(
    ${name} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 raises it falsely on concatenated strings (GCC bug 105651)...
    $<$<CONFIG:Debug>:-Wno-maybe-uninitialized>)  # ...and this one on std::regex with sanitizers.
  get_target_property(sources ${name} SOURCES)
  list(LENGTH sources files)
  if(CASTAWAY_PRECOMPILE_HEADERS AND files GREATER 8)
    target_precompile_headers(${name} PRIVATE ${CASTAWAY_PRECOMPILED_HEADERS})
  endif()
endfunction()
