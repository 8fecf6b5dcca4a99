# What is compiled by nvcc. CMake 3.25.1 cannot name CUDA C++20, so that the option stands here.
set(cuda_pipelines cuda/boxes.cu cuda/discs.cu cuda/discs_float.cu cuda/periodic_discs.cu
  cuda/periodic_spheres.cu cuda/rectangles.cu cuda/spheres.cu cuda/spheres_float.cu)
add_library(abut_device_cuda OBJECT cuda/array_place.cu cuda/cuda_backend.cu cuda/cuda_executor.cu
  cuda/decide_images.cu cuda/decide_open.cu cuda/earlier_work.cu cuda/measure_open_gaps.cu
  cuda/runnable_device.cu cuda/runtime_pool.cu ${cuda_pipelines})
# No fused multiply-add, on either processor: the same bits everywhere (docs/contract.md).
target_compile_options(abut_device_cuda PRIVATE -std=c++20 --fmad=false --expt-relaxed-constexpr
  "-Xcompiler=-ffp-contract=off,-fno-math-errno" ${ABUT_CUDA_WARNINGS})
# The report of the compiler as a test: registers that do not suffice, and memory of a thread, are
# warnings, but for the last exact stages, which keep a number of 4480 bits there.
set_source_files_properties(${cuda_pipelines}
  PROPERTIES COMPILE_OPTIONS "-Xptxas=--warn-on-spills,--warn-on-local-memory-usage")
target_include_directories(abut_device_cuda PRIVATE "${PROJECT_SOURCE_DIR}/src"
  "${PROJECT_SOURCE_DIR}/include")
set_target_properties(abut_device_cuda PROPERTIES POSITION_INDEPENDENT_CODE ON
  CUDA_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
