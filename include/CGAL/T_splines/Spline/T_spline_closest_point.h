// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_T_SPLINE_CLOSEST_POINT_H
#define CGAL_T_SPLINES_SPLINE_T_SPLINE_CLOSEST_POINT_H

#include <CGAL/T_splines/Spline/Compiled_T_spline.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/Spline/internal/Bezier_patch_box.h>
#include <CGAL/T_splines/Spline/internal/Box_tree.h>
#include <CGAL/T_splines/Spline/internal/Closest_point_search.h>
#include <CGAL/T_splines/Spline/internal/Vertex_rings.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// The point of a surface that is closest to a given point.
/// \tparam Graph a model of `FaceGraph`
/// \tparam Kernel a CGAL kernel
template <typename Graph, typename Kernel>
struct Surface_projection {
  /// of the T-mesh.
  typename boost::graph_traits<Graph>::face_descriptor face = boost::graph_traits<Graph>::null_face();
  typename Kernel::FT u = 0,        ///< in [0, width] of the face
      v = 0;                        ///< in [0, height] of the face
  typename Kernel::Point_3 point;   ///< at (u, v)
  typename Kernel::FT distance = 0; ///< from the given point
};

/// \ingroup PkgTSplinesSpline
/// Finds the points of a T-spline surface that are closest to given points: globally, and up to round-off.
///
/// The exact surface is searched, also around extraordinary vertices, in Bezier patches in the order of their boxes'
/// distances: those of `compile_T_spline()`, and instead of each of its caps the infinite sequence of rings of patches
/// that shrink to the vertex, down to round-off. In a patch, bounds by Bernstein coefficients of the squared distance
/// exclude parts or prove that they have a single minimum, which is found by Newton's method.
///
/// Accuracy, for coordinates and distances of size 1 and with eps the distance from 1 to the next number: no other
/// point is closer by more than about 100 eps. The difference to the given point is normal to the surface, or on a
/// border points outwards, up to about 100 eps; the place of the closest point is as accurate as that divided by 1 -
/// distance * curvature. At a center of curvature, where that is 0, it is not determined. Limits: (1) Parts smaller
/// than 2^-12 of a patch are not divided further, nor are more than 2^14 parts of a patch looked at; of minima that are
/// not told apart by then, one is returned. Their distances differ by the fourth power of the size. (2) `u` and `v`
/// round off as numbers of the size of their face. Next to an extraordinary vertex, where a distance r in the face is
/// one of about r^p on the surface, 0.61 < p < 1.3, unless it is at (0, 0) `point` is more accurate than the surface at
/// (u, v).
///
/// Given a `Compiled_T_spline`, its patches are searched, with the caps as they are.
///
/// It copies what it needs: it does not depend on the surface any more, but on its T-mesh. It does not follow changes
/// of control points. Queries may run in any number of threads.
/// \tparam Surface_ a `T_spline_surface` or a `Compiled_T_spline`; their `FT` is `double` or `long double`
template <typename Surface_>
class T_spline_closest_point {
public:
  using Surface = Surface_;                                                     ///< the type of the surface
  using Graph = typename Surface::Graph;                                        ///< the T-mesh's graph
  using Kernel = typename Surface::Kernel;                                      ///< the kernel
  using FT = typename Kernel::FT;                                               ///< number type
  using Point_3 = typename Kernel::Point_3;                                     ///< a point in space
  using Projection = Surface_projection<Graph, Kernel>;                         ///< a closest point
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor; ///< a face of the graph

private:
  static_assert(std::is_same<FT, double>::value || std::is_same<FT, long double>::value,
                "closest points are roots of polynomials, and need floating point numbers");
  using Compiled = Compiled_T_spline<Graph, Kernel>;
  static constexpr bool is_compiled = std::is_same<Surface, Compiled>::value;
  using Search = internal::Closest_point_search<Kernel>;
  using Foot = typename Search::Foot;
  using Patch_id = typename Search::Patch_id;
  using Patch_sides = internal::Patch_sides;
  using Tree = internal::Box_tree<FT>;
  using Box = typename Tree::Box;

  // A face at an extraordinary vertex.
  struct Vertex_face {
    face_descriptor face;
    Similarity_2<FT> to_unit_square, to_face;
    internal::Vertex_rings<Kernel> rings;
  };

public:
  /// prepares the queries. \pre `surface.is_valid()`, if it is a `T_spline_surface`; it has faces
  ///
  /// Complexity: that of `compile_T_spline()`, and N log N in the number N of patches.
  explicit T_spline_closest_point(const Surface& surface) : m_compiled(compiled(surface))
  {
    CGAL_precondition_msg(m_compiled.number_of_patches() > 0, "the surface has no faces");
    std::vector<Box> boxes;
    mark_sides();
    for (std::size_t i = 0; i < m_compiled.number_of_patches(); ++i)
      if (is_compiled || !m_compiled.domain(i).is_cap) {
        m_items.push_back(i);
        boxes.push_back(internal::Bezier_patch_box<Kernel>::box(m_compiled.patch(i)));
      }
    if constexpr (!is_compiled)
      add_vertex_faces(surface, boxes);
    m_tree = Tree(boxes);
    for (const Box& box : boxes)
      for (int k = 0; k < 3; ++k)
        m_size = (std::max)({m_size, std::abs(box.low[k]), std::abs(box.high[k])});
  }

  /// returns the closest point of the surface; if there are more, one of them, and its place in one of the faces that
  /// meet there.
  ///
  /// Complexity: for points near the surface about logarithmic in the number of patches, otherwise also linear in the
  /// number of patches whose boxes are as close as the closest point; slowest where that is an extraordinary vertex, as
  /// all rings about it are looked at. \pre the coordinates of `p` are finite
  Projection operator()(const Point_3& p) const
  {
    Search search(noise(p));
    return projection(p, search);
  }

  /// returns the same; faster, if the place `hint` (`T_mesh_place`, `Surface_projection` or what has `face`, `u` and
  /// `v`) is near the closest point. \pre as above, and (u, v) is in the face
  template <typename Place>
  Projection operator()(const Point_3& p, const Place& hint) const
  {
    Search search(noise(p));
    start(p, hint.face, hint.u, hint.v, search);
    return projection(p, search);
  }

private:
  static Compiled compiled(const Surface& surface)
  {
    if constexpr (is_compiled)
      return surface;
    else
      return compile_T_spline(surface);
  }

  // At the ends of a face with a border, wherever it is, the surface may end. At a cap it may have kinks.
  void mark_sides()
  {
    m_sides.assign(m_compiled.number_of_patches(), 0);
    const Graph& graph = m_compiled.graph();
    for (std::size_t i = 0; i < m_compiled.number_of_patches(); ++i) {
      const auto domain = m_compiled.domain(i);
      if (domain.is_cap)
        m_sides[i] = 15;
      for (const auto h : CGAL::halfedges_around_face(halfedge(domain.face, graph), graph))
        if (CGAL::is_border(opposite(h, graph), graph))
          m_sides[i] |= sides_on_face_sides(domain);
    }
  }

  Patch_sides sides_on_face_sides(const typename Compiled::Domain& domain) const
  {
    return static_cast<Patch_sides>(
        (domain.u_begin <= FT(0) ? 1 : 0) | (reaches(domain.u_end, m_compiled.width(domain.face)) ? 2 : 0) |
        (domain.v_begin <= FT(0) ? 4 : 0) | (reaches(domain.v_end, m_compiled.height(domain.face)) ? 8 : 0));
  }

  // The end of a patch has been rounded; interior ones are farther from the end of the face.
  static bool reaches(const FT x, const FT size)
  {
    constexpr double round_off = 1e-12;
    return x >= size * FT(1 - round_off);
  }

  void add_vertex_faces(const Surface& surface, std::vector<Box>& boxes)
  {
    std::map<int, std::shared_ptr<const internal::Vertex_ring_rules<Kernel>>> rules; // per valence
    const auto& faces = surface.basis().cone_faces();
    for (std::size_t i = 0; i < faces.size(); ++i) {
      auto& of_valence = rules[faces[i].evaluator->valence()];
      if (of_valence == nullptr)
        of_valence = std::make_shared<const internal::Vertex_ring_rules<Kernel>>(faces[i].evaluator->valence());
      std::vector<std::array<FT, 4>> controls;
      for (const int v : faces[i].controls)
        controls.push_back(surface.homogeneous_control_points()[v]);
      const face_descriptor face = surface.indexing().face(faces[i].face);
      const auto origin = faces[i].to_unit_square.inverse()(FT(0), FT(0));
      const std::size_t cap = m_compiled.patch_at(face, clamped(origin.first, m_compiled.width(face)),
                                                  clamped(origin.second, m_compiled.height(face)));
      m_vertex_faces.push_back(
          {face, faces[i].to_unit_square, faces[i].to_unit_square.inverse(),
           internal::Vertex_rings<Kernel>(of_valence, std::move(controls), m_compiled.number_of_rings() + 1)});
      m_vertex_face_of_cap[cap] = i;
      m_items.push_back(m_compiled.number_of_patches() + i);
      boxes.push_back(m_vertex_faces.back().rings.box());
    }
  }

  FT noise(const Point_3& p) const
  {
    CGAL_precondition_msg(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()),
                          "the point is not finite");
    return FT(8) * std::numeric_limits<FT>::epsilon() *
           (std::max)({m_size, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  }

  Projection projection(const Point_3& p, Search& search) const
  {
    m_tree.for_each_closer(
        {p.x(), p.y(), p.z()}, [&] { return search.squared_radius(); },
        [&](const std::size_t i) { visit(p, m_items[i], search); });
    return projection_of(search.result());
  }

  void visit(const Point_3& p, const std::size_t item, Search& search) const
  {
    if (item < m_compiled.number_of_patches())
      search.visit({item, 0, 0}, m_compiled.patch(item), p, m_sides[item]);
    else
      visit_vertex(p, item, search);
  }

  const Vertex_face& vertex_face(const std::size_t item) const
  {
    return m_vertex_faces[item - m_compiled.number_of_patches()];
  }

  static Point_3 relative(const Point_3& p, const Point_3& origin)
  {
    return Point_3(p.x() - origin.x(), p.y() - origin.y(), p.z() - origin.z());
  }

  void visit_vertex(const Point_3& p, const std::size_t item, Search& search) const
  {
    const internal::Vertex_rings<Kernel>& rings = vertex_face(item).rings;
    const Point_3 q = relative(p, rings.vertex());
    const FT squared_distance = q.x() * q.x() + q.y() * q.y() + q.z() * q.z(), distance = std::sqrt(squared_distance);
    offer_vertex(q, item, search);
    for (int level = rings.first_level(); level < rings.last_level(); ++level) {
      const FT bound = distance - rings.radius(level);
      if ((bound > FT(0) && bound * bound >= search.squared_radius()) || rings.radius(level) <= search.noise())
        break;
      for (int part = 0; part < 3; ++part)
        search.visit({item, level, part}, rings.patch(level, part), q, 0);
    }
  }

  static void offer_vertex(const Point_3& q, const std::size_t item, Search& search)
  {
    Foot vertex;
    vertex.squared_distance = q.x() * q.x() + q.y() * q.y() + q.z() * q.z();
    vertex.point = Point_3(FT(0), FT(0), FT(0));
    vertex.patch = {item, 0, vertex_part};
    search.offer_vertex(vertex);
  }

  void start(const Point_3& p, const face_descriptor face, const FT& u, const FT& v, Search& search) const
  {
    CGAL_precondition_msg(u >= FT(0) && u <= m_compiled.width(face), "the hint's u is outside of its face");
    CGAL_precondition_msg(v >= FT(0) && v <= m_compiled.height(face), "the hint's v is outside of its face");
    const std::size_t i = m_compiled.patch_at(face, u, v);
    const auto domain = m_compiled.domain(i);
    if (is_compiled || !domain.is_cap) {
      search.descend({i, 0, 0}, m_compiled.patch(i), p, m_sides[i],
                     clamped((u - domain.u_begin) / (domain.u_end - domain.u_begin), FT(1)),
                     clamped((v - domain.v_begin) / (domain.v_end - domain.v_begin), FT(1)));
      return;
    }
    const std::size_t item = m_compiled.number_of_patches() + m_vertex_face_of_cap.at(i);
    const Vertex_face& vertex = vertex_face(item);
    const Point_3 q = relative(p, vertex.rings.vertex());
    offer_vertex(q, item, search);
    const auto place = vertex.to_unit_square(u, v);
    const FT x = clamped(place.first, FT(1)), y = clamped(place.second, FT(1));
    int exponent;
    std::frexp((std::max)(x, y), &exponent);
    const int level = 1 - exponent;
    if (x == y && x == FT(0))
      return;
    if (level >= vertex.rings.first_level() && level < vertex.rings.last_level()) {
      const FT s = std::ldexp(x, level), t = std::ldexp(y, level);
      const int part = t < FT(1) ? 0 : s < FT(1) ? 2 : 1;
      search.descend({item, level, part}, vertex.rings.patch(level, part), q, 0, part == 2 ? s : s - FT(1),
                     part == 0 ? t : t - FT(1));
    }
  }

  static FT clamped(const FT x, const FT end) { return std::clamp(x, FT(0), end); }

  Projection projection_of(const Foot& foot) const
  {
    Projection result;
    result.distance = std::sqrt(foot.squared_distance);
    const std::size_t item = foot.patch.item;
    if (item < m_compiled.number_of_patches()) {
      const auto domain = m_compiled.domain(item);
      result.face = domain.face;
      result.u = between(domain.u_begin, domain.u_end, foot.s, m_compiled.width(domain.face));
      result.v = between(domain.v_begin, domain.v_end, foot.t, m_compiled.height(domain.face));
      result.point = foot.point;
      return result;
    }
    const Vertex_face& vertex = vertex_face(item);
    std::pair<FT, FT> place{FT(0), FT(0)};
    if (foot.patch.part != vertex_part) {
      place.first = std::ldexp(foot.s + FT(foot.patch.part == 2 ? 0 : 1), -foot.patch.level);
      place.second = std::ldexp(foot.t + FT(foot.patch.part == 0 ? 0 : 1), -foot.patch.level);
    }
    place = vertex.to_face(place.first, place.second);
    result.face = vertex.face;
    const FT width = m_compiled.width(vertex.face), height = m_compiled.height(vertex.face);
    result.u = clamped(place.first, width);
    result.v = clamped(place.second, height);
    if (foot.patch.part == vertex_part) {
      result.u = result.u > width / FT(2) ? width : FT(0);
      result.v = result.v > height / FT(2) ? height : FT(0);
    }
    const Point_3& o = vertex.rings.vertex();
    result.point = Point_3(o.x() + foot.point.x(), o.y() + foot.point.y(), o.z() + foot.point.z());
    return result;
  }

  static FT between(const FT begin, const FT end, const FT s, const FT size)
  {
    if (s == FT(1))
      return reaches(end, size) ? size : end;
    return clamped(begin + s * (end - begin), size);
  }

  static constexpr int vertex_part = 3; // the extraordinary vertex itself

  Compiled m_compiled;
  std::vector<Patch_sides> m_sides; // per patch
  std::vector<Vertex_face> m_vertex_faces;
  std::map<std::size_t, std::size_t> m_vertex_face_of_cap;
  std::vector<std::size_t> m_items; // patches, and vertex faces, whose numbers come after those of all patches
  Tree m_tree;                      // of the boxes of the items
  FT m_size = FT(0);
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_T_SPLINE_CLOSEST_POINT_H
