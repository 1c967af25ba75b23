// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_WORKING_T_MESH_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_WORKING_T_MESH_H

#include <CGAL/T_splines/internal/Face_graph_writer.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/converted_number.h>

#include <CGAL/Surface_mesh.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Copies the connectivity of a T-mesh, its knots and corners. The elements keep their order.
/// \pre `to` is empty
template <typename FromTMesh, typename FromKnotMap, typename FromCornerMap, typename ToTMesh, typename ToKnotMap,
          typename ToCornerMap>
void copy_t_mesh(const Mesh_indexing<FromTMesh>& from, const FromKnotMap from_knots, const FromCornerMap from_corners,
                 ToTMesh& to, const ToKnotMap to_knots, const ToCornerMap to_corners)
{
  using Knot = typename boost::property_traits<ToKnotMap>::value_type;
  const FromTMesh& t_mesh = from.graph();
  Face_graph_writer<ToTMesh> writer(to, from.number_of_vertices(), from.number_of_halfedges() / 2,
                                    from.number_of_faces());
  for (int i = 0; i < from.number_of_halfedges(); ++i) {
    const auto h = from.halfedge(i);
    const bool is_border = face(h, t_mesh) == boost::graph_traits<FromTMesh>::null_face();
    writer.join(i, from.halfedge_index(next(h, t_mesh)), from.vertex_index(target(h, t_mesh)),
                is_border ? -1 : from.face_index(face(h, t_mesh)));
    if (is_border)
      continue;
    put(to_knots, writer.halfedge(i), converted_number<Knot>(get(from_knots, h)));
    put(to_corners, writer.halfedge(i), get(from_corners, h));
  }
  for (int f = 0; f < from.number_of_faces(); ++f)
    writer.set_halfedge_of_face(f, from.halfedge_index(halfedge(from.face(f), t_mesh)));
}

/// A T-mesh that an algorithm may change, and copy; its points are control points.
template <typename Kernel>
struct Working_t_mesh {
  using FT = typename Kernel::FT;
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using Knot_map = typename Mesh::template Property_map<typename Mesh::Halfedge_index, FT>;
  using Corner_map = typename Mesh::template Property_map<typename Mesh::Halfedge_index, bool>;

  Mesh mesh;
  Knot_map knots;
  Corner_map corners;

  Working_t_mesh() { find_maps(); }
  Working_t_mesh(const Working_t_mesh& other) : mesh(other.mesh) { find_maps(); }
  Working_t_mesh& operator=(const Working_t_mesh& other)
  {
    mesh = other.mesh;
    find_maps();
    return *this;
  }

private:
  // Of this mesh, not of the one that was copied.
  void find_maps()
  {
    knots = mesh.template add_property_map<typename Mesh::Halfedge_index, FT>("h:knot").first;
    corners = mesh.template add_property_map<typename Mesh::Halfedge_index, bool>("h:is_corner", false).first;
  }
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_WORKING_T_MESH_H
