// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_INSERT_KNOT_LINE_H
#define CGAL_T_SPLINES_SPLINE_INSERT_KNOT_LINE_H

#include <CGAL/T_splines/Spline/Control_point_map.h>
#include <CGAL/T_splines/Spline/Knot_insertion_report.h>
#include <CGAL/T_splines/Spline/internal/Homogeneous_vector.h>
#include <CGAL/T_splines/Spline/internal/Inserted_line.h>
#include <CGAL/T_splines/T_mesh/T_mesh_editor.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/T_mesh_view.h>
#include <CGAL/T_splines/T_mesh/check_spline_compatibility.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/converted_number.h>
#include <CGAL/T_splines/internal/exactness.h>
#include <CGAL/T_splines/internal/tolerances.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_basic.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

// Inserts a line into a T-mesh and moves the control points beside it.
// \tparam TMesh a `T_mesh_view`
template <typename TMesh, typename ControlPointMap>
class Knot_line_insertion {
  using Graph = typename TMesh::Graph;
  using vertex_descriptor = typename TMesh::vertex_descriptor;
  using halfedge_descriptor = typename TMesh::halfedge_descriptor;
  using face_descriptor = typename TMesh::face_descriptor;
  using Knot = typename TMesh::FT;
  using Control_point = typename boost::property_traits<ControlPointMap>::value_type;
  using FT = typename Control_point_kernel<Control_point>::type::FT;
  using Homogeneous = Homogeneous_vector<FT>;
  using Arrays = T_mesh_arrays<Knot>;
  using Report = Knot_insertion_report<Graph>;

  // A new vertex: it comes into the edge of a halfedge, at a distance from its source.
  struct New_vertex {
    halfedge_descriptor halfedge;
    Knot distance;
  };

  // Four vertices, and the control points of those in the middle and the new one, from left to right.
  struct Row {
    std::array<vertex_descriptor, 4> vertices;
    std::array<Homogeneous, 3> controls;
    std::array<bool, 3> stays; // which of the control points are what they were
    int column;                // the new vertex lies between those with this number and the next one
    New_vertex new_vertex;
  };

  struct Cut {
    face_descriptor face;
    int axis;
    Knot x;
  };

public:
  Knot_line_insertion(const TMesh& t_mesh, const ControlPointMap control_points)
    : m_t_mesh(t_mesh),
      m_control_points(control_points)
  {
  }

  // Looks at everything and changes nothing.
  template <typename NamedParameters>
  Report prepare(const face_descriptor f, const int axis, const Knot& x, const NamedParameters& np, Progress& progress)
  {
    Report report;
    if (!is_known_admissible(m_t_mesh, np, progress, report.compatibility)) {
      report.status = Knot_insertion_status::NOT_SPLINE_COMPATIBLE;
      return report;
    }
    const Mesh_indexing<Graph> indexing(m_t_mesh.graph());
    Spline_structure<Knot> structure(indexing, m_t_mesh, progress);
    Spline_defect defect = defect_before_supports(structure);
    if (!defect)
      defect = structure.find_supports([](int, const Basis_support<Knot>&) {});
    if (defect) {
      report.status = Knot_insertion_status::NOT_SPLINE_COMPATIBLE;
      set_defect(structure.in_graph(defect), indexing, report.compatibility);
      return report;
    }
    const Arrays& arrays = structure.knot_arrays();
    const int i = indexing.face_index(f);
    const Knot size = arrays.side_length(i, axis), eps = margin(size);
    if (!(x > eps && x < size - eps)) {
      report.status = Knot_insertion_status::OUTSIDE;
      return report;
    }
    Inserted_line<Knot> line(structure);
    const Knot part = x / size;
    report.status = line.find(arrays.first_of_side(i, axis), part);
    if (report.success())
      add(line, part, structure, indexing, report);
    else if (report.status == Knot_insertion_status::AT_EXTRAORDINARY_VERTEX ||
             report.status == Knot_insertion_status::NEAR_CREASE)
      report.vertex = indexing.vertex(line.vertex());
    else
      report.face = indexing.face(line.face());
    return report;
  }

  // pre: prepare() succeeded
  template <typename Observer>
  void run(const Observer& observer) const
  {
    T_mesh_editor editor(m_t_mesh, observer);
    for (const Row& row : m_rows) {
      const auto edit = editor.insert_vertex(row.new_vertex.halfedge, row.new_vertex.distance);
      CGAL_assertion(bool(edit));
      const vertex_descriptor v = target(edit.halfedge, m_t_mesh.graph());
      for (int j = 0, k = 1; j < 3; ++j) {
        const vertex_descriptor w = j == row.column ? v : row.vertices[k++];
        if (!row.stays[j])
          put_control_point(w, row.controls[j]);
      }
    }
    for (const Cut& cut : m_cuts) {
      const auto edit = editor.split_face(cut.face, cut.axis, cut.x);
      CGAL_assertion(bool(edit));
      CGAL_USE(edit);
    }
  }

private:
  // In a narrower interval, round-off on opposite sides would be more than check_admissibility() takes.
  static Knot margin(const Knot& size)
  {
    if constexpr (is_exact_number_type<Knot>)
      return Knot(0);
    else
      return size * Knot(summed_round_off);
  }

  void add(const Inserted_line<Knot>& line, const Knot& part, const Spline_structure<Knot>& structure,
           const Mesh_indexing<Graph>& indexing, Report& report)
  {
    const Arrays &arrays = structure.knot_arrays(), &uncut_arrays = structure.uncut_arrays();
    const Knot rest = Knot(1) - part;
    for (const Knot_row<Knot>& row : line.rows()) {
      std::array<Homogeneous, 4> old_controls;
      Row new_row;
      new_row.column = row.column;
      for (int j = 0; j < 4; ++j) {
        if (row.vertices[j] == Arrays::none)
          continue;
        new_row.vertices[j] = indexing.vertex(row.vertices[j]);
        old_controls[j].values = homogeneous<FT>(get(m_control_points, new_row.vertices[j]));
        const FT& weight = old_controls[j].values[3];
        if (!CGAL::is_finite(weight) || !(weight > FT(0))) {
          report.status = Knot_insertion_status::WEIGHT_NOT_POSITIVE;
          report.vertex = new_row.vertices[j];
          return;
        }
      }
      new_row.stays = {row.vertices[0] == Arrays::none, false, row.vertices[3] == Arrays::none};
      for (int j = 0; j < 3; ++j)
        if (!new_row.stays[j])
          new_row.controls[j] = old_controls[j] * converted_number<FT>(Knot(Knot(1) - row.shares[j])) +
                                old_controls[j + 1] * converted_number<FT>(row.shares[j]);
      new_row.new_vertex = {indexing.halfedge(row.edge),
                            Knot((row.is_reversed ? rest : part) * uncut_arrays.knot(row.edge))};
      m_rows.push_back(new_row);
    }
    for (const int b : line.bottoms()) {
      const int side = arrays.side(b);
      m_cuts.push_back({indexing.face(arrays.face(b)), side % 2, Knot((side < 2 ? part : rest) * arrays.knot(b))});
    }
    report.inserted_vertices = m_rows.size();
  }

  void put_control_point(const vertex_descriptor v, const Homogeneous& control) const
  {
    const std::array<FT, 4>& h = control.values;
    if constexpr (has_weight<Control_point>) {
      using Point_3 = typename Control_point_kernel<Control_point>::type::Point_3;
      put(m_control_points, v, Control_point(Point_3(FT(h[0] / h[3]), FT(h[1] / h[3]), FT(h[2] / h[3])), h[3]));
    }
    else
      put(m_control_points, v, Control_point(h[0], h[1], h[2]));
  }

  TMesh m_t_mesh;
  ControlPointMap m_control_points;
  std::vector<Row> m_rows;
  std::vector<Cut> m_cuts;
};

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// inserts a line of knots into a T-spline surface, across all faces that it meets, and moves the control points beside
/// it so that the surface stays what it is at every point.
///
/// The line goes straight on from the face `f` in both directions until it closes or reaches the border. It works where
/// the T-mesh conforms around it: the faces that it crosses, its column, and those of the columns to its left and to
/// its right must be quads that meet edge to edge, so that the T-mesh looks like a grid there; elsewhere it may be any.
/// Where the line's column lies at the border, the two other columns are those next to it. Beyond a crease no column is
/// needed. The line may cross creases, and goes straight on.
///
/// Why the surface does not change. Along a row, the edges that the line crosses, the basis functions of the four
/// vertices of the columns have a common factor, as their knots in the direction of the line are the heights of the
/// bands between rows, the same for all columns; the new vertex of the row gets these knots too. In the other factor,
/// the four have the knots k_0, ..., k_7, number j of them the five from k_j. Outer ones come from beyond the columns,
/// perhaps across T-joints, and may differ from row to row; k_3 and k_4 are next to the line at x. After the insertion,
/// the five vertices have the knots k_0, ..., k_3, x, k_4, ..., k_7. So in each row Boehm's algorithm for curves (1980)
/// applies to the homogeneous control points: with s_j = (x - k_j) / (k_{j+3} - k_j), the three in the middle of the
/// new row are (1 - s_j) P_{j-1} + s_j P_j, j = 1, 2, 3, and the outer two stay.
///
/// At a border, the first interval inside has no knot at its end ("not a knot", see `T_spline_surface`), so that some
/// of the k_j are the border. If the line falls into this interval, the end of it becomes the end of the second
/// interval and thus a knot: this one, not x, is inserted, and it lies between k_3 and k_4 as well.
///
/// At a crease, the knots are mirrored, and the control point beyond is 2 p - q, with p on the crease and q of the next
/// column: the curve of a row is one half of a curve that is symmetric to the point p. It stays so if the mirror image of
/// x is inserted, too. This moves what lies beyond p, and p stays, as the curve ends there. So the rule holds again after
/// the insertion, and in the row all is as above, without P_0 or P_3 where v_1 or v_2 is on the crease. A row along a
/// crease has the same knots and ends on both sides of it, so that both ask for the same new control points.
///
/// The common factor needs that all columns see the same ends above and below the line. They do not where a line along a
/// crease or the border ends at a crease and the surface beside it goes straight on: there no line is inserted
/// (`NEAR_CREASE`). This concerns lines within two columns of a border that cross a crease.
///
/// No other basis function changes. Rays along the line do not meet it, as no vertex lay on it. A ray across the line
/// begins at one of the four vertices of a row or outside of the columns: between two rows no vertex lies on a column
/// line. From outside it meets two column lines before the line, and the third intersection is no knot. It matters only
/// whether that is the border; but if the line lies between a border and the fourth column line from it, the columns
/// reach to that line; a crease that far away does not matter.
///
/// In the faces at an extraordinary vertex the surface is made of the control points of its first two rings, which must
/// stay, as must its rings. So the line must not run through the three rings. It may run along them: the vertices of
/// the second ring are outer ones of their rows then. From the rings around a corner of the border or of creases with three
/// or more quarter turns it must keep one column away, as functions of these rings have ends of their own at the border.
///
/// The result is spline compatible: the rings are what they were, supports only shrink, and that of the new vertex is a
/// part of one that its neighbour had.
/// \tparam TMesh a model of `TMesh` whose graph is one of `MutableFaceGraph`, `FaceListGraph`, `HalfedgeListGraph` and
///         `VertexListGraph`; it may have a border
/// \tparam ControlPointMap a read/write map, vertex -> control point: `Kernel::Weighted_point_3`, as of
///         `Control_point_map`, or `Kernel::Point_3`, whose weights are 1 and stay so. Its values may also be set at
///         vertices that the graph has just added.
/// \param t_mesh the T-mesh of the surface; it is changed
/// \param control_points those of three vertices of each row change, the new one included; all are affine combinations
///        of two, in homogeneous coordinates
/// \param f, axis, x the line is u = `x` in the frame of `f` if `axis` is 0, v = `x` if it is 1. With inexact knots, it
///        must keep away from the sides of the face by 1e-6 of its size.
/// \param np an optional sequence of named parameters among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{observer}
///     \cgalParamDescription{what follows the changes of the T-mesh}
///     \cgalParamType{a model of `TMeshObserver`, copied}
///     \cgalParamDefault{`T_mesh_observer`}
///   \cgalParamNEnd
///   \cgalParamNBegin{relative_tolerance}
///     \cgalParamDescription{as for `check_admissibility()`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`default_relative_tolerance`, 1e-9; 0 for exact number types}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{what hears of the progress and may stop the work}
///     \cgalParamType{a model of `ProgressVisitor`, copied}
///     \cgalParamDefault{`Progress_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return whether the line was inserted, with the number of its vertices; if not, nothing has changed, and the status
///         tells why, and where. With exact knots all decisions are exact; with inexact ones the surface changes by
///         round-off.
/// \pre `axis` is 0 or 1
///
/// Complexity: linear in the number of pairs of a vertex and a face of its support, since the whole T-mesh is checked.
template <typename TMesh, typename ControlPointMap,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Knot_insertion_report<T_mesh_graph<TMesh>>
insert_knot_line(TMesh&& t_mesh, const ControlPointMap control_points,
                 const typename std::decay_t<TMesh>::face_descriptor f, const int axis,
                 const typename std::decay_t<TMesh>::FT& x,
                 const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  CGAL_precondition_msg(axis == 0 || axis == 1, "the axis is neither 0 nor 1");
  internal::Knot_line_insertion<T_mesh_view_of<TMesh>, ControlPointMap> insertion(t_mesh, control_points);
  const auto visitor = internal::progress_visitor(np);
  internal::Progress progress(visitor);
  progress.begin_stage("knot insertion");
  auto report = insertion.prepare(f, axis, x, np, progress);
  if (!progress.go_on())
    report.status = Knot_insertion_status::INTERRUPTED;
  if (report)
    insertion.run(choose_parameter(get_parameter(np, np_tags::observer), T_mesh_observer()));
  return report;
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_INSERT_KNOT_LINE_H
