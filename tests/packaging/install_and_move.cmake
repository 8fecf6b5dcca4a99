# cmake -DBUILD=folder -DPREFIX=folder -P install_and_move.cmake: installs, then moves the tree, so
# that what is tested has no knowledge of where it was installed.
file(REMOVE_RECURSE "${PREFIX}" "${PREFIX}.before")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}.before"
  COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${PREFIX}.before" "${PREFIX}")
