// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_SURFACE_FACE_SIZE_H
#define CGAL_T_SPLINES_T_MESH_SURFACE_FACE_SIZE_H

#include <CGAL/T_splines/T_mesh/T_mesh_coordinates.h>
#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/internal/Metric_fit.h>

#include <CGAL/number_type_basic.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// The size of the faces of a T-mesh in the parameter domain: a model of `TMeshFaceSize`. Only for T-meshes whose
/// knots agree on both sides of each edge this is a size that means the same everywhere.
///
/// \cgalModels{TMeshFaceSize}
///
/// \tparam TMesh as for `T_mesh_coordinates`
template <typename TMesh>
class Parametric_face_size {
public:
  using Coordinates = T_mesh_coordinates<TMesh>;                 ///< coordinates in the faces
  using face_descriptor = typename Coordinates::face_descriptor; ///< a face of the graph

  /// measures in the T-mesh of `coordinates`.
  explicit Parametric_face_size(const Coordinates& coordinates) : m_coordinates(coordinates) {}

  /// returns width and height of `f`.
  std::pair<double, double> operator()(const face_descriptor f) const
  {
    return {CGAL::to_double(m_coordinates.width(f)), CGAL::to_double(m_coordinates.height(f))};
  }

private:
  Coordinates m_coordinates;
};

/// \ingroup PkgTSplinesTMesh
/// The size of the faces of a T-mesh on the surface, measured by samples that the T-mesh carries: a model of
/// `TMeshFaceSize`.
///
/// In each face a first fundamental form is fitted to the distances of nearby samples. A face with too few of them gets
/// the form of the old face from which it was cut, so that refinement need not stop where the samples get sparse. With
/// each change of a face, the length of a parameter unit grows by a fifth at most, so that refinement ends. A face that
/// had less than two samples from the start has size zero: add its corners.
///
/// Functions that change the T-mesh must be given `observer()`.
///
/// \cgalModels{TMeshFaceSize}
///
/// \tparam TMesh as for `T_mesh_coordinates`
/// \tparam Samples a `Carried_samples` whose samples have the member `point`, with `x()`, `y()`, `z()`
template <typename TMesh, typename Samples>
class Surface_face_size {
public:
  using Graph = typename TMesh::Graph;                           ///< the T-mesh's graph
  using Coordinates = T_mesh_coordinates<TMesh>;                 ///< coordinates in the faces
  using face_descriptor = typename Coordinates::face_descriptor; ///< a face of the graph

  /// The observer that follows the changes of the faces, those of the samples included; a model of `TMeshObserver`.
  ///
  /// \cgalModels{TMeshObserver}
  class Observer : public T_mesh_observer {
  public:
    /// refers to `size`.
    explicit Observer(Surface_face_size& size) : m_size(&size) {}

    /// follows the change of faces.
    template <typename FT>
    void faces_replaced(const std::vector<T_mesh_piece<Graph, FT>>& pieces) const
    {
      m_size->replace_faces(pieces);
    }

  private:
    Surface_face_size* m_size;
  };

  /// measures all faces.
  /// \param coordinates of the T-mesh
  /// \param samples all of them; they must outlive this, and are moved by `observer()` from now on
  Surface_face_size(const Coordinates& coordinates, Samples& samples) : m_coordinates(coordinates), m_samples(&samples)
  {
    for (const face_descriptor f : faces(coordinates.t_mesh().graph())) {
      const double width = CGAL::to_double(coordinates.width(f)), height = CGAL::to_double(coordinates.height(f));
      m_units.emplace(f, measured(f, width, height).lengths);
    }
  }

  /// returns the observer that keeps it up to date; it refers to this object.
  Observer observer() { return Observer(*this); }

  /// returns the lengths of `f` along u and along v.
  std::pair<double, double> operator()(const face_descriptor f) const
  {
    const double width = CGAL::to_double(m_coordinates.width(f)), height = CGAL::to_double(m_coordinates.height(f));
    const std::array<double, 2> lengths = units(f);
    return {lengths[0] * width, lengths[1] * height};
  }

private:
  using Fit = internal::Metric_fit;

  // A split leaves at most two thirds of an extent. So the product of the two lengths is multiplied by less than
  // 2/3 growth^2 < 1, and the refinement with any samples ends, however little they look like a surface.
  static constexpr double growth = 1.2;

  Fit::Result measured(const face_descriptor f, const double width, const double height) const
  {
    const Samples& samples = *m_samples;
    std::vector<Fit::Point> points;
    for (const std::size_t i : samples.samples_in_face(f)) {
      const auto& s = samples.samples()[i];
      points.push_back({CGAL::to_double(s.place.u),
                        CGAL::to_double(s.place.v),
                        {CGAL::to_double(s.point.x()), CGAL::to_double(s.point.y()), CGAL::to_double(s.point.z())}});
    }
    return Fit::fit(std::move(points), width, height);
  }

  // The lengths of a unit step along u and of one along v.
  std::array<double, 2> units(const face_descriptor f) const
  {
    const auto found = m_units.find(f);
    return found != m_units.end() ? found->second : std::array<double, 2>{0, 0};
  }

  template <typename FT>
  void replace_faces(const std::vector<T_mesh_piece<Graph, FT>>& pieces)
  {
    // What is known of an old face holds for each new one; where several old ones meet, of the first.
    std::vector<std::array<double, 2>> inherited;
    for (const T_mesh_piece<Graph, FT>& piece : pieces) {
      std::array<double, 2> lengths = units(piece.from);
      if (piece.transition.quarter_turns() % 2 == 1)
        std::swap(lengths[0], lengths[1]);
      const double scale = CGAL::to_double(piece.transition.scale());
      inherited.push_back({lengths[0] / scale, lengths[1] / scale});
    }
    m_samples->observer().faces_replaced(pieces);
    for (const T_mesh_piece<Graph, FT>& piece : pieces)
      m_units.erase(piece.from);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const auto inserted = m_units.emplace(pieces[i].to, inherited[i]);
      if (!inserted.second)
        continue;
      const Fit::Result fit =
          measured(pieces[i].to, CGAL::to_double(pieces[i].width), CGAL::to_double(pieces[i].height));
      if (!(inherited[i][0] > 0))
        inserted.first->second = fit.lengths;
      else if (fit.is_measured) {
        for (int k = 0; k < 2; ++k)
          inserted.first->second[k] = (std::min)(fit.lengths[k], growth * inherited[i][k]);
      }
    }
  }

  Coordinates m_coordinates;
  Samples* m_samples;
  std::unordered_map<face_descriptor, std::array<double, 2>, boost::hash<face_descriptor>> m_units;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_SURFACE_FACE_SIZE_H
