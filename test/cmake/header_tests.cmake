# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/include/*.h)

# What a header includes before anything else is compiled alone whenever this header is.
set(first_includes)
foreach(header IN LISTS headers)
  file(STRINGS ${PROJECT_SOURCE_DIR}/include/${header} first_include LIMIT_COUNT 1 REGEX "^#include <[^>]*>")
  string(REGEX REPLACE "^#include <(.*)>.*" "\\1" first_include "${first_include}")
  list(APPEND first_includes ${first_include})
endforeach()

# Every header compiles alone: one translation unit for each that is not a first include, without precompiled headers.
set(header_sources)
set(public_includes "")
foreach(header IN LISTS headers)
  set(include "#include <${header}>\n")
  if(NOT header MATCHES "/(internal|support)/")
    string(APPEND public_includes "${include}")
  endif()
  if(header IN_LIST first_includes)
    continue()
  endif()
  string(MAKE_C_IDENTIFIER ${header} name)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/headers/${name}.cpp)
  file(GENERATE OUTPUT ${source} CONTENT "${include}")
  list(APPEND header_sources ${source})
endforeach()
add_library(t_splines_headers OBJECT EXCLUDE_FROM_ALL ${header_sources})
target_link_libraries(t_splines_headers PRIVATE t_splines_program_settings)
target_compile_options(t_splines_headers PRIVATE -O0)
set_target_properties(t_splines_headers PROPERTIES UNITY_BUILD OFF)
add_test(NAME headers.each_compiles_alone
  COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --config $<CONFIG> --target t_splines_headers --parallel 2)
set_tests_properties(headers.each_compiles_alone PROPERTIES LABELS headers TIMEOUT 1200 RUN_SERIAL ON)

# The rules that a script can check.
find_program(T_SPLINES_BASH bash)
mark_as_advanced(T_SPLINES_BASH)
if(T_SPLINES_BASH)
  add_test(NAME headers.house_rules
    COMMAND ${T_SPLINES_BASH} ${CMAKE_CURRENT_SOURCE_DIR}/check_headers.sh ${PROJECT_SOURCE_DIR}/include)
  set_tests_properties(headers.house_rules PROPERTIES LABELS headers)
endif()

# The second compiler reads the public headers, and the examples, which instantiate them; it generates no code.
find_program(T_SPLINES_CLANG clang++)
mark_as_advanced(T_SPLINES_CLANG)
if(T_SPLINES_CLANG AND NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
  set(public_headers ${CMAKE_CURRENT_BINARY_DIR}/headers/public_headers.cpp)
  file(GENERATE OUTPUT ${public_headers} CONTENT "${public_includes}")
  file(GLOB example_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/T_splines/*.cpp)

  # -idirafter, because /usr/include among them must keep its place.
  set(dependencies CGAL::CGAL Eigen3::Eigen)
  if(T_SPLINES_WITH_CHOLMOD)
    list(APPEND dependencies T_splines::Cholmod_support)
  endif()
  if(T_SPLINES_WITH_TBB)
    list(APPEND dependencies CGAL::TBB_support)
  endif()
  set(clang_options -std=c++17 -fsyntax-only -frounding-math -Wall -Wextra -Wpedantic -Werror
    -I${PROJECT_SOURCE_DIR}/include)
  foreach(dependency IN LISTS dependencies)
    set(directories "$<TARGET_PROPERTY:${dependency},INTERFACE_INCLUDE_DIRECTORIES>")
    list(APPEND clang_options "$<$<BOOL:${directories}>:-idirafter$<JOIN:${directories},;-idirafter>>")
  endforeach()
  set(definitions "$<TARGET_PROPERTY:t_splines_headers,COMPILE_DEFINITIONS>")
  list(APPEND clang_options "$<$<BOOL:${definitions}>:-D$<JOIN:${definitions},;-D>>")

  foreach(source IN LISTS public_headers example_sources)
    get_filename_component(name ${source} NAME_WE)
    add_test(NAME clang.${name} COMMAND ${T_SPLINES_CLANG} "${clang_options}"
      -I${PROJECT_BINARY_DIR}/examples/T_splines/${name} ${source} COMMAND_EXPAND_LISTS)
    set_tests_properties(clang.${name} PROPERTIES LABELS clang TIMEOUT 600)
  endforeach()
endif()
