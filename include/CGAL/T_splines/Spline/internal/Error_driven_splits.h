// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INTERNAL_ERROR_DRIVEN_SPLITS_H
#define CGAL_T_SPLINES_SPLINE_INTERNAL_ERROR_DRIVEN_SPLITS_H

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/internal/Regular_rings.h>
#include <CGAL/T_splines/T_mesh/internal/Split_position.h>
#include <CGAL/T_splines/T_mesh/internal/Spline_structure.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// A face that is to be split, and how.
template <typename TMesh>
struct Planned_split {
  typename boost::graph_traits<TMesh>::face_descriptor face;
  double error;    ///< the largest one in the face, by the tolerance
  bool is_in_four; ///< or in two, across the longer side
  int longer_axis; ///< of the face on the surface: 0 for u, 1 for v
};

/// Splits faces where a surface is too far from its samples ([He06] section 3.3), and makes the rings around
/// extraordinary vertices finer where one of their faces is among them.
///
/// New rings are half as wide as the old ones, whose lines they take over. Had the faces in the rings been split one by
/// one, the rings to be inserted then would be six times as fine.
/// \tparam Visitor a model of `TMeshVisitor`
template <typename TMesh, typename HalfedgeKnotMap, typename HalfedgeCornerMap, typename Visitor>
class Error_driven_splits {
  using Editor = T_mesh_editor<TMesh, HalfedgeKnotMap, HalfedgeCornerMap, Visitor>;
  using FT = typename Editor::FT;
  using face_descriptor = typename Editor::face_descriptor;
  using Plan = Planned_split<TMesh>;

public:
  Error_driven_splits(TMesh& t_mesh, const HalfedgeKnotMap knots, const HalfedgeCornerMap corners,
                      const Visitor& visitor)
    : m_t_mesh(t_mesh),
      m_knots(knots),
      m_corners(corners),
      m_editor(t_mesh, knots, corners, visitor),
      m_split_position(t_mesh, knots, corners)
  {
  }

  /// \pre the T-mesh is spline compatible
  void run(const std::vector<Plan>& plans)
  {
    find_rings();
    std::set<std::size_t> rings;
    for (const Plan& plan : plans) {
      const auto found = m_rings_of_face.find(plan.face);
      if (found != m_rings_of_face.end())
        rings.insert(found->second.begin(), found->second.end());
    }
    for (const std::size_t i : rings)
      halve(m_rings[i]);
    for (const Plan& plan : plans)
      if (m_halved.count(plan.face) == 0)
        split(plan);
  }

private:
  struct Cell {
    face_descriptor face;
    int direction; ///< of the first spoke of the sector, in the frame of the face: 0 to 3 for +u, +v, -u, -v
  };
  using Sector = std::array<Cell, 4>; ///< the cells (0, 0), (1, 0), (0, 1), (1, 1)
  using Rings = std::vector<Sector>;
  template <typename Value>
  using Face_hash_map = std::unordered_map<face_descriptor, Value, boost::hash<face_descriptor>>;

  void find_rings()
  {
    const Mesh_indexing<TMesh> indexing(m_t_mesh);
    Spline_structure<FT> structure(indexing, m_knots, m_corners);
    structure.check_rings();
    for (const Regular_rings<FT>& rings : structure.rings()) {
      Rings cells;
      for (int sector = 0; sector < rings.valence(); ++sector) {
        for (int x = 0; x < 3; ++x)
          for (int y = 0; y < (x < 2 ? 3 : 2); ++y)
            m_rings_of_face[indexing.face(rings.face(sector, x, y))].push_back(m_rings.size());
        const auto cell = [&](const int x, const int y) {
          const int bottom = rings.bottom(sector, x, y);
          return Cell{indexing.face(structure.knot_arrays().face(bottom)), structure.knot_arrays().side(bottom)};
        };
        cells.push_back({cell(0, 0), cell(1, 0), cell(0, 1), cell(1, 1)});
      }
      m_rings.push_back(cells);
    }
  }

  // Lines at 1/2 and 3/2 of the old unit, as far as the new third ring reaches.
  void halve(const Rings& rings)
  {
    for (const Sector& sector : rings) {
      const auto is_halved = [&](const Cell& cell) { return m_halved.count(cell.face) != 0; };
      if (std::any_of(sector.begin(), sector.end(), is_halved))
        continue; // it belongs to the rings of another vertex, too
      for (const Cell& part : halves(sector[0], 0))
        halves(part, 1);
      halves(halves(sector[1], 0)[0], 1);
      halves(halves(sector[2], 1)[0], 0);
      halves(halves(sector[3], 0)[0], 1);
      for (const Cell& cell : sector)
        m_halved.insert(cell.face);
    }
  }

  // The two halves along the first spoke if `axis` is 0, along the second one if it is 1; the one closer to the
  // extraordinary vertex first.
  std::array<Cell, 2> halves(const Cell& cell, const int axis)
  {
    const int direction = (cell.direction + axis) % 4;
    const FT size =
        direction % 2 == 0 ? m_editor.coordinates().width(cell.face) : m_editor.coordinates().height(cell.face);
    const auto edit = m_editor.split_face(cell.face, direction % 2, FT(size / FT(2)));
    const Cell low{face(edit.halfedge, m_t_mesh), cell.direction};
    const Cell high{face(opposite(edit.halfedge, m_t_mesh), m_t_mesh), cell.direction};
    return direction < 2 ? std::array<Cell, 2>{low, high} : std::array<Cell, 2>{high, low};
  }

  void split(const Plan& plan)
  {
    const auto edit = m_editor.split_face(plan.face, plan.longer_axis, m_split_position(plan.face, plan.longer_axis));
    if (!plan.is_in_four)
      return;
    const face_descriptor other = face(opposite(edit.halfedge, m_t_mesh), m_t_mesh);
    const face_descriptor one = face(edit.halfedge, m_t_mesh);
    for (const face_descriptor f : {one, other})
      m_editor.split_face(f, 1 - plan.longer_axis, m_split_position(f, 1 - plan.longer_axis));
  }

  TMesh& m_t_mesh;
  HalfedgeKnotMap m_knots;
  HalfedgeCornerMap m_corners;
  Editor m_editor;
  Split_position<TMesh, HalfedgeKnotMap, HalfedgeCornerMap> m_split_position;
  std::vector<Rings> m_rings; // per extraordinary vertex
  Face_hash_map<std::vector<std::size_t>> m_rings_of_face;
  std::unordered_set<face_descriptor, boost::hash<face_descriptor>> m_halved; // cells of rings
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INTERNAL_ERROR_DRIVEN_SPLITS_H
