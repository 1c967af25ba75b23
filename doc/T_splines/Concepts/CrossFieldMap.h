// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `CrossFieldMap` describes how a cross field on a mesh is stored: one vector per face.

The vector v of a face stands for the cross of the four directions v, n x v, -v, -(n x v), with the unit normal n of the
face. Which of the four is stored does not matter. What the package writes has length 1 and is tangent to the face, up to
round-off. Of what it reads, length and the component along n do not matter, except where a function says otherwise
(`CGAL::T_splines::write_rawfield()` keeps the length); a vector that is zero, not finite or perpendicular to its face is
refused.

How a cross continues across an edge is not stored. It is the closest rotation, by at most pi/4, unless the caller has
matchings and passes them by the named parameter `halfedge_matching_map`; then it matters which of the four is stored.

\cgalRefinesBare{`ReadablePropertyMap` where a field is an input}
\cgalRefinesBare{`WritablePropertyMap` where a field is an output}

The key is `boost::graph_traits<TriangleMesh>::%face_descriptor`. The value has `x()`, `y()` and `z()` that
`CGAL::to_double()` takes, and is constructible from three `double`s where a field is an output.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Surface_mesh<Point_3>::Property_map<Face_index, Vector_3>}
\cgalHasModels{boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<Vector_3>>::%type}
\cgalHasModelsEnd
*/
class CrossFieldMap {};
