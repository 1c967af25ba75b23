// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_IO_TRIANGLE_WITH_FIELD_H
#define T_SPLINES_TEST_IO_TRIANGLE_WITH_FIELD_H

#include "Cross_field/test_meshes.h"

#include <cmath>

/// The angle of a cross in the xy plane, modulo a right angle.
inline double angle_of_cross(const test::Vector_3& v)
{
  return std::remainder(std::atan2(v.y(), v.x()), std::acos(0.));
}

/// A triangle in the xy plane, with a cross field for a reader to write.
struct Triangle_with_field {
  using Mesh = test::Surface_mesh;

  Mesh mesh;
  Mesh::Property_map<Mesh::Face_index, test::Vector_3> field;

  Triangle_with_field()
  {
    const auto a = mesh.add_vertex(test::Point_3(0, 0, 0)), b = mesh.add_vertex(test::Point_3(1, 0, 0)),
               c = mesh.add_vertex(test::Point_3(0, 1, 0));
    mesh.add_face(a, b, c);
    field = mesh.add_property_map<Mesh::Face_index, test::Vector_3>("f:field").first;
  }

  double angle() const { return angle_of_cross(field[Mesh::Face_index(0)]); }
};

#endif // T_SPLINES_TEST_IO_TRIANGLE_WITH_FIELD_H
