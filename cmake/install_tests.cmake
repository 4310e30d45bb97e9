# Tests of what is installed: the tree, the files for desktops, and the Debian package.
#
# Exit code 77 is a skip: the tools or the package are not there.
function(boomwatch_install_test name)
  add_test(NAME ${name} COMMAND ${ARGN} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES LABELS install TIMEOUT 600 SKIP_RETURN_CODE 77)
endfunction()

boomwatch_install_test(test_install packaging/test_install ${CMAKE_BINARY_DIR})
boomwatch_install_test(test_desktop_files packaging/test_desktop_files)
boomwatch_install_test(test_deb
  packaging/test_deb ${CMAKE_SOURCE_DIR}/build/deb/boomwatch_${PROJECT_VERSION}_amd64.deb)
