// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_DEVELOPMENT_H
#define T_SPLINES_TEST_DEVELOPMENT_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>

#include <CGAL/Fraction_traits.h>

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

// Surfaces glued of rectangles have a map to the plane that is unique up to a group of similarities. It stays the same
// when the T-mesh on the surface changes: by it one knows where on the surface a face lies.
namespace test_t_meshes {

// Quarter turns and translations by integers: the group of surfaces glued of unit squares.
struct Lattice_group {
  template <typename FT>
  bool contains(const CGAL::T_splines::Similarity_2<FT>& s) const
  {
    return s.scale() == FT(1) && is_integer(s.u()) && is_integer(s.v());
  }

  template <typename FT>
  bool are_equivalent(const std::pair<FT, FT>& p, std::pair<FT, FT> q) const
  {
    for (int r = 0; r < 4; ++r, q = std::make_pair(FT(-q.second), q.first)) {
      if (is_integer(FT(p.first - q.first)) && is_integer(FT(p.second - q.second)))
        return true;
    }
    return false;
  }

  template <typename FT>
  static bool is_integer(const FT& x)
  {
    using Fraction = CGAL::Fraction_traits<FT>;
    typename Fraction::Numerator_type numerator;
    typename Fraction::Denominator_type denominator;
    typename Fraction::Decompose()(x, numerator, denominator);
    return denominator == 1;
  }
};

// Quarter turns about the origin and multiplications by powers of a number: the group of the pinwheel.
template <typename FT>
struct Scaling_group {
  FT base;

  bool contains(const CGAL::T_splines::Similarity_2<FT>& s) const
  {
    return s.u() == FT(0) && s.v() == FT(0) && is_power(s.scale());
  }

  bool are_equivalent(const std::pair<FT, FT>& p, std::pair<FT, FT> q) const
  {
    for (int r = 0; r < 4; ++r, q = std::make_pair(FT(-q.second), q.first)) {
      const FT inner = p.first * q.first + p.second * q.second, outer = p.first * q.second - p.second * q.first;
      if (outer == FT(0) && inner > FT(0) && is_power(FT(inner / (q.first * q.first + q.second * q.second))))
        return true;
    }
    return false;
  }

  bool is_power(FT x) const
  {
    while (x > FT(1))
      x /= base;
    while (x < FT(1))
      x *= base;
    return x == FT(1);
  }
};

// The map of each face's frame to the plane, kept up to date by the observer.
template <typename Graph, typename FT>
class Development {
public:
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor;
  using Similarity = CGAL::T_splines::Similarity_2<FT>;
  using Piece = CGAL::T_splines::T_mesh_piece<Graph, FT>;

  class Observer : public CGAL::T_splines::T_mesh_observer {
  public:
    explicit Observer(Development& development) : m_development(&development) {}
    void faces_replaced(const std::vector<Piece>& pieces) const { m_development->replace(pieces); }

  private:
    Development* m_development;
  };

  void set(const face_descriptor f, const Similarity& s) { m_maps.insert_or_assign(f, s); }
  const Similarity& of(const face_descriptor f) const { return m_maps.at(f); }
  std::size_t size() const { return m_maps.size(); }
  Observer observer() { return Observer(*this); }
  const std::vector<face_descriptor>& touched() const { return m_touched; } // by the last change

  // Whether neighbours fit together along each edge.
  template <typename Coordinates, typename Group>
  bool is_consistent(const Coordinates& coordinates, const Group& group) const
  {
    const Graph& mesh = coordinates.t_mesh().graph();
    for (const auto h : halfedges(mesh)) {
      const face_descriptor null = boost::graph_traits<Graph>::null_face();
      const face_descriptor f = face(h, mesh), g = face(opposite(h, mesh), mesh);
      if (f != null && g != null &&
          !group.contains(compose(compose(of(g), coordinates.transition(h)), of(f).inverse())))
        return false;
    }
    return true;
  }

  // The area of all faces in the plane.
  template <typename Coordinates>
  FT area(const Coordinates& coordinates) const
  {
    FT result(0);
    for (const auto f : faces(coordinates.t_mesh().graph()))
      result += coordinates.width(f) * coordinates.height(f) * of(f).scale() * of(f).scale();
    return result;
  }

private:
  void replace(const std::vector<Piece>& pieces)
  {
    std::vector<std::pair<face_descriptor, Similarity>> images;
    for (const Piece& piece : pieces)
      images.emplace_back(piece.to, compose(of(piece.from), piece.transition.inverse()));
    for (const Piece& piece : pieces)
      m_maps.erase(piece.from);
    m_touched.clear();
    for (const auto& image : images) {
      if (m_maps.insert(image).second)
        m_touched.push_back(image.first);
    }
  }

  std::unordered_map<face_descriptor, Similarity, boost::hash<face_descriptor>> m_maps;
  std::vector<face_descriptor> m_touched;
};

// A place that knows where in the plane it is.
template <typename Graph, typename FT>
struct Developed_sample {
  CGAL::T_splines::T_mesh_place<Graph, FT> place;
  std::pair<FT, FT> position;
};

// Whether carried samples are still where they were, in the closed rectangles of faces that the T-mesh has, each in the
// list of its face. Samples: a Carried_samples of Developed_sample
template <typename Samples, typename Coordinates, typename Development, typename Group>
bool samples_stay(const Samples& carried, const Coordinates& coordinates, const Development& development,
                  const Group& group)
{
  const auto& samples = carried.samples();
  std::vector<int> count(samples.size(), 0);
  for (const auto f : faces(coordinates.t_mesh().graph()))
    for (const std::size_t i : carried.samples_in_face(f)) {
      ++count[i];
      const auto& place = samples[i].place;
      if (place.face != f || place.u < 0 || place.u > coordinates.width(f) || place.v < 0 ||
          place.v > coordinates.height(f) ||
          !group.are_equivalent(development.of(f)(place.u, place.v), samples[i].position))
        return false;
    }
  return std::all_of(count.begin(), count.end(), [](const int n) { return n == 1; });
}

} // namespace test_t_meshes

#endif // T_SPLINES_TEST_DEVELOPMENT_H
