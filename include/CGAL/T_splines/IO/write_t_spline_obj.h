// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_T_SPLINE_OBJ_H
#define CGAL_T_SPLINES_IO_WRITE_T_SPLINE_OBJ_H

#include <CGAL/T_splines/IO/Atomic_file.h>
#include <CGAL/T_splines/IO/internal/Text_writer.h>
#include <CGAL/T_splines/Spline/Tessellation_resolution.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <system_error>

namespace CGAL {
namespace T_splines {

namespace internal {

template <typename Surface>
void format_t_spline_obj(Text_writer& writer, const Surface& surface, const Tessellation_resolution& resolution)
{
  const auto tessellation = tessellate_parameter_domain(surface, resolution);
  for (const auto& place : tessellation.places) {
    writer << "v ";
    writer.write_coordinates(surface.position(place.face, place.u, place.v)) << "\n";
  }
  for (const auto* const places : {&tessellation.places, &tessellation.crease_places})
    for (const auto& place : *places) {
      writer << "vn ";
      writer.write_coordinates(surface.unit_normal(place.face, place.u, place.v)) << "\n";
    }
  const auto normals = tessellation.triangles_split_at_creases();
  for (std::size_t i = 0; i < normals.size(); ++i) {
    writer << "f";
    for (std::size_t k = 0; k < 3; ++k)
      writer << " " << tessellation.triangles[i][k] + 1 << "//" << normals[i][k] + 1;
    writer << "\n";
  }
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// writes a T-spline surface to a stream, in the format of OBJ, as triangles with the normals of the surface (`v`, `vn`,
/// `f v//vn`), without cracks. At creases, triangles on both sides share the points (`v`) and have their own normals (`vn`).
/// Other formats: `tessellate_T_spline()` makes a mesh, which CGAL's functions write.
/// \tparam Surface a `T_spline_surface` or a `Compiled_T_spline`
/// \param out receives the file
/// \param surface \pre it is valid
/// \param resolution as for `tessellate_parameter_domain()`
/// \return `std::io_errc::stream` if the stream failed; converts to `false` if all was written. Complexity: linear in the
///         size of the file.
template <typename Surface>
std::error_code write_t_spline_obj(std::ostream& out, const Surface& surface,
                                   const Tessellation_resolution& resolution = {})
{
  internal::Text_writer writer(out);
  internal::format_t_spline_obj(writer, surface, resolution);
  return writer.finish();
}

/// \ingroup PkgTSplinesIO
/// writes a T-spline surface to an OBJ file, as the function that writes to a stream.
///
/// The file appears under its name only when it is complete and on the disk; if anything fails, nothing is left behind.
/// \param filename where to write; a file that is there is replaced
/// \param surface, resolution see the function that writes to a stream
/// \return the error of the operating system; converts to `false` if the file was written. Complexity: linear in the
///         size of the file.
template <typename Surface>
std::error_code write_t_spline_obj(const std::string& filename, const Surface& surface,
                                   const Tessellation_resolution& resolution = {})
{
  return internal::write_file(filename, [&](std::ostream& out) { write_t_spline_obj(out, surface, resolution); });
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_T_SPLINE_OBJ_H
