# Installs the libraries, their headers and the program, so that find_package(Trocar)
# gives Trocar::framework and Trocar::components. Included last, when all targets exist.
include(CMakePackageConfigHelpers)

set(trocar_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Trocar)

file(RELATIVE_PATH trocar_bin_to_lib /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
set_target_properties(trocar PROPERTIES INSTALL_RPATH "$ORIGIN/${trocar_bin_to_lib}")
set_target_properties(trocar_framework trocar_components PROPERTIES INSTALL_RPATH "$ORIGIN")

install(TARGETS trocar RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS trocar_framework trocar_components EXPORT TrocarTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/framework ${PROJECT_SOURCE_DIR}/components
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trocar
  FILES_MATCHING PATTERN "*.hpp" PATTERN framework/cmake EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

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
  ${PROJECT_BINARY_DIR}/TrocarConfig.cmake INSTALL_DESTINATION ${trocar_package_dir})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/TrocarConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/TrocarConfig.cmake ${PROJECT_BINARY_DIR}/TrocarConfigVersion.cmake
  DESTINATION ${trocar_package_dir})
