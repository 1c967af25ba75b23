// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_SPLINE_COMPILED_T_SPLINE_H
#define CGAL_T_SPLINES_SPLINE_COMPILED_T_SPLINE_H

#include <CGAL/T_splines/Spline/Bezier_patch_3.h>
#include <CGAL/T_splines/Spline/Surface_jet.h>
#include <CGAL/T_splines/Spline/internal/rational_jet.h>
#include <CGAL/T_splines/T_mesh/T_mesh_place.h>
#include <CGAL/T_splines/T_mesh/support/T_mesh_arrays.h>
#include <CGAL/T_splines/internal/Mesh_indexing.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesSpline
/// How the compilation of a T-spline surface ended.
enum class T_spline_compilation_status {
  COMPILED,   ///< all patches are there
  INTERRUPTED ///< the visitor asked to stop; there are no patches
};

/// \ingroup PkgTSplinesSpline
/// returns one sentence that explains `status`.
inline const char* message(const T_spline_compilation_status status)
{
  switch (status) {
  case T_spline_compilation_status::COMPILED: return "the surface was compiled";
  case T_spline_compilation_status::INTERRUPTED: return "interrupted by the visitor";
  }
  return "";
}

/// \ingroup PkgTSplinesSpline
/// The part of the surface that a Bezier patch of a compiled T-spline covers: [u_begin, u_end] x [v_begin, v_end] of a
/// face.
/// \tparam Graph a model of `FaceGraph`
template <typename Graph, typename FT>
struct Bezier_patch_domain {
  typename boost::graph_traits<Graph>::face_descriptor face; ///< of the T-mesh
  FT u_begin,                                                ///< smallest u
      u_end,                                                 ///< largest u
      v_begin,                                               ///< smallest v
      v_end;                                                 ///< largest v
  bool is_cap; ///< the patch stands for the surface around an extraordinary vertex, and is not exact
};

namespace internal {

template <typename Surface>
class T_spline_compiler;

// Tells the processor that an object will be read soon, where the compiler knows how.
template <typename T>
void prefetch([[maybe_unused]] const T& object)
{
#if defined(__GNUC__)
  constexpr std::size_t cache_line = 64;
  const char* const begin = reinterpret_cast<const char*>(&object);
  for (std::size_t i = 0; i < sizeof(T); i += cache_line)
    __builtin_prefetch(begin + i);
#endif
}

} // namespace internal

/// \ingroup PkgTSplinesSpline
/// A T-spline surface as rational bicubic Bezier patches, for fast evaluation and for export.
///
/// A face has one patch for each cell between the knot lines that cross it; they are the surface, up to round-off. A
/// face at an extraordinary vertex has three patches for each ring, the k-th ring being [0, 2^-(k-1)]^2 without [0,
/// 2^-k]^2 in units of the face, and a cap in [0, 2^-k]^2 for the last k. The cap joins the last ring with a continuous
/// tangent plane and its neighbours without a gap; how far it is from the surface, `cap_deviation()` tells.
///
/// It is made by `compile_T_spline()` and is independent of the surface then; the T-mesh must live on. Evaluation may
/// run in any number of threads.
/// \tparam Graph_ the T-mesh of the surface
/// \tparam Kernel_ its kernel
template <typename Graph_, typename Kernel_>
class Compiled_T_spline {
public:
  using Graph = Graph_;                          ///< the T-mesh's graph
  using Kernel = Kernel_;                        ///< the kernel
  using FT = typename Kernel::FT;                ///< number type
  using Point_3 = typename Kernel::Point_3;      ///< a point in space
  using Vector_3 = typename Kernel::Vector_3;    ///< a vector in space
  using Jet = Surface_jet<Kernel>;               ///< a point with its derivatives
  using Patch = Bezier_patch_3<Kernel>;          ///< a rational bicubic Bezier patch
  using Domain = Bezier_patch_domain<Graph, FT>; ///< the part of a face that a patch covers
  using Place = T_mesh_place<Graph, FT>;         ///< a face, and a point in its frame
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor; ///< a face of the graph

  /// returns whether the surface may be used: all but this and `number_of_patches()` demands that it was compiled.
  T_spline_compilation_status status() const { return m_status; }

  /// returns the number of Bezier patches.
  std::size_t number_of_patches() const { return m_patches.size(); }
  /// returns patch number `i`.
  const Patch& patch(const std::size_t i) const { return m_patches[i]; }
  /// returns which part of which face patch number `i` covers.
  Domain domain(const std::size_t i) const
  {
    const Rectangle& r = m_rectangles[i];
    return {m_indexing->face(r.face), r.u, FT(r.u + FT(1) / r.u_factor), r.v, FT(r.v + FT(1) / r.v_factor), r.is_cap};
  }

  /// returns the largest distance of points of caps from the surface, sampled: an absolute length. 0 without caps.
  double cap_deviation() const { return m_cap_deviation; }

  /// returns the number of rings at extraordinary vertices.
  int number_of_rings() const { return m_number_of_rings; }

  /// returns the graph of the T-mesh.
  const Graph& graph() const { return m_indexing->graph(); }
  /// returns the largest u of a face.
  FT width(const face_descriptor f) const { return m_t_mesh->width(m_indexing->face_index(f)); }
  /// returns the largest v of a face.
  FT height(const face_descriptor f) const { return m_t_mesh->height(m_indexing->face_index(f)); }

  /// returns the number of the patch that covers (u, v) of a face; where patches meet, of one of them.
  /// \pre 0 <= u <= width, 0 <= v <= height
  std::size_t patch_at(const face_descriptor f, const FT& u, const FT& v) const
  {
    return find_patch(m_indexing->face_index(f), u, v);
  }

  /// returns the point at (u, v) of a face.
  Point_3 position(const face_descriptor f, const FT& u, const FT& v) const
  {
    const std::size_t i = patch_at(f, u, v);
    const std::pair<FT, FT> p = local(i, u, v);
    return m_patches[i].position(p.first, p.second);
  }

  /// returns the point with the derivatives with respect to u and v of the face.
  Jet jet(const face_descriptor f, const FT& u, const FT& v) const
  {
    const std::size_t i = patch_at(f, u, v);
    const std::pair<FT, FT> p = local(i, u, v);
    Jet jet = m_patches[i].jet(p.first, p.second);
    const FT a = m_rectangles[i].u_factor, b = m_rectangles[i].v_factor;
    jet.du = a * jet.du;
    jet.dv = b * jet.dv;
    jet.duu = FT(a * a) * jet.duu;
    jet.duv = FT(a * b) * jet.duv;
    jet.dvv = FT(b * b) * jet.dvv;
    return jet;
  }

  /// returns the unit normal at (u, v) of a face; the zero vector where it is not defined.
  Vector_3 unit_normal(const face_descriptor f, const FT& u, const FT& v) const
  {
    return position_and_normal(f, u, v).second;
  }

  /// returns the point and the unit normal.
  std::pair<Point_3, Vector_3> position_and_normal(const face_descriptor f, const FT& u, const FT& v) const
  {
    const std::size_t i = patch_at(f, u, v);
    const std::pair<FT, FT> p = local(i, u, v);
    return evaluate_with_normal(i, p.first, p.second);
  }

  /// writes the points and unit normals (`std::pair<Point_3, Vector_3>`) at a range of places (`T_mesh_place`, or what
  /// has `face`, `u` and `v`). Consecutive places in the same face are fastest.
  /// \tparam PlaceRange a range with forward iterators
  template <typename PlaceRange, typename OutputIterator>
  OutputIterator positions_and_normals(const PlaceRange& places, OutputIterator out) const
  {
    // Patches are found in advance, so that they are on their way from the memory when they are needed.
    struct Found {
      std::size_t patch;
      std::pair<FT, FT> at;
    };
    std::array<Found, 16> block;
    auto place = std::begin(places);
    const auto end = std::end(places);
    while (place != end) {
      std::size_t n = 0;
      for (; n < block.size() && place != end; ++n, ++place) {
        const std::size_t i = patch_at(place->face, place->u, place->v);
        internal::prefetch(m_patches[i]);
        block[n] = {i, local(i, place->u, place->v)};
      }
      for (std::size_t k = 0; k < n; ++k)
        *out++ = evaluate_with_normal(block[k].patch, block[k].at.first, block[k].at.second);
    }
    return out;
  }

  /// writes the points at a range of places.
  template <typename PlaceRange, typename OutputIterator>
  OutputIterator positions(const PlaceRange& places, OutputIterator out) const
  {
    for (const auto& place : places)
      *out++ = position(place.face, place.u, place.v);
    return out;
  }

  /// \cond INTERNAL
  // What other headers of this room build on; not for users.
  const internal::T_mesh_arrays<FT>& t_mesh_arrays() const { return *m_t_mesh; }
  const internal::Mesh_indexing<Graph>& indexing() const { return *m_indexing; }
  /// \endcond

private:
  template <typename Surface>
  friend class internal::T_spline_compiler;

  // Where a patch begins in its face, and the reciprocal of its size.
  struct Rectangle {
    FT u, v, u_factor, v_factor;
    int face;
    bool is_cap;
  };

  // The patches of a face: of a grid of cells, row by row; or of a face at an extraordinary vertex.
  struct Face {
    std::size_t first_patch, first_cut;
    int columns, rows; ///< 0: at an extraordinary vertex
    int corner;        ///< the number of the corner with the extraordinary vertex, counter-clockwise
  };

  std::pair<Point_3, Vector_3> evaluate_with_normal(const std::size_t i, const FT& s, const FT& t) const
  {
    using CGAL::sqrt;
    using std::sqrt;
    const auto h = m_patches[i].template homogeneous_jet<1>(s, t);
    const FT r = FT(1) / h[0][3], x = h[0][0] * r, y = h[0][1] * r, z = h[0][2] * r;
    // Positive multiples of du and dv.
    const FT ax = h[1][0] - h[1][3] * x, ay = h[1][1] - h[1][3] * y, az = h[1][2] - h[1][3] * z,
             bx = h[2][0] - h[2][3] * x, by = h[2][1] - h[2][3] * y, bz = h[2][2] - h[2][3] * z;
    const FT nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx,
             length = sqrt(FT(nx * nx + ny * ny + nz * nz)), q = length > FT(0) ? FT(FT(1) / length) : FT(0);
    return {Point_3(x, y, z), Vector_3(nx * q, ny * q, nz * q)};
  }

  std::pair<FT, FT> local(const std::size_t i, const FT& u, const FT& v) const
  {
    const Rectangle& r = m_rectangles[i];
    return {FT((u - r.u) * r.u_factor), FT((v - r.v) * r.v_factor)};
  }

  std::size_t find_patch(const int f, const FT& u, const FT& v) const
  {
    const Face& face = m_faces[f];
    if (face.columns == 1 && face.rows == 1)
      return face.first_patch;
    if (face.columns == 0)
      return face.first_patch + patch_at_vertex(f, face.corner, u, v);
    std::size_t cut = face.first_cut;
    const int column = interval(cut, face.columns, u), row = interval(cut + face.columns - 1, face.rows, v);
    return face.first_patch + row * face.columns + column;
  }

  // The interval that contains x, of `number` that are separated by cuts.
  int interval(const std::size_t first_cut, const int number, const FT& x) const
  {
    int i = 0;
    while (i < number - 1 && m_cuts[first_cut + i] <= x)
      ++i;
    return i;
  }

  // Ring by ring; the three patches of a ring have the numbers of the corners that come after the vertex.
  std::size_t patch_at_vertex(const int f, const int corner, const FT& u, const FT& v) const
  {
    const FT width = m_t_mesh->width(f), height = m_t_mesh->height(f);
    FT x = u / width, y = v / height;
    if (corner == 1 || corner == 2)
      x = FT(1) - x;
    if (corner >= 2)
      y = FT(1) - y;
    if (corner % 2 == 1)
      std::swap(x, y); // the first spoke is the next side
    const FT half = FT(1) / FT(2);
    std::size_t i = 0;
    for (int ring = 0; ring < m_number_of_rings; ++ring, i += 3) {
      if (!(x < half))
        return i + (y < half ? 0 : 1);
      if (!(y < half))
        return i + 2;
      x = FT(2) * x;
      y = FT(2) * y;
    }
    return i;
  }

  std::shared_ptr<const internal::Mesh_indexing<Graph>> m_indexing;
  std::shared_ptr<const internal::T_mesh_arrays<FT>> m_t_mesh;
  std::vector<Patch> m_patches;
  std::vector<Rectangle> m_rectangles; // per patch
  std::vector<Face> m_faces;
  std::vector<FT> m_cuts;
  int m_number_of_rings = 0;
  double m_cap_deviation = 0;
  T_spline_compilation_status m_status = T_spline_compilation_status::COMPILED;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_SPLINE_COMPILED_T_SPLINE_H
