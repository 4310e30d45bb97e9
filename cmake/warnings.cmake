# boomwatch_options carries warnings and sanitizers to our own targets only: no global flags.
add_library(boomwatch_options INTERFACE)
target_compile_options(boomwatch_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wno-deprecated-enum-enum-conversion
  $<$<BOOL:${BOOMWATCH_WERROR}>:-Werror>)
if(BOOMWATCH_SANITIZE)
  target_compile_options(boomwatch_options INTERFACE
    -fsanitize=${BOOMWATCH_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(boomwatch_options INTERFACE -fsanitize=${BOOMWATCH_SANITIZE})
endif()
