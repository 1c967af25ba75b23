// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_T_SPLINE_OBJ_H
#define CGAL_T_SPLINES_IO_WRITE_T_SPLINE_OBJ_H

#include <CGAL/T_splines/IO/internal/Atomic_file.h>
#include <CGAL/T_splines/IO/internal/Text_writer.h>
#include <CGAL/T_splines/Spline/tessellate_T_spline.h>

#include <CGAL/number_type_basic.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace T_splines {

namespace internal {

/// Hands the text of the file to `sink`, a function object that takes a `std::string_view`, piece by piece.
template <typename Sink, typename Surface>
void format_t_spline_obj(Sink& sink, const Surface& surface, const int resolution)
{
  const auto tessellation = tessellate_parameter_domain(surface, resolution);
  Text_writer<Sink> writer(sink);
  const auto write = [&writer](const std::string_view keyword, const auto& p) {
    writer << keyword << CGAL::to_double(p.x()) << " " << CGAL::to_double(p.y()) << " " << CGAL::to_double(p.z())
           << "\n";
  };
  for (const auto& place : tessellation.places)
    write("v ", surface.position(place.face, place.u, place.v));
  for (const auto& place : tessellation.places)
    write("vn ", surface.unit_normal(place.face, place.u, place.v));
  for (const std::array<std::size_t, 3>& triangle : tessellation.triangles) {
    writer << "f";
    for (const std::size_t i : triangle)
      writer << " " << i + 1 << "//" << i + 1;
    writer << "\n";
  }
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// writes a T-spline surface to an OBJ file, as triangles with the normals of the surface (`v`, `vn`, `f v//vn`),
/// without cracks.
///
/// The file appears under its name only when it is complete and on the disk; if anything fails, nothing is left behind.
/// Other formats:
/// `tessellate_T_spline()` makes a mesh, which CGAL's functions write.
/// \tparam Surface a `T_spline_surface` or a `Compiled_T_spline`
/// \param filename where to write; a file that is there is replaced
/// \param surface \pre it is valid
/// \param resolution as for `tessellate_parameter_domain()`
/// \return the error of the operating system; converts to `false` if the file was written. Complexity: linear in the
///         size of the file.
template <typename Surface>
std::error_code write_t_spline_obj(const std::string& filename, const Surface& surface, const int resolution)
{
  internal::Atomic_file file(filename);
  const auto sink = [&file](const std::string_view text) { file.write(text); };
  internal::format_t_spline_obj(sink, surface, resolution);
  file.finish() && file.commit();
  return std::error_code(file.error(), std::generic_category());
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_T_SPLINE_OBJ_H
