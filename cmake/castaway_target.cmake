# Sources of a target are compiled together, some at a time: headers and their templates cost more than our own code. OFF compiles
# each source alone, which shows a missing #include, and is quicker after a small edit.
option(CASTAWAY_UNITY "Compile sources of a target together" ON)
set(CASTAWAY_UNITY_FILES 40 CACHE STRING "Sources that are compiled together, at most")
mark_as_advanced(CASTAWAY_UNITY_FILES)

# So many files together take up to 2 GB: no more compilers at once than fit into memory.
if(CASTAWAY_UNITY AND NOT CMAKE_JOB_POOL_COMPILE)
  cmake_host_system_information(RESULT megabytes QUERY TOTAL_PHYSICAL_MEMORY)
  math(EXPR compilers "${megabytes} / 2500")
  if(compilers LESS 1)
    set(compilers 1)
  endif()
  set_property(GLOBAL APPEND PROPERTY JOB_POOLS compile=${compilers})
  set(CMAKE_JOB_POOL_COMPILE compile)
endif()

# Options of every target of ours: warnings, bit-reproducible floating point, includes from the root. A level of optimisation
# (1 or 2) may follow for targets that no run spends its time in: at level 3 they take up to twice as long to compile.
function(castaway_target name)
  if(ARGC GREATER 1)
    target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O${ARGV1}>)
  endif()
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>)
  # Collecting the compiler's garbage takes 12 % of its time, and saves a quarter of its memory.
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1000000>)
  target_compile_options(
    ${name} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off
    $<$<BOOL:${CASTAWAY_WERROR}>:-Werror>
    $<$<NOT:$<BOOL:${CASTAWAY_UNITY}>>:-Wshadow>  # Files compiled together see each other's constants:...
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CASTAWAY_UNITY}>>:-Wshadow=local>  # ...they may hide those.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # GCC 12 raises it falsely on concatenated strings (GCC bug 105651)...
    $<$<CONFIG:Debug>:-Wno-maybe-uninitialized>)  # ...and this one on std::regex with sanitizers.
  # What users run: canaries, checked copies, and tables of the linker that nothing overwrites. Sanitizers check more.
  if(NOT CASTAWAY_FUZZ AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    target_compile_options(${name} PRIVATE
      "$<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-fstack-protector-strong;-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>")
    target_link_options(${name} PRIVATE $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-Wl,-z,relro,-z,now>)
  endif()
  if(CASTAWAY_UNITY)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${CASTAWAY_UNITY_FILES})
  endif()
endfunction()
