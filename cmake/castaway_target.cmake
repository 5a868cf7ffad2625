# Options of every target of ours: warnings as errors, bit-reproducible floating point, includes from the root.
function(castaway_target name)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_options(
    ${name} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 raises it falsely on concatenated strings (GCC bug 105651)...
    $<$<CONFIG:Debug>:-Wno-maybe-uninitialized>)  # ...and this one on std::regex with sanitizers.
endfunction()
