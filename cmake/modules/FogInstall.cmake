# `cmake --install`: the tool, its manual page and completion, the scripts of `fogcomp convert`, and the core for
# firmware of one's own; and the same as a Debian package (`cpack` in the build folder).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# What the tool prints of itself, as files.
set(manual "${CMAKE_CURRENT_BINARY_DIR}/fogcomp.1")
set(completion "${CMAKE_CURRENT_BINARY_DIR}/fogcomp.bash")
add_custom_command(
  OUTPUT "${manual}" "${completion}"
  COMMAND fogcomp man > "${manual}"
  COMMAND fogcomp completion bash > "${completion}"
  DEPENDS fogcomp
  VERBATIM)
add_custom_target(fogcomp_manual ALL DEPENDS "${manual}" "${completion}")

install(TARGETS fogcomp RUNTIME)
install(FILES "${manual}" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(
  FILES "${completion}"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
  RENAME fogcomp)

# The scripts that read logs of other programs, without the packages that they need.
set(shared "${CMAKE_INSTALL_DATADIR}/fogcomp")
install(
  DIRECTORY host_tools/recording/importers
  DESTINATION "${shared}"
  FILES_MATCHING
  PATTERN "*.mjs"
  PATTERN "*.json"
  PATTERN "node_modules" EXCLUDE)

# Sources and headers together, as core/CMakeLists.txt has them.
install(
  DIRECTORY firmware/core
  DESTINATION "${shared}"
  FILES_MATCHING
  PATTERN "*.hpp"
  PATTERN "*.cpp"
  PATTERN "CMakeLists.txt")
set(version_file "${CMAKE_CURRENT_BINARY_DIR}/fogcompConfigVersion.cmake")
write_basic_package_version_file("${version_file}" COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES cmake/package/fogcompConfig.cmake "${version_file}" DESTINATION "${shared}/cmake")

# Nothing of the libraries around the tool: a package that is given away needs neither Eigen nor npm.
set(CPACK_GENERATOR DEB)
set(FOG_PACKAGE_CONTACT
    "fogcomp <fogcomp@localhost>"
    CACHE STRING "Who maintains the package that cpack makes: NAME <ADDRESS>")
set(CPACK_PACKAGE_CONTACT "${FOG_PACKAGE_CONTACT}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "bash-completion, nodejs, npm, cmake, gcc-arm-none-eabi, libstdc++-arm-none-eabi-dev")
include(CPack)
