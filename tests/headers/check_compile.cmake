# Compiles FILE with FLAGS, without making anything. With EXPECTED, a pattern, it must be refused in
# one error that matches it; without, it must pass.
string(REPLACE "|" ";-I" include "-I${INCLUDE}")
execute_process(
  COMMAND "${COMPILER}" -fsyntax-only ${FLAGS} ${include} -x c++ "${FILE}"
  RESULT_VARIABLE result ERROR_VARIABLE words)
string(REGEX MATCHALL "error: [^\n]*" errors "${words}")
list(LENGTH errors count)
if(EXPECTED STREQUAL "")
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${FILE} does not compile with ${FLAGS}:\n${words}")
  endif()
elseif(result EQUAL 0 OR NOT count EQUAL 1 OR NOT errors MATCHES "${EXPECTED}")
  message(FATAL_ERROR "${FILE} with ${FLAGS} must be refused with one error, '${EXPECTED}':\n${words}")
endif()
