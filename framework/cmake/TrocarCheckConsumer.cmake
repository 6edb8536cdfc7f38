# What find_package(Trocar) asks of the project that calls it. Each function sets `answer` to what
# does not fit: what, the value, what is allowed. "" when all is well.

# Which of COMPONENTS are not among those named after `version`?
function(trocar_check_components answer version)
  list(JOIN ARGN ", " known)
  set(said "")
  foreach(component IN LISTS Trocar_FIND_COMPONENTS)
    if(Trocar_FIND_REQUIRED_${component} AND NOT component IN_LIST ARGN)
      string(APPEND said "Trocar ${version} has no component \"${component}\"; it has ${known}.\n")
    endif()
  endforeach()
  set(${answer} "${said}" PARENT_SCOPE)
endfunction()

# The compiler, and whether its flags leave Eigen's alignment as it is in the libraries.
function(trocar_check_compiler answer include_dir)
  set(oldest_GNU 12)
  set(oldest_Clang 14)
  set(said "")
  if(NOT CMAKE_CXX_COMPILER_LOADED)
    set(said "Trocar is C++: name CXX among the languages of project(), before find_package(Trocar).")
  elseif(NOT DEFINED oldest_${CMAKE_CXX_COMPILER_ID}
      OR CMAKE_CXX_COMPILER_VERSION VERSION_LESS oldest_${CMAKE_CXX_COMPILER_ID})
    set(said "The compiler is ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} (${CMAKE_CXX_COMPILER}): \
Trocar needs GNU ${oldest_GNU} or newer, or Clang ${oldest_Clang} or newer, for C++20.")
  else()
    trocar_check_alignment(said "${include_dir}")
  endif()
  set(${answer} "${said}" PARENT_SCOPE)
endfunction()

# Preprocesses framework/abi.hpp with the flags that the caller's targets will have. Flags of a single
# target cannot be known here; abi.hpp refuses them when that target is compiled.
function(trocar_check_alignment answer include_dir)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" configuration)
  separate_arguments(flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${configuration}}")
  get_directory_property(options COMPILE_OPTIONS)
  get_directory_property(definitions COMPILE_DEFINITIONS)
  list(TRANSFORM definitions PREPEND -D)
  list(APPEND flags ${options} ${definitions})
  list(FILTER flags EXCLUDE REGEX "\\$<")  # what only the generator can evaluate

  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  list(TRANSFORM eigen PREPEND -I)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} ${flags} -std=c++20 -E ${eigen}
    -x c++ ${include_dir}/framework/abi.hpp ERROR_VARIABLE said OUTPUT_QUIET)

  set(${answer} "" PARENT_SCOPE)
  # Any other error is not about alignment, and the project's own compilation will report it.
  if(said MATCHES "Eigen's alignment is not")
    list(FILTER flags INCLUDE REGEX "^-m|EIGEN_")
    list(JOIN flags " " flags)
    set(${answer} "The compiler's flags (CMAKE_CXX_FLAGS, add_compile_options) hold ${flags}: \
this changes Eigen's alignment, which is 16 bytes in Trocar's libraries, and a program that mixes the two \
crashes. Leave out -march=, -mavx and Eigen's definitions, or add -DEIGEN_MAX_ALIGN_BYTES=16 to -march= or -mavx."
      PARENT_SCOPE)
  endif()
endfunction()
