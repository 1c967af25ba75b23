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

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The control points that a new line changes in a row: of the vertices v_0, v_1, v_2, v_3, one after the other, and
/// the new vertex between two of them, three in the middle become (1 - shares[j]) P(v_j) + shares[j] P(v_{j+1}), j = 0,
/// 1, 2.
template <typename FT>
struct Knot_row {
  std::array<int, 4> vertices;
  std::array<FT, 3> shares;
  int edge; ///< the halfedge from v_c to v_{c+1} that the line crosses; c is the same for all rows
};

/// A straight line across faces of a T-mesh that is to become a line of knots, from side to side of each face, and the
/// three columns of faces that matter to it.
///
/// Directions are named as if the line ran upwards. A band is what lies between two successive rows, the edges that the
/// line crosses: a halfedge per column, the bottom of the face there, from left to right. The line runs in the column
/// in the middle, or, if this one lies at the border, in the first or the last one of the three next to the border.
/// \tparam FT the number type of the knots
template <typename FT>
class Inserted_line {
  using Structure = Spline_structure<FT>;
  using Arrays = T_mesh_arrays<FT>;
  using Status = Knot_insertion_status;
  using Band = std::array<int, 3>;

public:
  static constexpr int none = -1;

  /// \pre the T-mesh is spline compatible
  explicit Inserted_line(const Structure& structure)
    : m_structure(structure),
      m_t_mesh(structure.knot_arrays()),
      m_is_used(m_t_mesh.number_of_faces()),
      m_rings(m_t_mesh.number_of_faces())
  {
    find_rings();
  }

  /// Follows the line that crosses the bottom of a face, from the left at the part `x` of it, 0 < x < 1, in both
  /// directions. \return INSERTED if its knot can be inserted
  Status find(const int bottom, const FT& x)
  {
    m_x = x;
    if (!follow_up(bottom) || (!m_is_closed && !follow_down(bottom)))
      return m_status;
    for (const Band& band : m_bands)
      add_row(band);
    if (!m_is_closed)
      add_row(m_top_row);
    return m_status;
  }

  int vertex() const { return m_vertex; } ///< for AT_EXTRAORDINARY_VERTEX
  int face() const { return m_face; }     ///< for NOT_CONFORMING and LINE_MEETS_ITSELF

  /// In no particular order.
  const std::vector<Knot_row<FT>>& rows() const { return m_rows; }

  /// c of the rows: 0 or 2 in the column at the border, else 1.
  int column() const { return m_column; }

  /// The bottoms of the faces that the line crosses, in no particular order.
  std::vector<int> bottoms() const
  {
    std::vector<int> result;
    for (const Band& band : m_bands)
      result.push_back(band[m_column]);
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

  bool follow_up(const int bottom)
  {
    int b = bottom;
    do {
      if (!add_band(b))
        return false;
      b = above(b);
    } while (b != bottom && !m_t_mesh.is_border(b));
    m_is_closed = b == bottom;
    for (int c = 0; c < 3; ++c)
      m_top_row[c] = above(m_bands.back()[c]);
    return true;
  }

  bool follow_down(const int bottom)
  {
    for (int top = Arrays::opposite(bottom); !m_t_mesh.is_border(top);) {
      const int b = other_side(top);
      if (!add_band(b))
        return false;
      top = Arrays::opposite(b);
    }
    return true;
  }

  // The first halfedge of the side opposite to that of h.
  int other_side(const int h) const { return m_t_mesh.first_of_side(m_t_mesh.face(h), (m_t_mesh.side(h) + 2) % 4); }
  int above(const int bottom) const { return Arrays::opposite(other_side(bottom)); }

  // Adds the band in which the line crosses the bottom b. As all faces of the columns are quads and all their vertices
  // regular, those of successive bands meet edge to edge.
  bool add_band(const int b)
  {
    if (!add_face(m_t_mesh.face(b), 3))
      return false;
    const bool is_first = m_bands.empty(), is_leftmost = m_t_mesh.is_border(Arrays::opposite(m_t_mesh.prev(b))),
               is_rightmost = m_t_mesh.is_border(Arrays::opposite(m_t_mesh.next(b)));
    const int column = is_leftmost ? 0 : is_rightmost ? 2 : 1;
    // The border turns inwards inside of rings only, and leaves room for three columns.
    CGAL_assertion(!(is_leftmost && is_rightmost) && (is_first || column == m_column));
    CGAL_USE(is_first);
    m_column = column;
    Band band;
    band[m_column] = b;
    for (int c = m_column; c > 0; --c) {
      const int right = Arrays::opposite(m_t_mesh.prev(band[c]));
      if (!add_face(m_t_mesh.face(right), 2))
        return false;
      band[c - 1] = m_t_mesh.prev(right);
    }
    for (int c = m_column; c < 2; ++c) {
      const int left = Arrays::opposite(m_t_mesh.next(band[c]));
      if (!add_face(m_t_mesh.face(left), 2))
        return false;
      band[c + 1] = m_t_mesh.next(left);
    }
    m_bands.push_back(band);
    return true;
  }

  // The face must not lie in the rings with the numbers up to `ring`.
  bool add_face(const int f, const int ring)
  {
    m_face = f;
    m_vertex = m_rings[f].vertex;
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

  // Boehm's knot insertion. With the knots k_0, ..., k_7 of the four vertices, of which number j has k_j, ..., k_{j+4},
  // and the new knot y between k_3 and k_4, shares[j - 1] is (y - k_j) / (k_{j+3} - k_j), j = 1, 2, 3.
  void add_row(const Band& row)
  {
    Knot_row<FT> result;
    for (int i = 0; i < 3; ++i)
      result.vertices[i] = m_t_mesh.source(row[i]);
    result.vertices[3] = m_t_mesh.target(row[2]);
    result.edge = row[m_column];
    const Axis first = axis_at(row[0], row[1]), second = axis_at(row[1], row[2]);
    const FT y = m_column == 0 ? FT(0) : m_column == 1 ? FT(m_x * first.after) : first.after;
    const FT z = m_column == 0 ? FT(-second.before) : m_column == 1 ? FT(FT(m_x - FT(1)) * second.before) : FT(0);
    const auto share = [](const FT& x, const FT& from, const FT& to) { return FT(FT(x - from) / FT(to - from)); };
    const std::array<FT, 5>&k = first.knots, &l = second.knots;
    result.shares = {share(y, k[0], k[3]), share(y, k[1], k[4]), share(z, l[1], l[4])};
    m_rows.push_back(result);
  }

  // The knots of a vertex along a row, relative to it, and how far away its neighbours are, all in one unit.
  struct Axis {
    std::array<FT, 5> knots;
    FT before, after;
  };

  // At the vertex where `in` ends and `out` begins, in the direction of both. Only one of the two ways may be free: on
  // the border, one of `out` and `opposite(in)` is a border halfedge.
  Axis axis_at(const int in, const int out) const
  {
    const Vertex_quarters<FT> quarters(m_t_mesh, m_t_mesh.target(in));
    const int direction = m_t_mesh.is_border(out) ? number_of_direction(quarters, Arrays::opposite(in)) + 2
                                                  : number_of_direction(quarters, out);
    const Vertex_rays<FT> rays = m_structure.rays(m_t_mesh.target(in));
    const Knot_ray<FT>&after = rays[direction % 4], &before = rays[(direction + 2) % 4];
    return {axis_knots(after, before).t, before.distance[0], after.distance[0]};
  }

  int number_of_direction(const Vertex_quarters<FT>& quarters, const int out) const
  {
    int result = 0;
    while (m_t_mesh.next(quarters[result].h) != out)
      ++result;
    return result;
  }

  const Structure& m_structure;
  const Arrays& m_t_mesh;
  std::vector<char> m_is_used; // per face: in the columns
  std::vector<Ring> m_rings;   // per face
  FT m_x = FT(0);
  Status m_status = Status::INSERTED;
  int m_vertex = none, m_face = none, m_column = 1;
  bool m_is_closed = false;
  std::vector<Band> m_bands;
  Band m_top_row{};
  std::vector<Knot_row<FT>> m_rows;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_INSERTED_LINE_H
