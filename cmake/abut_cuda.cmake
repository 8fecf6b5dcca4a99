# Devices. ABUT_CUDA: ON demands a CUDA compiler, OFF does without, AUTO takes what is found; a build
# under a sanitizer, for device code has none, or for another machine then does without.
set(ABUT_USE_CUDA OFF)
if(ABUT_CUDA STREQUAL ON OR
   (ABUT_CUDA STREQUAL AUTO AND NOT ABUT_SANITIZE AND NOT CMAKE_CROSSCOMPILING))
  include(CheckLanguage)
  check_language(CUDA)
  if(CMAKE_CUDA_COMPILER)
    # One architecture, and its PTX for those that come.
    if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
      set(CMAKE_CUDA_ARCHITECTURES 90)
    endif()
    enable_language(CUDA)
    find_package(CUDAToolkit REQUIRED)
    set(ABUT_USE_CUDA ON)
  elseif(ABUT_CUDA STREQUAL ON)
    message(FATAL_ERROR "ABUT_CUDA is ON, but no CUDA compiler is found; set CUDACXX to nvcc, or "
      "take AUTO or OFF")
  endif()
endif()

# The warnings of what nvcc compiles, errors where those of the project are.
set(ABUT_CUDA_WARNINGS "-Xcompiler=-Wall,-Wextra"
  $<$<BOOL:${ABUT_WARNINGS_AS_ERRORS}>:-Werror=all-warnings>)

if(ABUT_USE_CUDA)
  message(STATUS "abut: devices (CUDA) ${CMAKE_CUDA_COMPILER_VERSION}")
else()
  message(STATUS "abut: devices (CUDA) OFF: abut::device is built without, and finds no device")
endif()
