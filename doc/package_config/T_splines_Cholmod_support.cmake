# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# If CHOLMOD is found, defines the target T_splines::Cholmod_support: what links it may use
# CGAL::T_splines::Cholmod_spd_solver_traits.

find_path(T_SPLINES_CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(T_SPLINES_CHOLMOD_LIBRARY cholmod)
mark_as_advanced(T_SPLINES_CHOLMOD_INCLUDE_DIR T_SPLINES_CHOLMOD_LIBRARY)

if(T_SPLINES_CHOLMOD_INCLUDE_DIR AND T_SPLINES_CHOLMOD_LIBRARY AND NOT TARGET T_splines::Cholmod_support)
  add_library(T_splines::Cholmod_support INTERFACE IMPORTED)
  set_target_properties(T_splines::Cholmod_support PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS CGAL_T_SPLINES_WITH_CHOLMOD
    INTERFACE_INCLUDE_DIRECTORIES "${T_SPLINES_CHOLMOD_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${T_SPLINES_CHOLMOD_LIBRARY}")
endif()
