# Compiles CONTROL, then each of COUNT ways round the gate in SOURCE; a bypass must fail, and for the
# right reason.
list(TRANSFORM INCLUDES PREPEND -I)
set(compile ${COMPILER} -std=c++20 -fsyntax-only ${INCLUDES})

if(CONTROL)
  execute_process(COMMAND ${compile} ${CONTROL} RESULT_VARIABLE failed ERROR_VARIABLE said)
  if(failed)
    message(FATAL_ERROR "the control must compile:\n${said}")
  endif()
endif()
execute_process(COMMAND ${compile} -DBYPASS=0 ${SOURCE} RESULT_VARIABLE failed ERROR_VARIABLE said)
if(failed)
  message(FATAL_ERROR "without a bypass the source must compile:\n${said}")
endif()
foreach(bypass RANGE 1 ${COUNT})
  execute_process(COMMAND ${compile} -DBYPASS=${bypass} ${SOURCE}
    RESULT_VARIABLE failed ERROR_VARIABLE said)
  if(NOT failed)
    message(SEND_ERROR "bypass ${bypass} compiles")
  elseif(NOT said MATCHES "private|deleted|trivially copyable|no matching (member )?function|no matching constructor|no viable conversion|does not override|marked 'override'|could not convert|cannot convert|invalid initialization")
    message(SEND_ERROR "bypass ${bypass} fails for another reason:\n${said}")
  endif()
endforeach()
