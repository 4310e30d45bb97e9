# What `cmake --install` puts where. The Debian package (debian/) is made of the same rules.
#
# The programs write their own manual pages and completions, from their tables of options and
# parameters. Sanitizer builds are for tests and are not installed.
if(NOT BOOMWATCH_GUI OR BOOMWATCH_SANITIZE)
  return()
endif()
include(GNUInstallDirs)
set(pages ${CMAKE_BINARY_DIR}/pages)
set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor)
set(desktop ${CMAKE_SOURCE_DIR}/packaging/desktop)

# A document that a program prints of itself.
function(boomwatch_page program document file)
  add_custom_command(OUTPUT ${pages}/${file}
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${program}> -DDOCUMENT=${document}
      -DOUTPUT=${pages}/${file} -P ${CMAKE_SOURCE_DIR}/cmake/print_page.cmake
    DEPENDS ${program} ${CMAKE_SOURCE_DIR}/cmake/print_page.cmake
    VERBATIM)
endfunction()

set(page_files "")
foreach(program IN ITEMS boomwatch boomwatch-lab)
  install(TARGETS ${program} RUNTIME)
  boomwatch_page(${program} man ${program}.1)
  boomwatch_page(${program} completion ${program}.bash)
  list(APPEND page_files ${pages}/${program}.1 ${pages}/${program}.bash)
  install(FILES ${pages}/${program}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${pages}/${program}.bash RENAME ${program}
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endforeach()

# Desktops draw the icon from the SVG; some panels and software centres take PNG only.
set(icon ${CMAKE_SOURCE_DIR}/resources/icons/boomwatch.svg)
install(FILES ${icon} DESTINATION ${icons}/scalable/apps)
find_program(RSVG_CONVERT rsvg-convert)
if(RSVG_CONVERT)
  foreach(size IN ITEMS 16 24 32 48 64 128 256)
    set(png ${pages}/${size}/boomwatch.png)
    add_custom_command(OUTPUT ${png}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${pages}/${size}
      COMMAND ${RSVG_CONVERT} --width ${size} --height ${size} --output ${png} ${icon}
      DEPENDS ${icon} VERBATIM)
    list(APPEND page_files ${png})
    install(FILES ${png} DESTINATION ${icons}/${size}x${size}/apps)
  endforeach()
endif()
add_custom_target(boomwatch_pages ALL DEPENDS ${page_files})

install(FILES ${desktop}/boomwatch.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES ${desktop}/boomwatch.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES ${desktop}/boomwatch.mime.xml RENAME boomwatch.xml
  DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)

# The README links docs/ and resources/screenshot.png, so they keep their places beside it.
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
install(FILES resources/screenshot.png DESTINATION ${CMAKE_INSTALL_DOCDIR}/resources)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL
  FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.svg" PATTERN "*.json")

if(BOOMWATCH_TESTS)
  include(cmake/install_tests.cmake)
endif()
