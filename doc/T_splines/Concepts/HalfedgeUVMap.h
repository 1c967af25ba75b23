// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `HalfedgeUVMap` describes how a map to the plane is stored that is not continuous: one point per corner of
a face.

The value of the halfedge h is the image of the *target* of h in the chart of the *face* of h. So the triangle of the face
f has the corners uv(h), uv(next(h)), uv(next(next(h))) with h = halfedge(f), counter-clockwise. The two ends of an edge with the
halfedges h and g = opposite(h) have, in the chart of the face of h, the images uv(h) (target of h) and uv(prev(h)) (its
source), and in the chart of the face of g the images uv(prev(g)) (target of h) and uv(g) (its source). Off the cut the
charts agree: uv(h) = uv(prev(g)). On the cut, the transition t of h, the value of `halfedge_transition_map`, takes the
one to the other: t(uv(h)) = uv(prev(g)), up to round-off.

Values of border halfedges are not used.

\cgalRefinesBare{`ReadablePropertyMap` where a map is an input}
\cgalRefinesBare{`WritablePropertyMap` where a map is an output}

The key is `boost::graph_traits<Mesh>::%halfedge_descriptor`. The value is constructible from two `double`s where a map is
an output, and has `x()` and `y()` where it is an input.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_mesh<Point_3>::Property_map<Halfedge_index, Point_2>}
\cgalHasModels{boost::property_map<Mesh, CGAL::dynamic_halfedge_property_t<Point_2>>::%type}
\cgalHasModelsEnd
*/
class HalfedgeUVMap {};
