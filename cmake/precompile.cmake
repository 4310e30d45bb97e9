# boomwatch_precompile(TARGET HEADER...): precompiled headers that ccache can keep.
#
# ccache would hash the precompiled header itself, 400 MB, at every compile. Given a checksum beside
# it, it reads that instead. The checksum names all that the header is made of: the compiler, its
# flags, the headers and the packages they come from.
option(BOOMWATCH_PRECOMPILE "Precompile the headers of Qt, OpenCV and Eigen" ON)

function(boomwatch_precompile target)
  if(NOT BOOMWATCH_PRECOMPILE)
    return()
  endif()
  target_precompile_headers(${target} PRIVATE ${ARGN})
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  string(SHA256 sum "${target} ${ARGN} ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} \
${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${BOOMWATCH_SANITIZE} ${BOOMWATCH_WERROR} \
${OpenCV_VERSION} ${Eigen3_VERSION} ${Qt6_VERSION} ${PCL_VERSION}")
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/cmake_pch.hxx.gch.sum "${sum}\n")
endfunction()
