# Tests with sanitizers take longer to start than to run: there, a program's tests share some processes. Their labels third-0,
# third-1 and third-2 divide them, for `tools/check dev`, which runs one third for each commit.
set(CASTAWAY_TEST_SHARDS 0 CACHE STRING "Processes that run the tests of a program; 0: one for each test")
mark_as_advanced(CASTAWAY_TEST_SHARDS)

# LeakSanitizer's options for tests that load Mesa. With `intercept_tls_get_addr` it misreads the sizes of some thread-local
# blocks, and crashes at exit.
set(CASTAWAY_MESA_ENVIRONMENT
  "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/support/lsan_mesa.supp:print_suppressions=0:intercept_tls_get_addr=0")

# Registers the tests of a GoogleTest program: those that FILTER lets through, with a TIMEOUT in seconds and with ENVIRONMENT set.
function(castaway_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 test "" "FILTER;TIMEOUT;ENVIRONMENT" "")
  if(NOT test_FILTER)
    set(test_FILTER "*")
  endif()
  if(NOT test_TIMEOUT)
    set(test_TIMEOUT 1500)
  endif()
  if(CASTAWAY_TEST_SHARDS EQUAL 0)
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_FILTER "${test_FILTER}"
      PROPERTIES TIMEOUT ${test_TIMEOUT} ENVIRONMENT "${test_ENVIRONMENT}")
    return()
  endif()
  math(EXPR last "${CASTAWAY_TEST_SHARDS} - 1")
  foreach(shard RANGE ${last})
    add_test(NAME ${name}_${shard} COMMAND ${name} "--gtest_filter=${test_FILTER}")
    math(EXPR third "${shard} % 3")
    set_tests_properties(${name}_${shard} PROPERTIES TIMEOUT 3000 LABELS third-${third} ENVIRONMENT
      "GTEST_TOTAL_SHARDS=${CASTAWAY_TEST_SHARDS};GTEST_SHARD_INDEX=${shard};${test_ENVIRONMENT}")
  endforeach()
endfunction()
