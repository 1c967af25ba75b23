// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef T_SPLINES_TEST_SPLINE_SPLINE_MESH_H
#define T_SPLINES_TEST_SPLINE_SPLINE_MESH_H

#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/make_spline_compatible.h>

#include "T_mesh/test_t_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/container_hash/hash.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

// T-meshes made by hand, with control points.
namespace spline_tests {

using Rational = CGAL::Exact_rational;
using Kernel = CGAL::Simple_cartesian<double>;
using Exact_kernel = CGAL::Simple_cartesian<Rational>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using test_t_meshes::Faces;

// \tparam FT_ of knots
// \tparam Kernel_ of control points and of the surface
template <typename FT_, typename Kernel_ = Kernel, typename Graph_ = Surface_mesh>
class Spline_mesh : public test_t_meshes::T_mesh<Graph_, FT_> {
  using Base = test_t_meshes::T_mesh<Graph_, FT_>;

public:
  using FT = FT_;
  using Number = typename Kernel_::FT;
  using Point_3 = typename Kernel_::Point_3;
  using Control_point = typename Kernel_::Weighted_point_3;
  using vertex_descriptor = typename Base::vertex_descriptor;
  using Controls = std::unordered_map<vertex_descriptor, Control_point, boost::hash<vertex_descriptor>>;
  using Control_map = boost::associative_property_map<Controls>;
  using Surface = CGAL::T_splines::T_spline_surface<CGAL::T_splines::Const_T_mesh_view_of<Base>, Control_map>;
  using Editor = CGAL::T_splines::T_mesh_editor<CGAL::T_splines::T_mesh_view_of<Base>>;

  explicit Spline_mesh(const Faces<FT>& faces) : Base(faces) {}

  void split_randomly(const int number, CGAL::Random& random)
  {
    Editor editor(*this);
    for (int i = 0; i < number; ++i) {
      const auto range = faces(this->mesh);
      const std::vector<typename Base::face_descriptor> list(range.begin(), range.end());
      const auto f = list[random.get_int(0, static_cast<int>(list.size()))];
      const FT w = editor.coordinates().width(f), h = editor.coordinates().height(f);
      const int axis = w > h ? 0 : 1;
      editor.split_face(f, axis, FT((axis == 0 ? w : h) * FT(random.get_int(3, 6)) / FT(8)));
    }
  }

  CGAL::T_splines::Spline_refinement_report<Graph_> make_spline_compatible()
  {
    return CGAL::T_splines::make_spline_compatible(*this, CGAL::parameters::number_of_iterations(std::size_t(2000)));
  }

  // With coordinates in [-1/2, 1/2] and weights in [1/2, 2] of few bits.
  void set_random_controls(CGAL::Random& random)
  {
    const auto coordinate = [&] { return Number(Number(random.get_int(-512, 513)) / Number(1024)); };
    for (const auto v : vertices(this->mesh)) {
      const Number x = coordinate(), y = coordinate(), z = coordinate();
      set_control(v, Point_3(x, y, z), Number(random.get_int(32, 129)) / Number(64));
    }
  }

  void set_control(const vertex_descriptor v, const Point_3& p, const Number& weight)
  {
    m_controls.insert_or_assign(v, Control_point(p, weight));
  }
  const Control_point& control(const vertex_descriptor v) const { return m_controls.at(v); }
  Control_map controls() { return Control_map(m_controls); }

  Surface surface() { return Surface(*this, controls()); }

private:
  Controls m_controls;
};

// A torus of three unit squares that form an L; its opposite sides are glued, so that two pairs of them scale by 2. Two
// cones, of three and of five quarter turns ([CZ17] Fig. 4).
template <typename FT>
Faces<FT> torus_with_two_cones()
{
  const FT one(1), half = FT(1) / FT(2);
  return {{{0, one, true}, {5, one, true}, {6, one, true}, {3, one, true}},
          {{1, one, true}, {2, one, true}, {3, half, false}, {4, half, true}, {5, one, true}},
          {{6, one, true}, {1, half, false}, {0, half, true}, {2, one, true}, {4, one, true}}};
}

// As test_t_meshes::pinwheel(), but modulo a multiplication with a quarter turn: a torus without cones where loops scale
// and rotate ([CZ17] Fig. 5).
template <typename FT>
Faces<FT> turning_pinwheel(const FT& c)
{
  Faces<FT> result = test_t_meshes::pinwheel<FT>(c);
  for (auto& face : result) {
    face[3].edge = (face[3].edge + 1) % 4;
    face[2].edge = 8 + (face[2].edge - 8 + 1) % 4;
  }
  return result;
}

// The T-mesh as it is now, in the order of its faces.
template <typename Mesh>
Faces<typename Mesh::FT> faces_of(Mesh& t)
{
  Faces<typename Mesh::FT> result;
  std::map<typename Mesh::halfedge_descriptor, int> edge;
  for (const auto h : halfedges(t.mesh))
    edge.emplace(h, edge.count(opposite(h, t.mesh)) ? edge.at(opposite(h, t.mesh)) : static_cast<int>(edge.size()));
  for (const auto f : faces(t.mesh)) {
    result.emplace_back();
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, t.mesh), t.mesh))
      result.back().push_back({edge.at(h), get(t.knots(), h), bool(get(t.corners(), h))});
  }
  return result;
}

// Cuts each face into columns and rows of equal intervals, not longer than `length` times the longest side of the face.
template <typename FT>
Faces<FT> refined(const Faces<FT>& faces_given, const FT& length)
{
  Spline_mesh<FT> t(faces_given);
  typename Spline_mesh<FT>::Editor editor(t);
  for (const auto f : t.face_list) {
    std::vector<typename Spline_mesh<FT>::face_descriptor> parts{f};
    const FT size = (std::max)(editor.coordinates().width(f), editor.coordinates().height(f)) * length;
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (const int axis : {0, 1})
        while (true) {
          const FT w = axis == 0 ? editor.coordinates().width(parts[i]) : editor.coordinates().height(parts[i]);
          if (w <= size)
            break;
          const auto edit = editor.split_face(parts[i], axis, FT(w / FT(2)));
          parts.push_back(face(opposite(edit.halfedge, t.mesh), t.mesh));
        }
  }
  return faces_of(t);
}

// The surfaces of which continuity and the like are tested, with their names. Valences from 1 to 12 occur.
template <typename FT>
std::vector<std::pair<std::string, Faces<FT>>> closed_surfaces()
{
  const FT part = FT(1) / FT(8);
  return {{"cube", test_t_meshes::cube<FT>()},
          {"torus", test_t_meshes::torus<FT>(5, 4)},
          {"torus of two faces", test_t_meshes::torus<FT>(2, 1)},
          {"genus two", test_t_meshes::genus_two<FT>()},
          {"torus with two cones", torus_with_two_cones<FT>()},
          {"pillow", test_t_meshes::pillow<FT>()},
          {"folded square", test_t_meshes::folded_square<FT>()},
          {"pinwheel", refined(test_t_meshes::pinwheel<FT>(FT(3) / FT(2)), part)},
          {"turning pinwheel", refined(turning_pinwheel<FT>(FT(3) / FT(2)), part)}};
}

// Surfaces with few faces, around which supports wind.
template <typename FT>
std::vector<std::pair<std::string, Faces<FT>>> surfaces_with_winding_supports()
{
  const FT scale = FT(3) / FT(2);
  return {{"torus of one face", test_t_meshes::torus<FT>(1, 1)},
          {"torus of three faces", test_t_meshes::torus<FT>(3, 1)},
          {"coarse pinwheel", test_t_meshes::pinwheel<FT>(scale)},
          {"coarse turning pinwheel", turning_pinwheel<FT>(scale)}};
}

} // namespace spline_tests

#endif // T_SPLINES_TEST_SPLINE_SPLINE_MESH_H
