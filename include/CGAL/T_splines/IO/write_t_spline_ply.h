// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_T_SPLINE_PLY_H
#define CGAL_T_SPLINES_IO_WRITE_T_SPLINE_PLY_H

#include <CGAL/T_splines/IO/Atomic_file.h>
#include <CGAL/T_splines/IO/base64.h>
#include <CGAL/T_splines/IO/internal/Text_writer.h>
#include <CGAL/T_splines/Spline/Tessellation_resolution.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesIO
/// writes a T-spline surface to a stream, as a binary PLY file (little endian): triangles without cracks, with the normals
/// of the surface. Coordinates (`x`, `y`, `z`) are doubles, normals (`nx`, `ny`, `nz`) floats. It is about a third of
/// the size of the OBJ file. Normals are of vertices, as the format has it: at creases that of one of the sides, so that shading
/// by them blurs creases; `write_t_spline_obj()` keeps those of all sides.
/// \tparam Surface a `T_spline_surface` or a `Compiled_T_spline`
/// \param out receives the file; it should be open in binary mode
/// \param surface \pre it is valid
/// \param resolution as for `tessellate_parameter_domain()`
/// \return `std::io_errc::stream` if the stream failed; converts to `false` if all was written. Complexity: linear in the
///         size of the file.
template <typename Surface>
std::error_code write_t_spline_ply(std::ostream& out, const Surface& surface,
                                   const Tessellation_resolution& resolution = {})
{
  const auto tessellation = tessellate_parameter_domain(surface, resolution);
  internal::Text_writer writer(out);
  writer << "ply\nformat binary_little_endian 1.0\nelement vertex " << tessellation.places.size()
         << "\nproperty double x\nproperty double y\nproperty double z\nproperty float nx\nproperty float ny\n"
            "property float nz\nelement face "
         << tessellation.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  std::vector<double> point(3);
  std::vector<float> normal(3);
  for (const auto& place : tessellation.places) {
    const auto p = surface.position(place.face, place.u, place.v);
    const auto n = surface.unit_normal(place.face, place.u, place.v);
    for (int k = 0; k < 3; ++k) {
      point[k] = CGAL::to_double(p[k]);
      normal[k] = static_cast<float>(CGAL::to_double(n[k]));
    }
    writer << little_endian_bytes(point) << little_endian_bytes(normal);
  }
  std::vector<std::int32_t> corners(3);
  for (const std::array<std::size_t, 3>& triangle : tessellation.triangles) {
    for (int k = 0; k < 3; ++k)
      corners[k] = static_cast<std::int32_t>(triangle[k]);
    writer << "\3" << little_endian_bytes(corners);
  }
  return writer.finish();
}

/// \ingroup PkgTSplinesIO
/// writes a T-spline surface to a binary PLY file, as the function that writes to a stream.
///
/// The file appears under its name only when it is complete and on the disk; if anything fails, nothing is left behind.
/// \param filename where to write; a file that is there is replaced
/// \param surface, resolution see the function that writes to a stream
/// \return the error of the operating system; converts to `false` if the file was written. Complexity: linear in the
///         size of the file.
template <typename Surface>
std::error_code write_t_spline_ply(const std::string& filename, const Surface& surface,
                                   const Tessellation_resolution& resolution = {})
{
  return internal::write_file(filename, [&](std::ostream& out) { write_t_spline_ply(out, surface, resolution); });
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_T_SPLINE_PLY_H
