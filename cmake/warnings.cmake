# boomwatch_options carries warnings, hardening and sanitizers to our own targets only: no global
# flags.
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
else()
  # The program reads files and streams from anywhere. A smashed stack or an overflow that the
  # compiler can measure ends it. The linker's tables are read-only, and addresses are random.
  # Fortify needs an optimising build. Sanitizers find more, and fortify hides faults from them.
  target_compile_options(boomwatch_options INTERFACE -fstack-protector-strong
    $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>)
  target_link_options(boomwatch_options INTERFACE -pie LINKER:-z,relro,-z,now)
endif()
