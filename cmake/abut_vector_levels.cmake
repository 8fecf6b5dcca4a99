# Levels of vectors that the kernels are compiled for. ABUT_SIMD_LEVELS: all, or some of those that
# x86 has, for a smaller library that compiles in less time; plain C++ is always there.
#   ABUT_VECTOR_DEFINITIONS  what tells Highway, for every source that names its targets

# Not for SVE: its vectors have no size that the compiler knows, so no class can hold one; NEON runs.
set(unused_targets HWY_SVE HWY_SVE2 HWY_SVE_256 HWY_SVE2_128)
set(ABUT_VECTOR_DEFINITIONS)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  # The lowest first, as abut::Simd and as Highway call them.
  set(levels sse4 avx2 avx512)
  set(target_of_sse4 HWY_SSE4)
  set(target_of_avx2 HWY_AVX2)
  set(target_of_avx512 HWY_AVX3)
  set(chosen ${levels})
  if(NOT ABUT_SIMD_LEVELS STREQUAL all)
    set(chosen ${ABUT_SIMD_LEVELS})
    list(REMOVE_ITEM chosen ${levels})
    if(chosen OR NOT ABUT_SIMD_LEVELS)
      list(JOIN levels ", " known)
      message(FATAL_ERROR "ABUT_SIMD_LEVELS is '${ABUT_SIMD_LEVELS}'; take all, or some of ${known}; "
        "ABUT_HIGHWAY=OFF is none")
    endif()
    set(chosen ${levels})
    foreach(level IN LISTS levels)
      if(NOT level IN_LIST ABUT_SIMD_LEVELS)
        list(REMOVE_ITEM chosen ${level})
        list(APPEND unused_targets ${target_of_${level}})
      endif()
    endforeach()
  endif()
  # Not for SSSE3: abut::Simd names no level between scalar and sse4, so nothing could choose it. Nor
  # for what every processor runs, which Highway adds by itself: the scalar level is plain C++ of our
  # own. With Clang it was half of the machine code of all levels. The lowest level takes its place as
  # the one that Highway calls static; processors without it are never sent there.
  list(APPEND unused_targets HWY_SSSE3 HWY_SCALAR HWY_EMU128)
  list(GET chosen 0 lowest)
  list(APPEND ABUT_VECTOR_DEFINITIONS HWY_BASELINE_TARGETS=${target_of_${lowest}})
elseif(NOT ABUT_SIMD_LEVELS STREQUAL all)
  message(FATAL_ERROR "ABUT_SIMD_LEVELS is '${ABUT_SIMD_LEVELS}', but only x86 has levels to choose; "
    "take all")
endif()
# Left out for good, for the reasons above, or unless they are chosen.
list(JOIN unused_targets "|" unused_targets)
list(APPEND ABUT_VECTOR_DEFINITIONS "HWY_DISABLED_TARGETS=(${unused_targets})")
