// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_SURFACE_FACE_SIZE_H
#define CGAL_T_SPLINES_T_MESH_SURFACE_FACE_SIZE_H

#include <CGAL/T_splines/T_mesh/Carried_points.h>
#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/internal/Metric_fit.h>

#include <CGAL/number_utils.h>

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// The size of the faces of a T-mesh in the parameter domain: a model of `TMeshFaceSize`. Only for T-meshes whose
/// knots agree on both sides of each edge this is a size that means the same everywhere.
template <typename TMesh, typename HalfedgeKnotMap, typename HalfedgeCornerMap>
class Parametric_face_size {
public:
  using Coordinates = T_mesh_coordinates<TMesh, HalfedgeKnotMap, HalfedgeCornerMap>;
  using face_descriptor = typename Coordinates::face_descriptor;

  explicit Parametric_face_size(const Coordinates& coordinates) : m_coordinates(coordinates) {}

  /// returns width and height of `f`.
  std::pair<double, double> operator()(const face_descriptor f) const
  {
    return {CGAL::to_double(m_coordinates.width(f)), CGAL::to_double(m_coordinates.height(f))};
  }

private:
  Coordinates m_coordinates;
};

/// The size of the faces of a T-mesh on the surface, measured by points that the T-mesh carries: a model of
/// `TMeshFaceSize`.
///
/// In each face a first fundamental form is fitted to the distances of nearby points. A face with too few points gets the form
/// of the old face from which it was cut, so that refinement need not stop where the points get sparse. A face that had
/// less than two points from the start has size zero: add its corners.
///
/// Functions that change the T-mesh must be given `visitor()`.
/// \tparam Points a `Carried_points` whose payload is a point with `x()`, `y()`, `z()`
template <typename TMesh, typename HalfedgeKnotMap, typename HalfedgeCornerMap, typename Points>
class Surface_face_size {
public:
  using Coordinates = T_mesh_coordinates<TMesh, HalfedgeKnotMap, HalfedgeCornerMap>;
  using face_descriptor = typename Coordinates::face_descriptor;

  /// The visitor that follows the changes of the faces, those of the points included; a model of `TMeshVisitor`.
  class Visitor : public T_mesh_visitor {
  public:
    explicit Visitor(Surface_face_size& size) : m_size(&size) {}

    template <typename FT>
    void faces_replaced(const std::vector<T_mesh_piece<TMesh, FT>>& pieces) const
    {
      m_size->replace_faces(pieces);
    }

  private:
    Surface_face_size* m_size;
  };

  /// \param points must outlive this; they are moved by `visitor()`
  Surface_face_size(const Coordinates& coordinates, Points& points) : m_coordinates(coordinates), m_points(&points) {}

  Visitor visitor() { return Visitor(*this); }

  /// returns the lengths of `f` along u and along v.
  std::pair<double, double> operator()(const face_descriptor f) const
  {
    const double width = CGAL::to_double(m_coordinates.width(f)), height = CGAL::to_double(m_coordinates.height(f));
    const auto found = m_units.find(f);
    const std::array<double, 2> units = found != m_units.end() ? found->second : measured(f, width, height);
    return {units[0] * width, units[1] * height};
  }

private:
  // Below this number of points, those of an old face say more.
  static constexpr std::size_t enough_points = 9;

  std::array<double, 2> measured(const face_descriptor f, const double width, const double height) const
  {
    std::vector<internal::Metric_fit::Sample> samples;
    for (const auto& p : m_points->points(f))
      samples.push_back({CGAL::to_double(p.u), CGAL::to_double(p.v),
                         {CGAL::to_double(p.payload.x()), CGAL::to_double(p.payload.y()),
                          CGAL::to_double(p.payload.z())}});
    return internal::Metric_fit::lengths(std::move(samples), width, height);
  }

  template <typename FT>
  void replace_faces(const std::vector<T_mesh_piece<TMesh, FT>>& pieces)
  {
    // What is known of an old face holds for each new one; where several old ones meet, the first.
    std::vector<std::pair<face_descriptor, std::array<double, 2>>> inherited;
    for (const T_mesh_piece<TMesh, FT>& piece : pieces) {
      std::array<double, 2> units = this->units(piece.from);
      if (piece.transition.quarter_turns() % 2 == 1)
        std::swap(units[0], units[1]);
      const double scale = CGAL::to_double(piece.transition.scale());
      inherited.push_back({piece.to, {units[0] / scale, units[1] / scale}});
    }
    m_points->replace_faces(pieces);
    for (const T_mesh_piece<TMesh, FT>& piece : pieces) {
      m_units.erase(piece.from);
      m_rectangles.erase(piece.from);
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const face_descriptor f = pieces[i].to;
      m_rectangles[f] = {CGAL::to_double(pieces[i].width), CGAL::to_double(pieces[i].height)};
      if (m_points->points(f).size() < enough_points)
        m_units.insert(inherited[i]);
    }
  }

  Coordinates m_coordinates;
  Points* m_points;
  std::unordered_map<face_descriptor, std::array<double, 2>, boost::hash<face_descriptor>> m_units;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_SURFACE_FACE_SIZE_H
