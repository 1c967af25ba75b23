// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgTSplinesConcepts
\cgalConcept

The concept `FlipPolicy` marks the types that may be passed by the named parameter `flip_policy` of
`CGAL::T_splines::compute_similarity_metric()` and `CGAL::T_splines::compute_seamless_similarity_map()`. A policy says how the
intrinsic triangulation follows the metric while the metric moves.

The concept is closed: its models are tags, chosen at compile time, and the algorithms know each of them. A class of
one's own is not a model.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::T_splines::Ideal_delaunay_flips}
\cgalHasModels{CGAL::T_splines::Degeneracy_flips}
\cgalHasModelsEnd
*/
class FlipPolicy {};
