# Installs a build into a folder of its own, then builds and runs a project against it.
#   cmake -DBUILD=… -DWORK=… -DCONSUMER=… -DGENERATOR=… -P install_and_use.cmake
file(REMOVE_RECURSE ${WORK})

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
# Moved: nothing in the package may know where it was installed to.
file(RENAME ${WORK}/first ${WORK}/moved)

run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G ${GENERATOR}
  -DCMAKE_PREFIX_PATH=${WORK}/moved -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
run(${WORK}/moved/bin/trocar --help)
foreach(script bash-completion/completions/trocar zsh/site-functions/_trocar fish/vendor_completions.d/trocar.fish)
  file(READ ${WORK}/moved/share/${script} text)
  if(NOT text MATCHES "kinematics")
    message(FATAL_ERROR "share/${script} completes nothing")
  endif()
endforeach()
