# The project's warnings, as a target that every other target links privately.
add_library(trocar_warnings INTERFACE)
target_compile_options(trocar_warnings INTERFACE
  -Wall -Wextra -Wpedantic
  -Wshadow              # a local must not hide a member or a parameter
  -Wconversion          # narrowing of a measured value is a bug
  -Wdouble-promotion    # every number here is a double already
  -Wnon-virtual-dtor    # components are deleted through their base
  -Wold-style-cast      # C casts hide what they do
  -Woverloaded-virtual  # a step() that does not override never runs
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # false alarms in GCC 12's std::string (PR 105329)
  $<$<BOOL:${TROCAR_WERROR}>:-Werror>)
