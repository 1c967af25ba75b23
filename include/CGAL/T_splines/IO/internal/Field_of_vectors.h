// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_FIELD_OF_VECTORS_H
#define CGAL_T_SPLINES_IO_INTERNAL_FIELD_OF_VECTORS_H

#include <CGAL/T_splines/Cross_field/check_triangle_mesh.h>
#include <CGAL/T_splines/Cross_field/support/cross_angles.h>
#include <CGAL/T_splines/Cross_field/support/Triangle_geometry.h>
#include <CGAL/T_splines/IO/Field_file_report.h>
#include <CGAL/T_splines/IO/internal/Field_file_parser.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>
#include <CGAL/T_splines/internal/Progress.h>
#include <CGAL/T_splines/internal/Triangulation_connectivity.h>
#include <CGAL/T_splines/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_config.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// The crosses of a mesh, as they are read from a file face by face.
template <typename TriangleMesh>
class Field_of_vectors {
public:
  using Vector_3 = Triangle_geometry::Vector_3;

  /// \pre The mesh is one that `check_triangle_mesh()` accepts, borders allowed.
  template <typename NamedParameters>
  Field_of_vectors(const TriangleMesh& mesh, const NamedParameters& np)
    : m_indexing(mesh),
      m_connectivity(triangulation_connectivity(m_indexing)),
      m_geometry(triangle_geometry(
          m_indexing, m_connectivity,
          CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
                                             get_const_property_map(CGAL::vertex_point, mesh)))),
      m_angle(m_connectivity.number_of_faces())
  {
  }

  int number_of_faces() const { return m_connectivity.number_of_faces(); }
  const Mesh_indexing<TriangleMesh>& indexing() const { return m_indexing; }
  const Triangulation_connectivity& connectivity() const { return m_connectivity; }
  const Triangle_geometry& geometry() const { return m_geometry; }

  /// sets the cross of face `f` to the one whose directions turn the least, in the mean, to become those of the vectors in rotational
  /// order: if a, b, c, d are the angles of the vectors, those of the cross add up to the same sum.
  ///
  /// The order of the vectors does not matter. For an orthogonal frame it is the frame; for two axes that are sheared it lies
  /// symmetrically to them.
  /// \param has_opposites whether the vectors are two and stand for their opposites too, or are all four
  /// \return `false`, with a report in `parser`, if they do not determine a cross: all lie in a half plane.
  bool set_cross(const int f, const std::vector<Vector_3>& vectors, const bool has_opposites, Field_file_parser& parser)
  {
    // By the part in the face: normals of another program may differ a little.
    constexpr double largest_normal_part = 1e-2;
    double sum = 0;
    m_directions.clear();
    for (const Vector_3& vector : vectors) {
      double x = 0, y = 0, normal = 0;
      if (!project_to_face(m_connectivity, m_geometry, f, vector, x, y, normal))
        return parser.fail(Field_file_status::ZERO_VECTOR, f);
      if (std::abs(normal) > largest_normal_part * std::hypot(x, y))
        return parser.fail(Field_file_status::NOT_TANGENT, f);
      m_directions.push_back(std::atan2(y, x));
      if (has_opposites)
        m_directions.push_back(std::atan2(-y, -x));
    }
    for (const double direction : m_directions)
      sum += direction;
    if (!go_around())
      return parser.fail(Field_file_status::NOT_A_CROSS, f);
    m_angle[f] = (sum - CGAL_PI) / 4; // the quarter turns of a cross add up to 3 pi, which is pi
    return true;
  }

  void set_angle(const int f, const double angle_in_face) { m_angle[f] = angle_in_face; }

  /// takes the matchings of the file, per halfedge. Without them they are those by the closest rotation.
  void set_matchings(std::vector<int> matchings) { m_matchings = std::move(matchings); }

  /// writes unit vectors to a property map.
  template <typename CrossFieldMap>
  void write_directions(CrossFieldMap& cross_field) const
  {
    using Value = typename boost::property_traits<CrossFieldMap>::value_type;
    for (int f = 0; f < number_of_faces(); ++f) {
      const Vector_3 v = std::cos(m_angle[f]) * m_geometry.x_axis(m_connectivity, f) +
                         std::sin(m_angle[f]) * m_geometry.y_axis(m_connectivity, f);
      put(cross_field, m_indexing.face(f), Value(v.x(), v.y(), v.z()));
    }
  }

  template <typename HalfedgeMatchingMap>
  void write_matchings(const HalfedgeMatchingMap& matching) const
  {
    for (int h = 0; h < m_connectivity.number_of_halfedges(); ++h)
      put(matching, m_indexing.halfedge(h), m_matchings.empty() ? closest_matching(h) : m_matchings[h]);
  }

private:
  // As `holonomy_signature_of_cross_field()` describes it.
  int closest_matching(const int h) const
  {
    const int g = opposite(h);
    if (m_connectivity.face(h) == Triangulation_connectivity::null ||
        m_connectivity.face(g) == Triangulation_connectivity::null)
      return 0;
    if (g < h)
      return -closest_matching(g); // where two are equally close, too
    const double from_other_face = m_angle[m_connectivity.face(g)] - m_geometry.direction(m_connectivity, g) + CGAL_PI;
    const double in_face = m_angle[m_connectivity.face(h)] - m_geometry.direction(m_connectivity, h);
    return static_cast<int>(std::lround((from_other_face - in_face) / (CGAL_PI / 2)));
  }

  // Whether no half plane is free of directions, with a little to spare.
  bool go_around()
  {
    std::sort(m_directions.begin(), m_directions.end());
    double largest_gap = m_directions.front() + 2 * CGAL_PI - m_directions.back();
    for (std::size_t i = 1; i < m_directions.size(); ++i)
      largest_gap = (std::max)(largest_gap, m_directions[i] - m_directions[i - 1]);
    constexpr double clearly_less = 0.999; // vectors in a half plane leave a gap of pi, up to the digits of a file
    return largest_gap < clearly_less * CGAL_PI;
  }

  Mesh_indexing<TriangleMesh> m_indexing;
  Triangulation_connectivity m_connectivity;
  Triangle_geometry m_geometry;
  std::vector<double> m_angle;
  std::vector<double> m_directions; // of one face
  std::vector<int> m_matchings;
};

/// checks the mesh that a field file is for.
template <typename TriangleMesh, typename NamedParameters>
bool check_mesh_of_field(const TriangleMesh& mesh, const NamedParameters& np, Field_file_parser& parser)
{
  const auto report = triangle_mesh_report(mesh, np, parser.progress());
  return report.success() ||
         parser.fail(report.status == Triangle_mesh_status::INTERRUPTED ? Field_file_status::INTERRUPTED
                                                                        : Field_file_status::INVALID_MESH);
}

/// reads a vector.
inline bool read_vector(Field_file_parser& parser, Triangle_geometry::Vector_3& vector)
{
  double x = 0, y = 0, z = 0;
  if (!parser.read_number(x) || !parser.read_number(y) || !parser.read_number(z))
    return false;
  vector = Triangle_geometry::Vector_3(x, y, z);
  return true;
}

/// reads the number of directions per face, which has to be `symmetry`, and the number of faces, in the order of the
/// format.
inline bool read_field_header(Field_file_parser& parser, const long long symmetry, const int number_of_faces,
                              const bool symmetry_is_first)
{
  long long first = 0, second = 0;
  if (!parser.read_integer(first) || !parser.read_integer(second))
    return false;
  const long long actual_symmetry = symmetry_is_first ? first : second, count = symmetry_is_first ? second : first;
  if (actual_symmetry != symmetry)
    return parser.fail(Field_file_status::WRONG_SYMMETRY, Field_file_report::none, symmetry, actual_symmetry);
  return count == number_of_faces ||
         parser.fail(Field_file_status::WRONG_COUNT, Field_file_report::none, number_of_faces, count);
}

/// reads a format: \return `false` after a report
template <typename TriangleMesh>
using Field_format = bool (*)(Field_file_parser& parser, Field_of_vectors<TriangleMesh>& field);

/// reads a field: what the public readers have in common.
/// \param source an `std::istream` or the name of a file
/// \param matching receives the matchings, unless it is `CGAL::internal_np::Param_not_found`
template <typename Source, typename TriangleMesh, typename CrossFieldMap, typename HalfedgeMatchingMap,
          typename NamedParameters>
Field_file_report read_field(Source& source, const Field_format<TriangleMesh> parse, const TriangleMesh& mesh,
                             CrossFieldMap& cross_field, const HalfedgeMatchingMap& matching, const NamedParameters& np)
{
  const auto visitor = progress_visitor(np);
  Progress progress(visitor);
  progress.begin_stage("reading");
  Field_file_parser parser(source, progress);
  if (!parser.success() || !check_mesh_of_field(mesh, np, parser))
    return parser.report();
  Field_of_vectors<TriangleMesh> field(mesh, np);
  if (parse(parser, field) && parser.go_on()) {
    field.write_directions(cross_field);
    if constexpr (!is_missing<HalfedgeMatchingMap>)
      field.write_matchings(matching);
  }
  return parser.report();
}

/// The same, for formats without matchings.
template <typename Source, typename TriangleMesh, typename CrossFieldMap, typename NamedParameters>
Field_file_report read_field(Source& source, const Field_format<TriangleMesh> parse, const TriangleMesh& mesh,
                             CrossFieldMap& cross_field, const NamedParameters& np)
{
  return read_field(source, parse, mesh, cross_field, CGAL::internal_np::Param_not_found(), np);
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_FIELD_OF_VECTORS_H
