// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_APPROXIMATION_SURFACE_GUIDANCE_H
#define CGAL_T_SPLINES_APPROXIMATION_SURFACE_GUIDANCE_H

#include <CGAL/T_splines/Approximation/Mapped_mesh.h>
#include <CGAL/T_splines/Cross_field/Holonomy_signature.h>
#include <CGAL/T_splines/Cross_field/match_cross_field.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <optional>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesApproximation
/// What guides the map of a mesh: its features, a cross field with its matchings, and a holonomy signature.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
template <typename TriangleMesh>
class Surface_guidance {
  template <typename Tag>
  using Map = typename boost::property_map<TriangleMesh, Tag>::const_type;

public:
  /// A direction of the cross.
  using Vector_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Vector_3;
  /// Face -> a direction of its cross.
  using Cross_field = Map<CGAL::dynamic_face_property_t<Vector_3>>;
  /// Halfedge -> matching, as `holonomy_signature_of_cross_field()` takes it.
  using Matchings = Map<CGAL::dynamic_halfedge_property_t<int>>;
  /// Edge -> whether it is a feature.
  using Features = Map<CGAL::dynamic_edge_property_t<bool>>;
  /// A holonomy signature of the mesh.
  using Signature = Holonomy_signature<TriangleMesh>;

  /// There is nothing yet. \param mesh it must outlive this
  explicit Surface_guidance(const TriangleMesh& mesh)
    : m_mesh(&mesh),
      m_cross_field(get(CGAL::dynamic_face_property_t<Vector_3>(), mesh)),
      m_matchings(get(CGAL::dynamic_halfedge_property_t<int>(), mesh)),
      m_features(get(CGAL::dynamic_edge_property_t<bool>(), mesh))
  {
    for (const auto e : CGAL::make_range(edges(mesh)))
      put(m_features, e, false);
  }

  const Features& features() const { return m_features; }          ///< none, unless somebody says so
  const Cross_field& cross_field() const { return m_cross_field; } ///< it means something if `has_field()`
  const Matchings& matchings() const { return m_matchings; }       ///< of the cross field

  /// returns whether there are features.
  bool has_features() const { return m_has_features; }

  /// \param is_feature a model of `ReadablePropertyMap`, edge of the mesh -> `bool`
  template <typename EdgeIsFeatureMap>
  void set_features(const EdgeIsFeatureMap& is_feature)
  {
    m_has_features = false;
    for (const auto e : CGAL::make_range(edges(*m_mesh))) {
      put(m_features, e, get(is_feature, e));
      m_has_features = m_has_features || get(is_feature, e);
    }
  }

  /// returns whether there is a signature.
  bool has_signature() const { return m_signature.has_value(); }
  /// The signature. \pre `has_signature()`
  const Signature& signature() const { return *m_signature; }
  /// The signature, for `reduce_cones()`. \pre `has_signature()`
  Signature& signature() { return *m_signature; }

  /// returns whether the cross field has the signature.
  bool has_field() const { return m_has_field; }
  /// says that the cross field has another signature than `signature()`.
  void forget_field() { m_has_field = false; }

  /// takes a signature.
  /// \param signature of the mesh
  /// \param is_that_of_field whether the cross field has it
  void set_signature(const Signature& signature, const bool is_that_of_field)
  {
    m_signature = signature;
    m_has_field = is_that_of_field;
  }

  /// carries field, matchings and features to the refined mesh of a map.
  /// \param mapped its constrained edges are set
  /// \param cross_field face of the refined mesh -> a direction of its cross
  /// \param matchings halfedge of the refined mesh -> matching
  template <typename FT, typename MappedCrossField, typename MappedMatchings>
  void carry(const Mapped_mesh<TriangleMesh, FT>& mapped, MappedCrossField cross_field, MappedMatchings matchings) const
  {
    const auto& refined = mapped.mesh();
    for (const auto f : refined.faces())
      put(cross_field, f, get(m_cross_field, mapped.origin(f, *m_mesh)));
    for (const auto e : refined.edges())
      put(mapped.constrained_edges(), e, false);
    for (const auto h : refined.halfedges()) {
      put(matchings, h, 0);
      if (refined.is_border(h))
        continue;
      const auto origin = mapped.origin(h, *m_mesh);
      if (origin == boost::graph_traits<TriangleMesh>::null_halfedge())
        continue;
      put(matchings, h, get(m_matchings, origin));
      if (get(m_features, edge(origin, *m_mesh)))
        put(mapped.constrained_edges(), refined.edge(h), true);
    }
  }

private:
  const TriangleMesh* m_mesh;
  Cross_field m_cross_field;
  Matchings m_matchings;
  Features m_features;
  std::optional<Signature> m_signature;
  bool m_has_features = false, m_has_field = false;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_APPROXIMATION_SURFACE_GUIDANCE_H
