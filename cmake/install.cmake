# What `cmake --install` and `cpack -G DEB` put on a machine: the program with its data, manual page and completion (component
# program); the libraries with their headers and `find_package(castaway COMPONENTS localization sim plugin)` (component development).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The program finds its data relative to itself. In the build tree links stand for it.
set(CASTAWAY_DATA_FOLDERS worlds robots lidars datasets campaigns)
set(CASTAWAY_DATA_DIR ${CMAKE_INSTALL_DATADIR}/castaway)
foreach(folder IN LISTS CASTAWAY_DATA_FOLDERS)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/castaway)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${PROJECT_BINARY_DIR}/share/castaway/${folder} SYMBOLIC)
endforeach()
install(DIRECTORY ${CASTAWAY_DATA_FOLDERS} DESTINATION ${CASTAWAY_DATA_DIR} COMPONENT program)
install(TARGETS castaway RUNTIME COMPONENT program)

# The program writes them whenever it is built (tools/CMakeLists.txt).
set(CASTAWAY_MAN ${PROJECT_BINARY_DIR}/castaway.1)
set(CASTAWAY_BASH ${PROJECT_BINARY_DIR}/castaway.bash)
set(CASTAWAY_ZSH ${PROJECT_BINARY_DIR}/_castaway)
install(FILES ${CASTAWAY_MAN}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${CASTAWAY_BASH} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME castaway COMPONENT program)
install(FILES ${CASTAWAY_ZSH} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES LICENSE README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# The libraries: castaway::localization and castaway::sim, each with what it is made of.
set(CASTAWAY_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/castaway)
function(castaway_install_component component)
  foreach(target IN LISTS ARGN)
    set_target_properties(${target} PROPERTIES OUTPUT_NAME castaway_${target})
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_include_directories(${target} PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/castaway>
      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  endforeach()
  install(TARGETS ${ARGN} EXPORT castaway-${component} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT castaway-${component} NAMESPACE castaway:: DESTINATION ${CASTAWAY_CONFIG_DIR} COMPONENT development)
  install(DIRECTORY ${component} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/castaway COMPONENT development
    FILES_MATCHING PATTERN "*.hpp")
endfunction()
install(TARGETS elementary elementary_functions EXPORT castaway-elementary ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  COMPONENT development)
install(EXPORT castaway-elementary NAMESPACE castaway:: DESTINATION ${CASTAWAY_CONFIG_DIR} COMPONENT development)
castaway_install_component(localization localization)
castaway_install_component(sim sim sim_events sim_layout sim_odometry sim_scene sim_render xacro)
install(DIRECTORY xacro DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/castaway COMPONENT development FILES_MATCHING PATTERN "*.hpp")

# The interface of localizers in shared libraries: castaway::plugin, headers only.
add_library(plugin INTERFACE)
target_include_directories(plugin INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
install(TARGETS plugin EXPORT castaway-plugin COMPONENT development)
install(EXPORT castaway-plugin NAMESPACE castaway:: DESTINATION ${CASTAWAY_CONFIG_DIR} COMPONENT development)
install(DIRECTORY include/castaway DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

configure_package_config_file(cmake/castaway-config.cmake.in ${PROJECT_BINARY_DIR}/castaway-config.cmake
  INSTALL_DESTINATION ${CASTAWAY_CONFIG_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/castaway-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/castaway-config.cmake ${PROJECT_BINARY_DIR}/castaway-config-version.cmake
  DESTINATION ${CASTAWAY_CONFIG_DIR} COMPONENT development)

# Debian packages: castaway_*.deb, and libcastaway-dev_*.deb with the libraries.
set(CPACK_PACKAGE_CONTACT "castaway developers <castaway@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "kidnap a simulated robot and measure how a localizer finds it again")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME castaway)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Pictures are drawn by EGL, which is loaded when it is needed.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libegl1, libgl1")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libegl-mesa0, libgl1-mesa-dri, ffmpeg")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcastaway-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "cmake, libboost-dev, libeigen3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS
  "libassimp-dev, libbullet-dev, libepoxy-dev, libfmt-dev, libpng-dev, libsdformat-dev, libtinyxml-dev, liburdfdom-dev, pkg-config")
include(CPack)
