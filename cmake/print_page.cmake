# cmake -DPROGRAM=... -DDOCUMENT=... -DOUTPUT=... -P print_page.cmake
#
# Writes what PROGRAM prints of itself to OUTPUT; a program that fails leaves no half a page. It
# needs no display.
execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=DISPLAY --unset=WAYLAND_DISPLAY
  QT_QPA_PLATFORM=offscreen ${PROGRAM} --print ${DOCUMENT}
  OUTPUT_FILE ${OUTPUT}.part RESULT_VARIABLE failed ERROR_VARIABLE complaint)
if(failed)
  file(REMOVE ${OUTPUT}.part)
  message(FATAL_ERROR "${PROGRAM} --print ${DOCUMENT} failed (${failed}): ${complaint}")
endif()
file(RENAME ${OUTPUT}.part ${OUTPUT})
