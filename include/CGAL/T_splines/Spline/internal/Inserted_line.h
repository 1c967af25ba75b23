// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_INSERTED_LINE_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_INSERTED_LINE_H

#include <CGAL/T_splines/Spline/Knot_insertion_report.h>
#include <CGAL/T_splines/T_mesh/support/Basis_knots.h>
#include <CGAL/T_splines/T_mesh/support/Regular_rings.h>
#include <CGAL/T_splines/T_mesh/support/Spline_structure.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/T_mesh/support/Vertex_quarters.h>

#include <algorithm>
#include <array>
#include <deque>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The control points that a new line changes in a row: of the vertices v_0, v_1, v_2, v_3, one after the other, and
/// the new vertex between v_c and v_{c+1}, c the number of the column, three in the middle become (1 - shares[j]) P(v_j)
/// + shares[j] P(v_{j+1}), j = 0, 1, 2. If the row ends naturally at v_1 or v_2, there is no v_0 or v_3, and the control
/// point at the end stays.
template <typename FT>
struct Knot_row {
  std::array<int, 4> vertices; ///< of the T-mesh; -1 beyond a natural end
  std::array<FT, 3> shares;
  int column;
  int edge;         ///< the halfedge of a face, in the T-mesh, that the line crosses
  bool is_reversed; ///< from v_{c+1} to v_c
};

/// A straight line across faces of a T-mesh that is to become a line of knots, from side to side of each face, and the
/// columns of faces that matter to it.
///
/// Directions are named as if the line ran upwards. A band is what lies between two successive rows, the edges that the
/// line crosses: a halfedge per column, the bottom of the face there, from left to right. The line's own column is in
/// the middle; there is one to each side of it, as far as no border or crease is between them, and a second one if on the
/// other side of the own column the surface ends "not a knot".
///
/// The T-mesh is cut along its creases, and a line that crosses them has several parts. What is said of a row is said in
/// its part; a row along a crease belongs to two.
/// \tparam FT the number type of the knots
template <typename FT>
class Inserted_line {
  using Structure = Spline_structure<FT>;
  using Arrays = T_mesh_arrays<FT>;
  using Status = Knot_insertion_status;
  static constexpr int own = 2; // the number of the line's column
  using Band = std::array<int, 5>;

public:
  static constexpr int none = -1;

  /// \pre the T-mesh is spline compatible
  explicit Inserted_line(const Structure& structure)
    : m_structure(structure),
      m_t_mesh(structure.knot_arrays()),
      m_is_used(m_t_mesh.number_of_faces()),
      m_rings(m_t_mesh.number_of_faces()),
      m_after_cut(structure.uncut_arrays().number_of_halfedges(), none)
  {
    find_rings();
    for (int h = 0; h < m_t_mesh.number_of_halfedges(); ++h)
      if (!m_t_mesh.is_border(h))
        m_after_cut[m_t_mesh.original_halfedge(h)] = h;
  }

  /// Follows the line that crosses the bottom of a face, from the left at the part `x` of it, 0 < x < 1, in both
  /// directions. \return INSERTED if its knot can be inserted
  Status find(const int bottom, const FT& x)
  {
    m_x = x;
    if (follow(bottom))
      add_rows();
    return m_status;
  }

  int vertex() const { return m_vertex; } ///< of the T-mesh, for AT_EXTRAORDINARY_VERTEX and NEAR_CREASE
  int face() const { return m_face; }     ///< for NOT_CONFORMING and LINE_MEETS_ITSELF

  /// In no particular order.
  const std::vector<Knot_row<FT>>& rows() const { return m_rows; }

  /// The bottoms of the faces that the line crosses, in no particular order.
  std::vector<int> bottoms() const
  {
    std::vector<int> result;
    for (const Band& band : m_bands)
      result.push_back(band[own]);
    return result;
  }

private:
  // The ring around the vertex that has the face, 1 to 3; if there are several, the closest one.
  struct Ring {
    int number = 4, vertex = none;
  };

  // Along the third ring around a corner of the border, the vertices on the inner side have natural ends beside the border
  // and those on the outer side have none: rows must not have both, so that this ring counts as the second one.
  void find_rings()
  {
    for (const Regular_rings<FT>& rings : m_structure.rings())
      for (int sector = 0; sector < rings.valence(); ++sector)
        for (int x = 0; x < 3; ++x)
          for (int y = 0; y < (x < 2 ? 3 : 2); ++y) {
            Ring& ring = m_rings[rings.face(sector, x, y)];
            const int number = (std::min)((std::max)(x, y) + 1, rings.is_on_border() ? 2 : 3);
            if (number < ring.number)
              ring = {number, rings.vertex(sector, 0, 0)};
          }
  }

  bool follow(const int bottom)
  {
    int b = bottom;
    do {
      if (!add_band(b))
        return false;
      m_bands.push_back(m_band);
      b = behind(other_side(b));
    } while (b != bottom && b != none);
    if (b == bottom)
      return true;
    for (int top = behind(bottom); top != none; top = behind(b)) {
      b = other_side(top);
      if (!add_band(b))
        return false;
      m_bands.push_front(m_band);
    }
    return true;
  }

  // The halfedge on the other side of an edge, or of a crease.
  int behind(const int h) const
  {
    const int o = Arrays::opposite(h);
    if (!m_t_mesh.is_border(o))
      return o;
    const int result = Arrays::opposite(m_t_mesh.original_halfedge(h));
    return m_structure.uncut_arrays().is_border(result) ? none : m_after_cut[result];
  }

  // The first halfedge of the side opposite to that of h.
  int other_side(const int h) const { return m_t_mesh.first_of_side(m_t_mesh.face(h), (m_t_mesh.side(h) + 2) % 4); }
  int above(const int bottom) const { return Arrays::opposite(other_side(bottom)); }

  // Makes the band in which the line crosses the bottom b. As all faces of the columns are quads and all their vertices
  // regular, those of successive bands meet edge to edge.
  bool add_band(const int b)
  {
    if (!add_face(m_t_mesh.face(b), 3))
      return false;
    m_band.fill(none);
    m_band[own] = b;
    const auto has_not_a_knot = [&](const int side) {
      return end_of_row(b, side) == End::NOT_A_KNOT || end_of_row(above(b), side) == End::NOT_A_KNOT;
    };
    const int number_left = has_not_a_knot(0) ? 2 : 1, number_right = has_not_a_knot(1) ? 2 : 1;
    for (int c = own; c > own - number_left; --c) {
      const int right = Arrays::opposite(m_t_mesh.prev(m_band[c]));
      if (m_t_mesh.is_border(right))
        break;
      if (!add_face(m_t_mesh.face(right), 2))
        return false;
      m_band[c - 1] = m_t_mesh.prev(right);
    }
    for (int c = own; c < own + number_right; ++c) {
      const int left = Arrays::opposite(m_t_mesh.next(m_band[c]));
      if (m_t_mesh.is_border(left))
        break;
      if (!add_face(m_t_mesh.face(left), 2))
        return false;
      m_band[c + 1] = m_t_mesh.next(left);
    }
    return true;
  }

  // The face must not lie in the rings with the numbers up to `ring`.
  bool add_face(const int f, const int ring)
  {
    m_face = f;
    m_vertex = m_rings[f].vertex == none ? none : m_structure.vertex_in_graph(m_rings[f].vertex);
    if (m_rings[f].number <= ring)
      m_status = Status::AT_EXTRAORDINARY_VERTEX;
    else if (!is_quad(f))
      m_status = Status::NOT_CONFORMING;
    else if (m_is_used[f])
      m_status = Status::LINE_MEETS_ITSELF;
    m_is_used[f] = true;
    return m_status == Status::INSERTED;
  }

  bool is_quad(const int f) const
  {
    for (int side = 0; side < 4; ++side)
      if (!m_t_mesh.is_corner(m_t_mesh.first_of_side(f, side)))
        return false;
    return true;
  }

  // Those of all parts between creases.
  void add_rows()
  {
    const auto begins_part = [&](const Band& band) { return m_t_mesh.is_border(Arrays::opposite(band[own])); };
    const auto first = std::find_if(m_bands.begin(), m_bands.end(), begins_part);
    const bool is_closed = first == m_bands.end();
    std::rotate(m_bands.begin(), first, m_bands.end()); // the parts of a closed line begin at a crease
    for (auto begin = m_bands.begin(); begin != m_bands.end();) {
      const auto end = is_closed ? m_bands.end() : std::find_if(begin + 1, m_bands.end(), begins_part);
      const int number = static_cast<int>(end - begin), top = above((*(end - 1))[own]);
      const bool is_natural_below = m_t_mesh.is_crease((*begin)[own]), is_natural_above = m_t_mesh.is_crease(top);
      for (int i = 0; i < number; ++i)
        add_row(begin[i], {is_closed ? far_away : i, is_natural_below},
                {is_closed ? far_away : number - i, is_natural_above});
      if (!is_closed) {
        Band row = *(end - 1);
        for (int& h : row)
          h = h == none ? none : above(h);
        add_row(row, {number, is_natural_below}, {0, is_natural_above});
        if (is_natural_above) // it is the first row of the next part, too
          m_rows.pop_back();
      }
      begin = end;
    }
  }

  // How a part of the line ends: so many rows away from one of them.
  struct End_of_part {
    int distance;
    bool is_natural;

    // Whether the knots of a vertex depend on it.
    bool is_seen() const { return distance <= (is_natural ? 1 : 3); }
  };

  // Boehm's knot insertion. With the knots k_0, ..., k_7 of the four vertices, of which number j has k_j, ..., k_{j+4},
  // and the new knot y between k_3 and k_4, shares[j - 1] is (y - k_j) / (k_{j+3} - k_j), j = 1, 2, 3.
  void add_row(const Band& row, const End_of_part& below, const End_of_part& above)
  {
    const End left = end_of_row(row[own], 1), right = end_of_row(row[own], 0);
    const int column = left == End::NOT_A_KNOT ? 0 : right == End::NOT_A_KNOT ? 2 : 1;
    const bool is_inside = !m_t_mesh.is_border(row[own]);
    Knot_row<FT> result;
    result.column = column;
    result.edge = m_t_mesh.original_halfedge(is_inside ? row[own] : Arrays::opposite(row[own]));
    result.is_reversed = !is_inside;
    std::array<Row_vertex, 4> vertices;
    for (int j = 0; j < 4; ++j) {
      vertices[j] = vertex_of_row(row, own - column + j);
      if ((j == 0 && column == 1 && left != End::NONE) || (j == 3 && column == 1 && right != End::NONE))
        result.vertices[j] = none;
      else {
        result.vertices[j] = m_structure.vertex_in_graph(vertices[j].v);
        check_line_at(vertices[j], below, above);
      }
    }
    const Axis first = axis_at(vertices[1], left, End::NONE), second = axis_at(vertices[2], End::NONE, right);
    const FT y = column == 0 ? FT(0) : column == 1 ? FT(m_x * first.after) : first.after;
    const FT z = column == 0 ? FT(-second.before) : column == 1 ? FT(FT(m_x - FT(1)) * second.before) : FT(0);
    const auto share = [](const FT& x, const FT& from, const FT& to) { return FT(FT(x - from) / FT(to - from)); };
    const std::array<FT, 5>&k = first.knots, &l = second.knots;
    result.shares = {result.vertices[0] == none ? FT(1) : share(y, k[0], k[3]), share(y, k[1], k[4]),
                     result.vertices[3] == none ? FT(0) : share(z, l[1], l[4])};
    m_rows.push_back(result);
  }

  // A vertex, and the number of its ray that goes to the right.
  struct Row_vertex {
    int v = none, direction = none;
  };

  // Vertex i is where edge i of the row begins and edge i - 1 ends. Of the two, the one closer to the line is there.
  Row_vertex vertex_of_row(const Band& row, const int i) const
  {
    if (i <= own)
      return row[i] == none ? Row_vertex() : source_in_row(row[i]);
    return row[i - 1] == none ? Row_vertex() : target_in_row(row[i - 1]);
  }

  Row_vertex source_in_row(const int e) const { return {m_t_mesh.source(e), number_of_direction(e)}; }
  Row_vertex target_in_row(const int e) const
  {
    return {m_t_mesh.target(e), (number_of_direction(Arrays::opposite(e)) + 2) % 4};
  }

  // The number of the ray along a halfedge that begins at a vertex. One at the border is the last one.
  int number_of_direction(const int out) const
  {
    const Vertex_quarters<FT> quarters(m_t_mesh, m_t_mesh.source(out));
    if (m_t_mesh.is_border(out))
      return quarters.size();
    int result = 0;
    while (m_t_mesh.next(quarters[result].h) != out)
      ++result;
    return result;
  }

  // Whether a row ends at a vertex of it, and how.
  enum class End { NONE, NATURAL, NOT_A_KNOT };

  // At the left end of the edge e if `side` is 1, at its right end if it is 0.
  End end_of_row(const int e, const int side) const
  {
    const Row_vertex vertex = side == 1 ? source_in_row(e) : target_in_row(e);
    const Knot_ray<FT> ray = m_structure.rays(vertex.v)[(vertex.direction + 2 * side) % 4];
    if (ray.border != 0 && !ray.begins_line)
      return End::NONE;
    return (ray.border == 0 ? ray.is_natural : ray.begins_naturally) ? End::NATURAL : End::NOT_A_KNOT;
  }

  // All vertices of a row must see what the line meets above and below it: only then their knots along the line are the
  // same. They do not where a line along a crease or the border ends and the surface goes straight on.
  void check_line_at(const Row_vertex& vertex, const End_of_part& below, const End_of_part& above)
  {
    const Vertex_rays<FT> rays = m_structure.rays(vertex.v);
    const auto sees = [](const Knot_ray<FT>& ray, const End_of_part& end) {
      const End_of_part found{ray.border, ray.is_natural};
      if (ray.begins_line || found.is_seen() != end.is_seen())
        return false;
      return !end.is_seen() || (found.distance == end.distance && found.is_natural == end.is_natural);
    };
    if (m_status == Status::INSERTED &&
        !(sees(rays[(vertex.direction + 1) % 4], above) && sees(rays[(vertex.direction + 3) % 4], below))) {
      m_status = Status::NEAR_CREASE;
      m_vertex = m_structure.vertex_in_graph(vertex.v);
    }
  }

  // The knots of a vertex along a row, relative to it, and how far away its neighbours are, all in one unit.
  struct Axis {
    std::array<FT, 5> knots;
    FT before, after;
  };

  // Where the row ends naturally at the vertex and another one begins, of the row alone.
  Axis axis_at(const Row_vertex& vertex, const End left, const End right) const
  {
    const Vertex_rays<FT> rays = m_structure.rays(vertex.v);
    const Knot_ray<FT>&after = rays[vertex.direction % 4], &before = rays[(vertex.direction + 2) % 4];
    const Axis_knots<FT> knots = axis_knots(after, before);
    const std::array<FT, 5> t = knots.is_peak && left == End::NATURAL    ? knots.right_half().t
                                : knots.is_peak && right == End::NATURAL ? knots.left_half().t
                                                                         : knots.t;
    return {t, before.distance[0], after.distance[0]};
  }

  static constexpr int far_away = Knot_ray<FT>::no_border;

  const Structure& m_structure;
  const Arrays& m_t_mesh;
  std::vector<char> m_is_used;  // per face: in the columns
  std::vector<Ring> m_rings;    // per face
  std::vector<int> m_after_cut; // per halfedge of a face in the T-mesh: what it is in the cut one
  FT m_x = FT(0);
  Status m_status = Status::INSERTED;
  int m_vertex = none, m_face = none;
  Band m_band{};
  std::deque<Band> m_bands; // upwards
  std::vector<Knot_row<FT>> m_rows;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_INSERTED_LINE_H
