// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `TMesh` describes a T-mesh with halfedge knots ([CZ17] section 4): a graph, the knot interval of each halfedge
in the units of its face, and where the faces have their corners.

A model may also know which of its edges are *creases*, along which the surface is sharp: with the type `Crease_map`, a
property map, edge -> `bool`, and the member `creases()`, which returns one. Without, no edge is a crease, nor is one on the border.
Operations that change the T-mesh neither remove a crease nor move it to its side; its parts are creases, too, and new edges are not.

The functions that change a T-mesh take it by a forwarding reference, so that a view may be made where it is needed. What
a `const` model refers to may change all the same, as with property maps of CGAL.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModelsBare{`CGAL::T_splines::T_mesh<Point_3, FT>`: a value, with a graph of its own}
\cgalHasModelsBare{`CGAL::T_splines::T_spline<Kernel>`: the same with weights}
\cgalHasModelsBare{`CGAL::T_splines::T_mesh_view<Graph, KnotMap, CornerMap, CreaseMap>`: refers to a graph and maps that lie elsewhere}
\cgalHasModelsEnd
*/
class TMesh {
public:
  /// \name Types
  /// @{

  /*!
  a model of `HalfedgeGraph` and `FaceGraph`; functions name what else they ask for, `MutableFaceGraph` those that change
  the T-mesh. It may be non-simple: two edges may join the same two vertices, and a face may meet itself.
  */
  typedef unspecified_type Graph;

  /*!
  a readable property map, halfedge -> `FT`: the knot interval of the halfedge in the units of its face, positive. It is
  not read at border halfedges. Functions that change the T-mesh write it, also at halfedges that the graph has just
  added.
  */
  typedef unspecified_type Knot_map;

  /*!
  a readable property map, halfedge -> `bool`: whether the face of the halfedge turns, by a right angle, at its target.
  Otherwise as `Knot_map`.
  */
  typedef unspecified_type Corner_map;

  /*!
  the number type of the knots, a model of `Field` and `RealEmbeddable`.
  */
  typedef unspecified_type FT;

  /*!
  a vertex of `Graph`.
  */
  typedef unspecified_type vertex_descriptor;

  /*!
  a halfedge of `Graph`.
  */
  typedef unspecified_type halfedge_descriptor;

  /*!
  a face of `Graph`.
  */
  typedef unspecified_type face_descriptor;

  /// @}

  /// \name Operations
  /// @{

  /*!
  returns the graph; `const Graph&` where the T-mesh is not to be changed.
  */
  Graph& graph();

  /*!
  returns the map of the knot intervals.
  */
  Knot_map knots() const;

  /*!
  returns the map of the corners.
  */
  Corner_map corners() const;

  /// @}
};
