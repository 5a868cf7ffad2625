# What `cmake --install` and `cpack -G DEB` put on a machine: the program with its data, manual page and completion (component
# program); the public headers, their libraries and `find_package(castaway COMPONENTS localization simulation plugin)` (component development).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The program finds its data relative to itself. In the build tree links stand for it.
set(CASTAWAY_DATA_FOLDERS worlds robots lidars logs foxglove datasets campaigns)
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
install(FILES package.xml DESTINATION ${CASTAWAY_DATA_DIR} COMPONENT development)  # For workspaces of ROS 2 (REP-136).

# The public headers, and the libraries that implement them: castaway::localization and castaway::simulation. What these are made
# of is installed as archives only.
install(DIRECTORY include/castaway DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
set(CASTAWAY_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/castaway)
function(castaway_install_component component public)
  set_target_properties(${public} PROPERTIES EXPORT_NAME ${component} OUTPUT_NAME castaway_${component})
  target_compile_features(${public} PUBLIC cxx_std_20)
  target_include_directories(${public} PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  foreach(target IN LISTS ARGN)
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${target}_archive OUTPUT_NAME castaway_${target}_archive)
  endforeach()
  install(TARGETS ${public} ${ARGN} EXPORT castaway-${component} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(EXPORT castaway-${component} NAMESPACE castaway:: DESTINATION ${CASTAWAY_CONFIG_DIR} COMPONENT development)
endfunction()
install(TARGETS elementary elementary_functions EXPORT castaway-elementary ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  COMPONENT development)
install(EXPORT castaway-elementary NAMESPACE castaway:: DESTINATION ${CASTAWAY_CONFIG_DIR} COMPONENT development)
castaway_install_component(localization localizers localization settings xacro_names)
castaway_install_component(simulation simulation
  pages_floor twin_floor batch_floor play_floor build_floor scenario_floor outputs_floor ros_floor run_floor base_floor
  sim sim_events sim_layout sim_odometry sim_scene sim_render xacro)

# Localizers in shared libraries need castaway::plugin alone: headers of C and C++.
add_library(plugin INTERFACE)
target_include_directories(plugin INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
install(TARGETS plugin EXPORT castaway-plugin COMPONENT development)
install(EXPORT castaway-plugin NAMESPACE castaway:: DESTINATION ${CASTAWAY_CONFIG_DIR} COMPONENT development)

configure_package_config_file(cmake/castaway-config.cmake.in ${PROJECT_BINARY_DIR}/castaway-config.cmake
  INSTALL_DESTINATION ${CASTAWAY_CONFIG_DIR} PATH_VARS CASTAWAY_DATA_DIR)
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
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "cmake, libeigen3-dev, libfmt-dev, libyaml-cpp-dev")
# What castaway::simulation links, besides.
string(CONCAT CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS
  "cyclonedds-dev, libassimp-dev, libbullet-dev, libepoxy-dev, libhdf5-dev, libjpeg-dev, liblz4-dev, liblzf-dev, liboctomap-dev, libpng-dev, "
  "libsdformat-dev, libsqlite3-dev, libssl-dev, libtinyxml-dev, liburdfdom-dev, libzstd-dev, nlohmann-json3-dev, pkg-config, zlib1g-dev")
include(CPack)
