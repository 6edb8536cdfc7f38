# `cpack` in the build folder makes trocar_VERSION_ARCHITECTURE.deb of what is installed.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME trocar)
set(CPACK_PACKAGE_VENDOR "Trocar maintainers")
set(CPACK_PACKAGE_CONTACT "Trocar maintainers <maintainers@trocar.invalid>")  # dpkg wants an address
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"A Lua script says what is wired to what: a device, its kinematics, fixtures,
a logger. Trocar checks the whole graph, steps it a thousand times a second
or more, passes every force through one safety gate, and records it.

This package holds the trocar command, the operator's dashboard, libraries and
tutorials, and what a program of your own needs to use them: headers, CMake and pkg-config files.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)

set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# Folders as Debian wants them, whatever the umask of who packs.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)  # and the call of ldconfig after an installation
# Only those who compile against Trocar need these.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev (>= 3.4), g++ (>= 4:12), cmake (>= 3.25)")
include(CPack)
