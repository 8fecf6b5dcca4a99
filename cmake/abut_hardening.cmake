# Hardening of what is installed: a fault in memory ends the program at once instead of being used.
# Each is left out where the compiler or the linker lacks it. What it costs: docs/adr/0017.
#   ABUT_HARDENING_COMPILE     stack protector; checked memcpy and the like where sizes are known
#   ABUT_HARDENING_LINK        relocations are resolved at the start and read-only from then on
#   ABUT_HARDENING_ASSERTIONS  preconditions of the standard library, for the tool; the core's
#                              loops go without
include(CheckCXXCompilerFlag)
include(CheckCXXSourceCompiles)
include(CheckLinkerFlag)
include(CheckPIESupported)

set(ABUT_HARDENING_COMPILE)
set(ABUT_HARDENING_LINK)
set(ABUT_HARDENING_ASSERTIONS)
check_pie_supported(LANGUAGES CXX)

# Sanitizers bring stronger checks, and their own definitions of the checked functions.
if(ABUT_HARDENING AND NOT ABUT_SANITIZE AND NOT WIN32)
  set(ABUT_HARDENING_ASSERTIONS _GLIBCXX_ASSERTIONS)
  check_cxx_compiler_flag(-fstack-protector-strong ABUT_HAS_STACK_PROTECTOR)
  if(ABUT_HAS_STACK_PROTECTOR)
    list(APPEND ABUT_HARDENING_COMPILE -fstack-protector-strong)
  endif()

  # Only optimised code can be checked, and the system's headers warn where it is not. A value that
  # the caller's own flags give stays.
  string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
  set(CMAKE_REQUIRED_FLAGS
    "${CMAKE_CXX_FLAGS_${build_type}} -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2 -Werror")
  check_cxx_source_compiles("#include <cstdlib>\nint main() { return 0; }" ABUT_HAS_FORTIFY)
  unset(CMAKE_REQUIRED_FLAGS)
  if(ABUT_HAS_FORTIFY AND NOT CMAKE_CXX_FLAGS MATCHES "_FORTIFY_SOURCE")
    list(APPEND ABUT_HARDENING_COMPILE -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
  endif()

  foreach(flag IN ITEMS relro now)
    string(TOUPPER "${flag}" name)
    check_linker_flag(CXX "LINKER:-z,${flag}" ABUT_HAS_${name})
    if(ABUT_HAS_${name})
      list(APPEND ABUT_HARDENING_LINK "LINKER:-z,${flag}")
    endif()
  endforeach()
endif()
