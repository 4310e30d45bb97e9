# boomwatch_options carries warnings and sanitizers to our own targets only: no global flags.
add_library(boomwatch_options INTERFACE)
target_compile_options(boomwatch_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wno-deprecated-enum-enum-conversion
  $<$<BOOL:${BOOMWATCH_WERROR}>:-Werror>)
if(BOOMWATCH_SANITIZE)
  target_compile_options(boomwatch_options INTERFACE
    -fsanitize=${BOOMWATCH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  # Under AddressSanitizer Eigen allocates in a way of its own, which Debian's PCL, built without
  # it, then frees wrongly; malloc is aligned enough for both.
  target_compile_definitions(boomwatch_options INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
  target_link_options(boomwatch_options INTERFACE -fsanitize=${BOOMWATCH_SANITIZE})
endif()
