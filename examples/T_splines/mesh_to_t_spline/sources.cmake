# Copyright (c) 2026 The T_splines authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Included by the CMakeLists.txt above. The stages of the program are compiled apart from each other: each of them
# instantiates much.

file(GLOB stages CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
target_sources(mesh_to_t_spline PRIVATE ${stages})
