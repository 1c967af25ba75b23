// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `TMeshObserver` describes what follows the changes of a T-mesh: surface points, control points, drawings.
A model is passed to `CGAL::T_splines::T_mesh_editor`, or by the named parameter `observer` to
`CGAL::T_splines::regularize_T_mesh()`, `CGAL::T_splines::refine_T_mesh()`, `CGAL::T_splines::grade_T_mesh()`,
`CGAL::T_splines::make_spline_compatible()` and
`CGAL::T_splines::insert_knot_line()`. Of these, only the last one takes care of control points.

Observers are passed by value and copied freely: one with state keeps a pointer or a reference to it. All functions
are called on `const` objects. They must not change the T-mesh.

A class derived from `CGAL::T_splines::T_mesh_observer` may define only the functions that it cares for: they are
not virtual, the algorithm calls those of the type that it was given.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::T_splines::T_mesh_observer}
\cgalHasModels{CGAL::T_splines::T_mesh_observer_pair}
\cgalHasModels{CGAL::T_splines::Carried_anchors}
\cgalHasModels{CGAL::T_splines::Carried_samples::Observer}
\cgalHasModels{CGAL::T_splines::Carried_surface::Observer}
\cgalHasModels{CGAL::T_splines::Surface_face_size::Observer}
\cgalHasModelsEnd
*/
class TMeshObserver {
public:
  /// \name Operations
  /// `Graph` is the type of the T-mesh's graph, `FT` the number type of its knots.
  /// @{

  /*!
  is called after the vertex `v` was inserted into an edge: `h` ends at `v`, and `next(h)` is the other part of the edge,
  which keeps its descriptor.
  */
  void vertex_inserted(vertex_descriptor v, halfedge_descriptor h) const;

  /*!
  is called before the vertex `v` with two edges is removed: `h` ends at `v`; it will reach to the end of `next(h)`, which
  vanishes.
  */
  void vertex_removed(vertex_descriptor v, halfedge_descriptor h) const;

  /*!
  is called after the vertex `v`, at which `h` ends, moved on the surface together with a line that was shifted.
  */
  void vertex_moved(vertex_descriptor v, halfedge_descriptor h) const;

  /*!
  is called after the edge of `h` was inserted across a face; its two parts lie on either side of it.
  */
  void edge_inserted(halfedge_descriptor h) const;

  /*!
  is called before the edge of `h` is removed, whose two faces become one: the face of `h`.
  */
  void edge_removed(halfedge_descriptor h) const;

  /*!
  is called once after each split of a face, union of two faces, or shift of a line. `pieces` lists the faces that had
  another frame or another extent before, each with the faces that cover it now. A point of the old face
  `from` belongs to the first piece with that `from` whose image lies in the rectangle of `to`: `CGAL::T_splines::move_place()` moves one.

  Everything can be read from the T-mesh as it is now, except of faces that occur as `from` and not as `to`: they
  are about to be removed.
  */
  void faces_replaced(const std::vector<CGAL::T_splines::T_mesh_piece<Graph, FT>>& pieces) const;

  /// @}
};
