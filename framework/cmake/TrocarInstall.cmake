# Installs the libraries, their headers, the program, the scripts and the documents, so that
# find_package(Trocar) gives Trocar::framework and Trocar::components. Included last, when all
# targets exist. Every path is relative: an installed tree can be moved.
include(CMakePackageConfigHelpers)

set(trocar_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Trocar)
set(trocar_pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
set(trocar_include_dir ${CMAKE_INSTALL_INCLUDEDIR}/trocar)
set(trocar_doc_dir ${CMAKE_INSTALL_DATAROOTDIR}/doc/trocar)

file(RELATIVE_PATH trocar_bin_to_lib /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
set_target_properties(trocar trocar-watch trocar-dashboard PROPERTIES INSTALL_RPATH "$ORIGIN/${trocar_bin_to_lib}")
set_target_properties(trocar_framework trocar_components PROPERTIES INSTALL_RPATH "$ORIGIN")

install(TARGETS trocar trocar-watch trocar-dashboard RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS trocar_framework trocar_components EXPORT TrocarTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/framework ${PROJECT_SOURCE_DIR}/components
  DESTINATION ${trocar_include_dir} FILES_MATCHING PATTERN "*.hpp"
  PATTERN framework/cmake EXCLUDE
  PATTERN framework/scripting EXCLUDE
  PATTERN message_json.hpp EXCLUDE)  # needs a library that nobody else has to have
# The others need Lua's, and are of no use outside of the binding.
install(FILES framework/scripting/script.hpp framework/scripting/spec.hpp
  DESTINATION ${trocar_include_dir}/framework/scripting)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scripts
  DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/trocar PATTERN scripts/dev EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/plugins/example
  DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/trocar/plugins)
install(FILES components/devices/hid/70-trocar.rules DESTINATION lib/udev/rules.d)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${trocar_doc_dir})
install(FILES README.md CHANGELOG.md LICENSE framework/cmake/copyright DESTINATION ${trocar_doc_dir})

# What the shells complete, by the program that was built.
if(NOT CMAKE_CROSSCOMPILING)
  set(trocar_completions ${PROJECT_BINARY_DIR}/completions)
  file(MAKE_DIRECTORY ${trocar_completions})
  foreach(script bash:bash-completion/completions/trocar zsh:zsh/site-functions/_trocar
                 fish:fish/vendor_completions.d/trocar.fish)
    string(REGEX MATCH "^([a-z]+):(.*)/([^/]*)$" matched ${script})
    install(CODE "execute_process(COMMAND \"$<TARGET_FILE:trocar>\" completion ${CMAKE_MATCH_1}
      OUTPUT_FILE \"${trocar_completions}/${CMAKE_MATCH_3}.${CMAKE_MATCH_1}\" COMMAND_ERROR_IS_FATAL ANY)")
    install(FILES ${trocar_completions}/${CMAKE_MATCH_3}.${CMAKE_MATCH_1}
      DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/${CMAKE_MATCH_2} RENAME ${CMAKE_MATCH_3})
  endforeach()
endif()

install(EXPORT TrocarTargets NAMESPACE Trocar:: DESTINATION ${trocar_package_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/TrocarConfig.cmake.in
  ${PROJECT_BINARY_DIR}/TrocarConfig.cmake INSTALL_DESTINATION ${trocar_package_dir}
  PATH_VARS trocar_include_dir)
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/TrocarConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/TrocarConfig.cmake ${PROJECT_BINARY_DIR}/TrocarConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/TrocarCheckConsumer.cmake ${CMAKE_CURRENT_LIST_DIR}/TrocarPlugin.cmake
  DESTINATION ${trocar_package_dir})

file(RELATIVE_PATH trocar_pkgconfig_to_prefix /${trocar_pkgconfig_dir} /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/trocar.pc.in ${PROJECT_BINARY_DIR}/trocar.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/trocar.pc DESTINATION ${trocar_pkgconfig_dir})

if(PROJECT_IS_TOP_LEVEL)
  include(TrocarPackage)
endif()
