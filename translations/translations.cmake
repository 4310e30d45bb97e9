# `ninja update_translations` gathers the texts, `release_translations` (part of the build) compiles
# them into the program, at :/i18n.
#
# lupdate does not expand macros: the parameter table's short TR() is spelled out for it in a copy.
set(parameter_rows ${CMAKE_SOURCE_DIR}/core/parameters/environment_rows.h
  ${CMAKE_SOURCE_DIR}/core/parameters/load_and_stereo_rows.h)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${parameter_rows})
set(parameter_texts "")
foreach(rows IN LISTS parameter_rows)
  file(READ ${rows} texts)
  string(APPEND parameter_texts "${texts}")
endforeach()
string(REPLACE "TR(" "QT_TRANSLATE_NOOP(\"Parameters\", " parameter_texts "${parameter_texts}")
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/parameter_texts.cpp CONTENT "${parameter_texts}"
  @ONLY)

# Not the command line: it speaks English, whatever the window speaks.
file(GLOB window_texts CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/app/*.cpp ${CMAKE_SOURCE_DIR}/app/*.h
  ${CMAKE_SOURCE_DIR}/widgets/*.cpp ${CMAKE_SOURCE_DIR}/widgets/*.h)
list(FILTER window_texts EXCLUDE REGEX "/(main|command_line|headless|result_json|result_fields|parameter_document)\\.")

qt_add_translations(boomwatch_app
  TS_FILES ${CMAKE_SOURCE_DIR}/translations/boomwatch_de.ts
  SOURCES ${window_texts} ${CMAKE_CURRENT_BINARY_DIR}/parameter_texts.cpp
  LUPDATE_OPTIONS -locations none -no-obsolete
  RESOURCE_PREFIX "/i18n")
