// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `ControlPointMap` describes how the control points of a T-spline surface are stored: one per vertex of the
T-mesh, with or without a weight.

The value of a vertex is either a point, which has `x()`, `y()` and `z()`, and then its weight is 1; or a point with a
weight, which has `point()` and `weight()`. What has `weight()` is taken for a point with a weight. Coordinates are
euclidean, not multiplied by the weight. They are finite and weights are positive: `CGAL::T_splines::T_spline_surface`
refuses others, in every build, and names the vertex.

`CGAL::T_splines::T_spline_surface` copies the map, and reads it again when its `update_control_points()` is called.

\cgalRefines{ReadablePropertyMap}
\cgalRefinesBare{`WritablePropertyMap` for `CGAL::T_splines::insert_knot_line()`}

`CGAL::T_splines::insert_knot_line()` also sets the values of vertices that the graph has just added.

The key is `boost::graph_traits<TMesh>::%vertex_descriptor`. The value is of a CGAL kernel, which `CGAL::Kernel_traits` tells
(for `CGAL::T_splines::T_spline_surface` only if its kernel is not given); coordinates and weight are converted to the number
type of this kernel, by `CGAL::to_double()` if need be. For `CGAL::T_splines::insert_knot_line()` it is constructible from a
`Point_3` and a weight, or from three coordinates if it has no weight.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_mesh<Point_3>::Property_map<Vertex_index, Point_3>}
\cgalHasModels{CGAL::Surface_mesh<Point_3>::Property_map<Vertex_index, Weighted_point_3>}
\cgalHasModels{CGAL::T_splines::Control_point_map<VertexPointMap, VertexWeightMap>}
\cgalHasModelsEnd

\sa `CGAL::T_splines::make_control_point_map()`
*/
class ControlPointMap {};
