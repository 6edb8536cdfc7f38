# trocar_plugin(NAME SOURCE...): the plugin NAME, a file NAME.so that exports trocar_plugin() and
# nothing else. A target like any other: more libraries come by target_link_libraries.
#
#   TROCAR_PLUGIN_OUTPUT_DIRECTORY  where it is built; by default the build folder
#   TROCAR_PLUGIN_DESTINATION       where it is installed, below the prefix; "" for nowhere. By
#                                   default where the Trocar that was found, under the same prefix,
#                                   looks for plugins
function(trocar_plugin name)
  add_library(${name} MODULE ${ARGN})
  # The standard is that of Trocar's libraries: the loader asks for the same.
  set_target_properties(${name} PROPERTIES
    PREFIX "" SUFFIX .so
    CXX_STANDARD 20 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    INSTALL_RPATH "$ORIGIN/../..")
  target_link_libraries(${name} PRIVATE Trocar::framework)
  if(TARGET trocar_warnings)  # in Trocar's own tree
    target_link_libraries(${name} PRIVATE trocar_warnings)
  endif()
  if(TROCAR_PLUGIN_OUTPUT_DIRECTORY)
    set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${TROCAR_PLUGIN_OUTPUT_DIRECTORY})
  endif()
  if(TROCAR_PLUGIN_DESTINATION)
    install(TARGETS ${name} LIBRARY DESTINATION ${TROCAR_PLUGIN_DESTINATION})
  endif()
endfunction()
