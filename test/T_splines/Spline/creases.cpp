// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/T_splines/Spline/T_spline_surface.h>
#include <CGAL/T_splines/Spline/compile_T_spline.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>

#include "Spline/Spline_mesh.h"
#include "Spline/continuity.h"
#include "Spline/sharp_cube.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Creases of the surface.
namespace creases_test {

namespace {

using namespace spline_tests;
using Mesh = Spline_mesh<Rational>;
using Vertex = Mesh::vertex_descriptor;
using Halfedge = Mesh::halfedge_descriptor;
using Face = Mesh::face_descriptor;

bool is_crease(const Mesh& t, const Halfedge h)
{
  return get(t.creases(), edge(h, t.mesh));
}

// A part of the surroundings of a vertex between two creases, by the halfedges that end at the vertex, counter-clockwise.
struct Sector {
  Vertex v;
  std::vector<Halfedge> halfedges;
  int quarters = 0;
};

// Those of all vertices with creases. \pre the T-mesh is closed
std::vector<Sector> sectors(const Mesh& t)
{
  std::vector<Sector> result;
  for (const Halfedge first : halfedges(t.mesh)) {
    if (!is_crease(t, next(first, t.mesh)))
      continue;
    result.push_back({target(first, t.mesh), {}, 0});
    for (Halfedge h = first;; h = prev(opposite(h, t.mesh), t.mesh)) {
      result.back().halfedges.push_back(h);
      result.back().quarters += get(t.corners(), h) ? 1 : 2;
      if (is_crease(t, h))
        break;
    }
  }
  return result;
}

// What is known of the places where the surface is less than twice differentiable.
struct Exceptions {
  std::set<Face> at_corners; // that turn inwards
  std::set<Halfedge> kinked; // on a line that begins where creases end and the surface goes straight on
  std::set<Face> at_kinks;   // where no edges run along such a line
};

// A face, and those up to three faces away from it on the same side of creases.
void add_surroundings(const Mesh& t, const Face f, std::set<Face>& result)
{
  std::set<Face> last{f};
  for (int i = 0; i < 4; ++i) {
    result.insert(last.begin(), last.end());
    std::set<Face> next;
    for (const Face g : last)
      for (const Halfedge h : CGAL::halfedges_around_face(halfedge(g, t.mesh), t.mesh))
        if (!is_crease(t, h))
          next.insert(face(opposite(h, t.mesh), t.mesh));
    last = next;
  }
}

Exceptions exceptions(const Mesh& t)
{
  Exceptions result;
  const std::vector<Sector> all = sectors(t);
  std::map<Vertex, std::vector<int>> quarters;
  for (const Sector& sector : all)
    quarters[sector.v].push_back(sector.quarters);
  for (const Sector& sector : all) {
    if (sector.quarters > 2)
      for (const Halfedge h : sector.halfedges)
        result.at_corners.insert(face(h, t.mesh));
    if (sector.quarters != 2 || quarters[sector.v] == std::vector<int>{2, 2})
      continue;
    if (sector.halfedges.size() == 1) {
      add_surroundings(t, face(sector.halfedges.front(), t.mesh), result.at_kinks);
      continue;
    }
    Halfedge h = opposite(sector.halfedges.front(), t.mesh);
    for (int i = 0; i < 16; ++i) {
      result.kinked.insert(h);
      result.kinked.insert(opposite(h, t.mesh));
      const Halfedge n = next(h, t.mesh), o = opposite(n, t.mesh);
      if (!get(t.corners(), h))
        h = n;
      else if (!is_crease(t, n) && get(t.corners(), o))
        h = next(o, t.mesh);
      else {
        if (!is_crease(t, n))
          add_surroundings(t, face(o, t.mesh), result.at_kinks);
        break;
      }
    }
  }
  return result;
}

double sine(const Kernel::Vector_3& a, const Kernel::Vector_3& b)
{
  return std::sqrt(CGAL::cross_product(a, b).squared_length() / (a.squared_length() * b.squared_length()));
}

} // namespace

TEST_CASE("a cube of six faces with twelve creases is a cube, exactly", "[creases]")
{
  using Exact_mesh = Spline_mesh<Rational, Exact_kernel>;
  Exact_mesh t(test_t_meshes::cube<Rational>());
  make_sharp_cube(t);
  const Exact_mesh::Surface surface = t.surface();
  REQUIRE(surface.is_valid());
  CGAL::Random random(1);
  for (const auto f : faces(t.mesh)) {
    std::vector<Exact_kernel::Point_3> corners;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, t.mesh), t.mesh))
      corners.push_back(t.control(source(h, t.mesh)).point());
    for (int i = 0; i < 10; ++i) {
      const Rational x = Rational(random.get_int(0, 65)) / 64, y = Rational(random.get_int(0, 65)) / 64;
      const auto jet = surface.jet(f, Rational(x * surface.width(f)), Rational(y * surface.height(f)));
      CHECK(jet.position == corners[0] + x * (corners[1] - corners[0]) + y * (corners[3] - corners[0]));
      CHECK(jet.duu == CGAL::NULL_VECTOR);
      CHECK(jet.duv == CGAL::NULL_VECTOR);
    }
  }
}

TEST_CASE("creases have one curve, and the surface is smooth elsewhere", "[creases]")
{
  CGAL::Random random(1);
  for (const auto& [name, given] : closed_surfaces<Rational>())
    for (const int one_in : {1, 2, 4, 12})
      for (const int splits : {0, 12}) {
        INFO(name << ", " << splits << " splits, one edge in " << one_in);
        Mesh t(given);
        for (const auto e : edges(t.mesh))
          put(t.creases(), e, random.get_int(0, one_in) == 0);
        if (splits > 0) {
          const auto report = CGAL::T_splines::make_spline_compatible(t);
          INFO(message(report.status));
          REQUIRE(report);
          t.split_randomly(splits, random);
        }
        const auto report = CGAL::T_splines::make_spline_compatible(t);
        INFO(message(report.status));
        REQUIRE(report);
        t.set_random_controls(random);
        const Mesh::Surface surface = t.surface();
        REQUIRE(surface.is_valid());
        const auto compiled = CGAL::T_splines::compile_T_spline(surface);
        const Exceptions special = exceptions(t);
        Jet_difference smooth, at_corners, compilation;
        double gap = 0, kinked = 0, angle = 0;
        const auto is_special = [&](const Face f) { return special.at_corners.count(f) != 0; };
        std::size_t i = 0;
        const auto pieces = edge_pieces<double>(t);
        for (const Halfedge h : halfedges(t.mesh)) {
          const auto& piece = pieces[i++];
          REQUIRE(piece.face == face(h, t.mesh));
          for (const double s : {0., 1e-6, 0.01, 0.3, 0.5, 0.6, 0.99, 1.}) {
            if ((s == 0 && piece.has_cone[0]) || (s == 1 && piece.has_cone[1]))
              continue;
            const auto p = inside(surface, piece.face, piece.at(s));
            const auto q = inside(surface, piece.opposite_face, piece.transition(p.first, p.second));
            const auto a = surface.jet(piece.face, p.first, p.second);
            const auto b = pulled_back(surface.jet(piece.opposite_face, q.first, q.second), piece.transition);
            const double size = (std::min)(surface.width(piece.face), surface.height(piece.face));
            Jet_difference d = difference(a, b, size);
            if (!surface.is_at_extraordinary_vertex(piece.face))
              compilation.add(difference(a, compiled.jet(piece.face, p.first, p.second), size));
            if (is_crease(t, h))
              gap = (std::max)(gap, d.position);
            else if (special.kinked.count(h) != 0 || special.at_kinks.count(piece.face) != 0)
              kinked = (std::max)(kinked, d.position);
            else if (!is_special(piece.face) && !is_special(piece.opposite_face))
              smooth.add(d);
            else {
              angle = (std::max)(angle, sine(CGAL::cross_product(a.du, a.dv), CGAL::cross_product(b.du, b.dv)));
              d.second = d.first = 0;
              at_corners.add(d);
            }
          }
        }
        CHECK(gap < 1e-13);
        CHECK(kinked < 1e-13);
        CHECK(smooth.largest() < 1e-9);
        CHECK(at_corners.position < 1e-13);
        CHECK(angle < 1e-6);
        CHECK(compilation.position < 1e-12);
      }
}

namespace {

// Quadrilaterals; face f has the halfedges 4 f, ..., 4 f + 3. Subdivision of Catmull and Clark with infinitely sharp creases
// and corners, as DeRose, Kass and Truong (1998) have it.
class Subdivided_mesh {
public:
  using Point = std::array<double, 4>; // homogeneous
  using Place = std::array<double, 2>; // in a face of the first mesh, which is a unit square

  // \pre all faces are squares of the same size
  explicit Subdivided_mesh(const Mesh& t)
  {
    std::map<Halfedge, int> number;
    std::map<Vertex, int> vertex;
    for (const Face f : faces(t.mesh))
      for (const Halfedge h : CGAL::halfedges_around_face(halfedge(f, t.mesh), t.mesh)) {
        static const std::array<Place, 4> corners{{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}}};
        m_places.push_back(corners[number.size() % 4]);
        number.emplace(h, static_cast<int>(number.size()));
        m_faces.push_back(f);
      }
    for (const Vertex v : vertices(t.mesh)) {
      vertex.emplace(v, static_cast<int>(vertex.size()));
      const auto& c = t.control(v);
      const double w = c.weight();
      m_points.push_back({{w * c.x(), w * c.y(), w * c.z(), w}});
    }
    m_opposite.resize(number.size());
    m_origin.resize(number.size());
    m_is_crease.resize(number.size());
    for (const auto& [h, i] : number) {
      m_opposite[i] = number.at(opposite(h, t.mesh));
      m_origin[i] = vertex.at(source(h, t.mesh));
      m_is_crease[i] = is_crease(t, h);
    }
    // Creases that turn end, as those do of which more than two meet.
    m_is_corner.assign(vertex.size(), 0);
    for (const Sector& sector : sectors(t))
      m_is_corner[vertex.at(sector.v)] |= sector.quarters != 2;
    count();
    for (std::size_t v = 0; v < m_points.size(); ++v)
      m_is_corner[v] = m_number_of_creases[v] > 2 || (m_number_of_creases[v] == 2 && m_is_corner[v] != 0);
  }

  int number_of_halfedges() const { return static_cast<int>(m_origin.size()); }
  Face face(const int h) const { return m_faces[h]; }           // of the first mesh
  const Place& place(const int h) const { return m_places[h]; } // of the origin
  bool is_on_crease(const int h) const { return m_number_of_creases[m_origin[h]] > 0; }

  void subdivide()
  {
    Subdivided_mesh result;
    const int n = number_of_halfedges(), number_of_vertices = static_cast<int>(m_points.size());
    std::vector<int> edge_point(n), face_point(n / 4);
    result.m_points.resize(m_points.size());
    for (int v = 0; v < number_of_vertices; ++v)
      result.m_points[v] = new_position(v);
    for (int h = 0; h < n; ++h)
      if (h < m_opposite[h]) {
        edge_point[h] = edge_point[m_opposite[h]] = static_cast<int>(result.m_points.size());
        result.m_points.push_back(
            m_is_crease[h] != 0
                ? sum({{0.5, point(h)}, {0.5, point(next(h))}})
                : sum({{0.25, point(h)}, {0.25, point(next(h))}, {0.25, center(h)}, {0.25, center(m_opposite[h])}}));
      }
    for (int f = 0; f < n / 4; ++f) {
      face_point[f] = static_cast<int>(result.m_points.size());
      result.m_points.push_back(center(4 * f));
    }
    for (int h = 0; h < n; ++h) { // makes the face 4 h, ..., 4 h + 3, which begins where h does
      const int p = prev(h);
      const auto middle = [](const Place& a, const Place& b) { return Place{{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}}; };
      const Place &a = m_places[h], &b = m_places[next(h)], &c = m_places[next(next(h))], &d = m_places[p];
      for (const Place& place : {a, middle(a, b), middle(a, c), middle(a, d)})
        result.m_places.push_back(place);
      for (const int v : {m_origin[h], edge_point[h], face_point[h / 4], edge_point[p]})
        result.m_origin.push_back(v);
      for (const int o : {4 * next(m_opposite[h]) + 3, 4 * next(h) + 2, 4 * p + 1, 4 * m_opposite[p]})
        result.m_opposite.push_back(o);
      for (const char is_crease : {m_is_crease[h], char(0), char(0), m_is_crease[p]})
        result.m_is_crease.push_back(is_crease);
      result.m_faces.insert(result.m_faces.end(), 4, m_faces[h]);
    }
    result.m_is_corner = m_is_corner;
    result.m_is_corner.resize(result.m_points.size(), 0);
    result.count();
    *this = result;
  }

  // The limit of the origin of a halfedge. \pre no crease ends there
  Kernel::Point_3 limit(const int h) const
  {
    const int v = m_origin[h];
    const double n = m_valence[v];
    Point p = m_is_corner[v] != 0           ? m_points[v]
              : m_number_of_creases[v] == 2 ? sum({{2. / 3, m_points[v]}, {1. / 6, m_crease_neighbors[v]}})
                                            : sum({{n / (n + 5), m_points[v]},
                                                   {4 / (n * (n + 5)), m_neighbors[v]},
                                                   {1 / (n * (n + 5)), m_opposite_corners[v]}});
    return Kernel::Point_3(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
  }

private:
  Subdivided_mesh() = default;

  static int next(const int h) { return h % 4 == 3 ? h - 3 : h + 1; }
  static int prev(const int h) { return h % 4 == 0 ? h + 3 : h - 1; }
  const Point& point(const int h) const { return m_points[m_origin[h]]; }

  static Point sum(const std::vector<std::pair<double, Point>>& terms)
  {
    Point result{};
    for (const auto& [factor, p] : terms)
      for (int i = 0; i < 4; ++i)
        result[i] += factor * p[i];
    return result;
  }

  Point center(const int h) const
  {
    return sum({{0.25, point(h)}, {0.25, point(next(h))}, {0.25, point(next(next(h)))}, {0.25, point(prev(h))}});
  }

  // Sums over the halfedges that leave a vertex.
  void count()
  {
    m_valence.assign(m_points.size(), 0);
    m_number_of_creases.assign(m_points.size(), 0);
    m_neighbors.assign(m_points.size(), Point{});
    m_opposite_corners.assign(m_points.size(), Point{});
    m_crease_neighbors.assign(m_points.size(), Point{});
    for (int h = 0; h < number_of_halfedges(); ++h) {
      const int v = m_origin[h];
      ++m_valence[v];
      m_neighbors[v] = sum({{1, m_neighbors[v]}, {1, point(next(h))}});
      m_opposite_corners[v] = sum({{1, m_opposite_corners[v]}, {1, point(next(next(h)))}});
      if (m_is_crease[h] != 0) {
        ++m_number_of_creases[v];
        m_crease_neighbors[v] = sum({{1, m_crease_neighbors[v]}, {1, point(next(h))}});
      }
    }
  }

  Point new_position(const int v) const
  {
    if (m_is_corner[v] != 0)
      return m_points[v];
    if (m_number_of_creases[v] == 2)
      return sum({{0.75, m_points[v]}, {0.125, m_crease_neighbors[v]}});
    const double n = m_valence[v];
    return sum(
        {{1 - 7 / (4 * n), m_points[v]}, {3 / (2 * n * n), m_neighbors[v]}, {1 / (4 * n * n), m_opposite_corners[v]}});
  }

  std::vector<Point> m_points;
  std::vector<char> m_is_corner; // per vertex
  std::vector<int> m_origin, m_opposite;
  std::vector<char> m_is_crease;
  std::vector<Face> m_faces;
  std::vector<Place> m_places;
  std::vector<int> m_valence, m_number_of_creases;
  std::vector<Point> m_neighbors, m_opposite_corners, m_crease_neighbors; // sums
};

// Where the surface is not that of Catmull and Clark, nor that of OpenSubdiv, by design: in the faces at a corner of three
// and more quarter turns, or at the end of a single crease, where there is another tangent plane; and at a corner of two, in
// the two pairs of faces beside the line that runs inwards, as the creases end there and the surface goes straight on.
std::set<Face> other_faces(const Mesh& t)
{
  std::set<Face> result;
  const std::vector<Sector> all = sectors(t);
  std::map<Vertex, std::vector<int>> quarters;
  for (const Sector& sector : all)
    quarters[sector.v].push_back(sector.quarters);
  for (const Sector& sector : all) {
    if (sector.quarters == 1 || quarters[sector.v] == std::vector<int>{2, 2})
      continue;
    for (const Halfedge h : sector.halfedges) {
      result.insert(face(h, t.mesh));
      if (sector.quarters != 2)
        continue;
      const Halfedge across = next(next(h, t.mesh), t.mesh); // from the crease, if that is h
      result.insert(face(opposite(is_crease(t, h) ? across : next(across, t.mesh), t.mesh), t.mesh));
    }
  }
  return result;
}

void cut_into_squares(Mesh& t, const int rounds)
{
  Mesh::Editor editor(t);
  for (int i = 0; i < 2 * rounds; ++i)
    for (const Face f : std::vector<Face>(faces(t.mesh).begin(), faces(t.mesh).end())) {
      const Rational w = editor.coordinates().width(f), h = editor.coordinates().height(f);
      editor.split_face(f, w < h ? 1 : 0, Rational((std::max)(w, h) / 2));
    }
}

} // namespace

TEST_CASE("on squares, the surface is the limit of Catmull-Clark subdivision with sharp creases", "[creases]")
{
  CGAL::Random random(2);
  const std::vector<std::pair<std::string, Faces<Rational>>> surfaces{
      {"cube", test_t_meshes::cube<Rational>()},
      {"torus", test_t_meshes::torus<Rational>(3, 2)},
      {"genus two", test_t_meshes::genus_two<Rational>()}};
  int on_creases = 0, elsewhere = 0;
  for (const auto& [name, given] : surfaces)
    for (const int one_in : {1, 2, 3, 6}) {
      INFO(name << ", one edge in " << one_in);
      Mesh t(given);
      for (const auto e : edges(t.mesh))
        put(t.creases(), e, random.get_int(0, one_in) == 0);
      cut_into_squares(t, 3);
      for (const Face f : faces(t.mesh))
        REQUIRE(degree(f, t.mesh) == 4);
      t.set_random_controls(random);
      const Mesh::Surface surface = t.surface();
      INFO(describe(surface.report(), t.mesh));
      REQUIRE(surface.is_valid());
      Subdivided_mesh subdivided(t);
      for (int i = 0; i < 2; ++i)
        subdivided.subdivide();
      const std::set<Face> others = other_faces(t);
      double worst = 0;
      for (int h = 0; h < subdivided.number_of_halfedges(); ++h) {
        const Face f = subdivided.face(h);
        if (others.count(f) != 0)
          continue;
        const auto& [x, y] = subdivided.place(h);
        const auto p = surface.position(f, x * surface.width(f), y * surface.height(f));
        worst = (std::max)(worst, std::sqrt(CGAL::squared_distance(p, subdivided.limit(h))));
        ++(subdivided.is_on_crease(h) ? on_creases : elsewhere);
      }
      CHECK(worst < 1e-12);
    }
  CHECK(on_creases > 1000);
  CHECK(elsewhere > 10000);
}

} // namespace creases_test
