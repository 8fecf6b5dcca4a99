# Levels of vectors that the kernels are compiled for. ABUT_SIMD_LEVELS: all, or some of those that
# x86-64 has, for a smaller library that compiles in less time; plain C++ is always there.
#   ABUT_VECTOR_DEFINITIONS  what tells Highway, for every source that names its targets

# Not for SSSE3: abut::Simd names no level between scalar and sse4, so nothing could choose it. Not for
# SVE: its vectors have no size that the compiler knows, so no class can hold one; NEON runs.
set(unused_targets HWY_SSSE3 HWY_SVE HWY_SVE2 HWY_SVE_256 HWY_SVE2_128)
set(ABUT_VECTOR_DEFINITIONS)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  # The lowest first, as abut::Simd and as Highway call them.
  set(levels sse4 avx2 avx512)
  set(target_of_sse4 HWY_SSE4)
  set(target_of_avx2 HWY_AVX2)
  set(target_of_avx512 HWY_AVX3)
  set(chosen ${ABUT_SIMD_LEVELS})
  if(chosen STREQUAL all)
    set(chosen ${levels})
  endif()
  set(unknown ${chosen})
  list(REMOVE_ITEM unknown ${levels})
  if(unknown OR NOT chosen)
    list(JOIN levels ", " known)
    message(FATAL_ERROR "ABUT_SIMD_LEVELS is '${ABUT_SIMD_LEVELS}'; take all, or some of ${known}; "
      "ABUT_HIGHWAY=OFF is none")
  endif()
  # The lowest level takes the place of what every processor runs, which Highway adds by itself and
  # calls static: the scalar level is plain C++ of our own. With Clang it was half of the machine code
  # of all levels. Processors without the lowest level are never sent there.
  list(APPEND unused_targets HWY_SCALAR HWY_EMU128)
  foreach(level IN LISTS levels)
    if(NOT level IN_LIST chosen)
      list(APPEND unused_targets ${target_of_${level}})
    elseif(NOT ABUT_VECTOR_DEFINITIONS)
      set(ABUT_VECTOR_DEFINITIONS HWY_BASELINE_TARGETS=${target_of_${level}})
    endif()
  endforeach()
elseif(NOT ABUT_SIMD_LEVELS STREQUAL all)
  message(FATAL_ERROR "ABUT_SIMD_LEVELS is '${ABUT_SIMD_LEVELS}', but only x86-64 has levels to choose; "
    "take all")
endif()
# The macro's name is Highway's own, for targets that are not compiled: those that no level could run,
# for the reasons above, and those that were not chosen. No test is switched off by it.
list(JOIN unused_targets "|" unused_targets)
list(APPEND ABUT_VECTOR_DEFINITIONS "HWY_DISABLED_TARGETS=(${unused_targets})")
