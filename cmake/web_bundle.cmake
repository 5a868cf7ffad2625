# The report's player and the plots of all pages: bundled from web/ by Node.js where node, npm and the packages of
# web/package-lock.json can be had.
# Sets CASTAWAY_WEB_SOURCE: the C++ file that carries the bundles, or the one that says that there are none.
option(CASTAWAY_WEB "Bundle the report's player and plots, which takes Node.js 18 or later and npm" ON)
set(CASTAWAY_WEB_MODULES ${PROJECT_BINARY_DIR}/web)
set(CASTAWAY_WEB_SOURCE ${PROJECT_SOURCE_DIR}/tools/pages/html/web_bundle_none.cpp)
set(CASTAWAY_HAS_PLAYER OFF CACHE INTERNAL "The build bundles player and plots")

# npm ci, once for every state of the lock file. Sets `failure` to its last words if it fails.
function(castaway_install_modules failure)
  file(SHA256 ${PROJECT_SOURCE_DIR}/web/package-lock.json wanted)
  set(stamp ${CASTAWAY_WEB_MODULES}/installed.txt)
  if(EXISTS ${stamp})
    file(READ ${stamp} installed)
    if(installed STREQUAL wanted)
      return()
    endif()
  endif()
  file(COPY ${PROJECT_SOURCE_DIR}/web/package.json ${PROJECT_SOURCE_DIR}/web/package-lock.json
    DESTINATION ${CASTAWAY_WEB_MODULES})
  execute_process(
    COMMAND ${CASTAWAY_NPM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1 --fetch-timeout=30000
    WORKING_DIRECTORY ${CASTAWAY_WEB_MODULES} TIMEOUT 180
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result EQUAL 0)
    file(WRITE ${stamp} ${wanted})
    return()
  endif()
  string(REGEX MATCH "npm (ERR!|error) [^\n]*" words "${output}")
  set(${failure} "npm ci failed (${result}) ${words}; configure again with network to get it" PARENT_SCOPE)
endfunction()

if(CASTAWAY_WEB)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/package-lock.json)
  find_program(CASTAWAY_NODE NAMES node nodejs)
  find_program(CASTAWAY_NPM npm)
  set(failure "")
  set(node_version "0")
  if(CASTAWAY_NODE)
    execute_process(COMMAND ${CASTAWAY_NODE} --version OUTPUT_VARIABLE node_version OUTPUT_STRIP_TRAILING_WHITESPACE)
    string(REPLACE "v" "" node_version "${node_version}")
  endif()
  if(NOT CASTAWAY_NODE OR NOT CASTAWAY_NPM)
    set(failure "node or npm is not installed (apt-get install nodejs npm)")
  elseif(node_version VERSION_LESS 18)
    set(failure "node is ${node_version}; 18 or later is needed")
  else()
    castaway_install_modules(failure)
  endif()
  if(failure)
    message(WARNING "Reports will have no player and no plots: ${failure}")  # All else works.
  else()
    set(CASTAWAY_WEB_SOURCE ${PROJECT_BINARY_DIR}/web_bundle.cpp)
    set(CASTAWAY_HAS_PLAYER ON CACHE INTERNAL "The build bundles player and plots")
    file(GLOB_RECURSE web_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/src/*.js ${PROJECT_SOURCE_DIR}/web/src/*.css)
    add_custom_command(
      OUTPUT ${CASTAWAY_WEB_SOURCE}
      COMMAND ${CASTAWAY_NODE} ${PROJECT_SOURCE_DIR}/web/build.mjs ${CASTAWAY_WEB_MODULES} ${CASTAWAY_WEB_SOURCE}
      DEPENDS ${web_sources} ${PROJECT_SOURCE_DIR}/web/build.mjs ${PROJECT_SOURCE_DIR}/web/package-lock.json
      COMMENT "Bundling the report's player and plots" VERBATIM)
  endif()
else()
  message(STATUS "Reports will have no player and no plots: CASTAWAY_WEB is OFF")
endif()
