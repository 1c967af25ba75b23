// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_TO_T_SPLINE_FEATURES_H
#define MESH_TO_T_SPLINE_FEATURES_H

#include "Approximation.h"
#include "Failure.h"
#include "Figures.h"
#include "Options.h"
#include "Progress.h"

/// Marks the features of a mesh, as the options say, and refines it at them.
/// \param mesh receives the property map of edges `feature_map_name`
/// \param figures receives what was found; nothing, if there are no features
Failure find_features(const Options& options, Progress& progress, Mesh& mesh,
                      std::optional<Figures::Features>& figures);

/// The features of a mesh from `find_features()`.
Mesh::Property_map<Edge, bool> features_of(Mesh& mesh);

#endif // MESH_TO_T_SPLINE_FEATURES_H
