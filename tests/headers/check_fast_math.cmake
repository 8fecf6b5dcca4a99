# Compiles one header with FLAG: -ffast-math must be refused, in our words, anything else must pass.
execute_process(
  COMMAND "${COMPILER}" -std=c++20 -fsyntax-only ${FLAG} "-I${INCLUDE}" -include "${HEADER}"
    -x c++ /dev/null
  RESULT_VARIABLE result ERROR_VARIABLE words)
if(FLAG STREQUAL "-ffast-math")
  if(result EQUAL 0 OR NOT words MATCHES "abut decides contacts exactly; compile without -ffast-math")
    message(FATAL_ERROR "${HEADER} accepts ${FLAG} (exit code ${result}):\n${words}")
  endif()
elseif(NOT result EQUAL 0)
  message(FATAL_ERROR "${HEADER} does not compile with ${FLAG}:\n${words}")
endif()
