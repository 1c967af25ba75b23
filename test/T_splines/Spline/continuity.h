// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SPLINE_CONTINUITY_H
#define T_SPLINES_TEST_SPLINE_CONTINUITY_H

#include <CGAL/T_splines/Similarity_2.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/internal/converted_number.h>

#include <CGAL/Random.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// How a surface on a T-mesh continues from face to face, judged by the transitions between their frames alone.
namespace spline_tests {

// What one face sees of an edge.
template <typename Graph, typename FT>
struct Edge_piece {
  typename boost::graph_traits<Graph>::face_descriptor face, opposite_face;
  std::pair<FT, FT> begin, end;                 // of the edge, in the frame of `face`
  CGAL::T_splines::Similarity_2<FT> transition; // to the frame of `opposite_face`
  std::array<bool, 2> has_cone;                 // at its begin, at its end
  bool is_whole_side;                           // of both faces

  std::pair<FT, FT> at(const FT& t) const
  {
    return {FT(begin.first + t * (end.first - begin.first)), FT(begin.second + t * (end.second - begin.second))};
  }
};

template <typename FT, typename From>
std::pair<FT, FT> converted(const std::pair<From, From>& p)
{
  using CGAL::T_splines::internal::converted_number;
  return {converted_number<FT>(p.first), converted_number<FT>(p.second)};
}

template <typename FT, typename From>
CGAL::T_splines::Similarity_2<FT> converted(const CGAL::T_splines::Similarity_2<From>& s)
{
  using CGAL::T_splines::internal::converted_number;
  return CGAL::T_splines::Similarity_2<FT>(s.quarter_turns(), converted_number<FT>(s.scale()),
                                           converted_number<FT>(s.u()), converted_number<FT>(s.v()));
}

// All pairs of an inner edge and one of its faces.
template <typename FT, typename TMesh>
std::vector<Edge_piece<typename TMesh::Graph, FT>> edge_pieces(const TMesh& t_mesh)
{
  const CGAL::T_splines::T_mesh_coordinates coordinates(t_mesh);
  const auto& graph = t_mesh.graph();
  const auto null_face = boost::graph_traits<typename TMesh::Graph>::null_face();
  std::vector<Edge_piece<typename TMesh::Graph, FT>> result;
  for (const auto h : halfedges(graph)) {
    const auto o = opposite(h, graph);
    if (face(h, graph) == null_face || face(o, graph) == null_face)
      continue;
    const auto is_cone = [&](const auto v) {
      return !CGAL::T_splines::is_border_vertex(v, t_mesh) && CGAL::T_splines::is_extraordinary(v, t_mesh);
    };
    const auto is_whole = [&](const auto e) {
      return get(t_mesh.corners(), e) && get(t_mesh.corners(), prev(e, graph));
    };
    result.push_back({face(h, graph), face(o, graph), converted<FT>(coordinates.source_point(h)),
                      converted<FT>(coordinates.target_point(h)), converted<FT>(coordinates.transition(h)),
                      std::array<bool, 2>{is_cone(source(h, graph)), is_cone(target(h, graph))},
                      is_whole(h) && is_whole(o)});
  }
  return result;
}

// The jet with respect to the source of a similarity, of that with respect to its target.
template <typename Jet, typename FT>
Jet pulled_back(const Jet& jet, const CGAL::T_splines::Similarity_2<FT>& similarity)
{
  const FT s = similarity.scale(), ss = s * s;
  Jet result = jet;
  for (int k = 0; k < similarity.quarter_turns(); ++k) { // u of the source becomes v of the target
    const Jet turned = result;
    result.du = turned.dv;
    result.dv = -turned.du;
    result.duu = turned.dvv;
    result.duv = -turned.duv;
    result.dvv = turned.duu;
  }
  result.du = s * result.du;
  result.dv = s * result.dv;
  result.duu = ss * result.duu;
  result.duv = ss * result.duv;
  result.dvv = ss * result.dvv;
  return result;
}

template <typename Vector_3>
double length(const Vector_3& v)
{
  return std::sqrt(CGAL::to_double(v.squared_length()));
}

// Differences of jets, relative to their own size and to that of a surface of diameter 1 over a face.
struct Jet_difference {
  double position = 0, first = 0, second = 0;

  double largest() const
  {
    return position >= 0 && first >= 0 && second >= 0 ? (std::max)({position, first, second}) : NAN;
  }
  void add(const Jet_difference& d)
  {
    position = larger(position, d.position);
    first = larger(first, d.first);
    second = larger(second, d.second);
  }

private:
  // What is not a number stays.
  static double larger(const double a, const double b) { return a >= b || std::isnan(a) ? a : b; }
};

// \param size of the face, of which the parameters are
template <typename Jet>
Jet_difference difference(const Jet& a, const Jet& b, const double size)
{
  Jet_difference result;
  result.position = length(a.position - b.position);
  const double first = (std::max)({length(a.du), length(a.dv), 1 / size});
  result.first = (std::max)(length(a.du - b.du), length(a.dv - b.dv)) / first;
  const double second = (std::max)({length(a.duu), length(a.duv), length(a.dvv), 1 / (size * size)});
  result.second = (std::max)({length(a.duu - b.duu), length(a.duv - b.duv), length(a.dvv - b.dvv)}) / second;
  return result;
}

// u and v, without what round-off may have added.
template <typename Surface, typename Face, typename FT>
std::pair<FT, FT> inside(const Surface& surface, const Face f, const std::pair<FT, FT>& p)
{
  return {(std::max)(FT(0), (std::min)(p.first, surface.width(f))),
          (std::max)(FT(0), (std::min)(p.second, surface.height(f)))};
}

struct Continuity : Jet_difference {
  std::size_t samples = 0, at_t_joints = 0, at_cones = 0, scaled = 0, turned = 0;
};

// Compares the jets from both sides at random points of random edges, ends included; not at extraordinary vertices.
template <typename Surface, typename Pieces>
Continuity continuity(const Surface& surface, const Pieces& pieces, const int number, CGAL::Random& random)
{
  using FT = typename Surface::FT;
  Continuity result;
  for (int i = 0; i < number; ++i) {
    const auto& piece = pieces[random.get_int(0, static_cast<int>(pieces.size()))];
    const int kind = random.get_int(0, 16), bits = random.get_int(4, 15);
    FT t = FT(random.get_int(1, 1 << 20)) / FT(1 << 20);
    if (kind < 4 || ((kind == 4 || kind == 5) && piece.has_cone[kind - 4])) // near the ends
      t = kind % 2 == 0 ? FT(FT(1) / FT(1 << bits)) : FT(FT(1) - FT(1) / FT(1 << bits));
    else if (kind == 4 || kind == 5)
      t = FT(kind - 4);
    const std::pair<FT, FT> p = inside(surface, piece.face, piece.at(t));
    const std::pair<FT, FT> q = inside(surface, piece.opposite_face, piece.transition(p.first, p.second));
    const auto a = surface.jet(piece.face, p.first, p.second);
    const auto b = pulled_back(surface.jet(piece.opposite_face, q.first, q.second), piece.transition);
    result.add(difference(a, b, CGAL::to_double((std::min)(surface.width(piece.face), surface.height(piece.face)))));
    ++result.samples;
    result.at_t_joints += !piece.is_whole_side;
    result.at_cones += surface.is_at_extraordinary_vertex(piece.face);
    result.scaled += piece.transition.scale() != FT(1);
    result.turned += piece.transition.quarter_turns() != 0;
  }
  return result;
}

} // namespace spline_tests

#endif // T_SPLINES_TEST_SPLINE_CONTINUITY_H
