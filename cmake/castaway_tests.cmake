# A process a test takes longer to start than most tests run: the tests of a program share some processes. `ctest -R NAME` therefore
# names programs; one test is `build/release/PROGRAM --gtest_filter=NAME`. With sanitizers, their labels third-0, third-1 and third-2
# divide them for `tools/check dev`, which runs one third for each commit.
set(CASTAWAY_TEST_SHARDS 6 CACHE STRING "Processes that the tests of a program share")
mark_as_advanced(CASTAWAY_TEST_SHARDS)
set(CASTAWAY_TEST_TIMES ${PROJECT_BINARY_DIR}/test_times)  # What each test took, for scripts/slowest_tests.
file(MAKE_DIRECTORY ${CASTAWAY_TEST_TIMES})

# With sanitizers a test takes five to ten times as long. Only tests where memory errors are likely are built and run with them:
# readers, writers, processes, threads, other libraries, and a pass of each localizer.
option(CASTAWAY_ALL_TESTS "Build and run all tests with sanitizers, too" OFF)
set(CASTAWAY_SOME_TESTS OFF)
if(CMAKE_BUILD_TYPE STREQUAL "Debug" AND NOT CASTAWAY_ALL_TESTS)
  set(CASTAWAY_SOME_TESTS ON)
endif()

# Removes the sources whose paths match one of the regular expressions from a test program in builds with sanitizers.
function(castaway_not_with_sanitizers name)
  if(CASTAWAY_SOME_TESTS)
    get_target_property(sources ${name} SOURCES)
    foreach(pattern IN LISTS ARGN)
      list(FILTER sources EXCLUDE REGEX "${pattern}")
    endforeach()
    set_target_properties(${name} PROPERTIES SOURCES "${sources}")
  endif()
endfunction()

# LeakSanitizer's options for tests that load Mesa. With `intercept_tls_get_addr` it misreads the sizes of some thread-local
# blocks, and crashes at exit.
set(CASTAWAY_MESA_ENVIRONMENT
  "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/support/lsan_mesa.supp:print_suppressions=0:intercept_tls_get_addr=0")

# Registers the tests of a GoogleTest program: those that FILTER lets through, with a TIMEOUT in seconds and with ENVIRONMENT set.
# APART: each test is a process of its own, which is shown and timed by its name: for tests that start processes themselves.
# COST: what the longest of them takes [s]; those that take longest start first.
function(castaway_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 test "APART" "FILTER;TIMEOUT;ENVIRONMENT;COST" "")
  if(NOT test_FILTER)
    set(test_FILTER "*")
  endif()
  if(NOT test_TIMEOUT)
    set(test_TIMEOUT 3000)
  endif()
  if(NOT test_COST)
    set(test_COST 0)
  endif()
  if(test_APART)
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_FILTER "${test_FILTER}"
      PROPERTIES TIMEOUT ${test_TIMEOUT} COST ${test_COST} ENVIRONMENT "${test_ENVIRONMENT}")
    return()
  endif()
  math(EXPR last "${CASTAWAY_TEST_SHARDS} - 1")
  foreach(shard RANGE ${last})
    add_test(NAME ${name}_${shard} COMMAND ${name} "--gtest_filter=${test_FILTER}" --gtest_brief=1
      "--gtest_output=json:${CASTAWAY_TEST_TIMES}/${name}_${shard}.json")
    math(EXPR third "${shard} % 3")
    set_tests_properties(${name}_${shard} PROPERTIES TIMEOUT ${test_TIMEOUT} COST ${test_COST} LABELS third-${third} ENVIRONMENT
      "GTEST_TOTAL_SHARDS=${CASTAWAY_TEST_SHARDS};GTEST_SHARD_INDEX=${shard};${test_ENVIRONMENT}")
  endforeach()
endfunction()
