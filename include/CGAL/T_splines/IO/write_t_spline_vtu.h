// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_WRITE_T_SPLINE_VTU_H
#define CGAL_T_SPLINES_IO_WRITE_T_SPLINE_VTU_H

#include <CGAL/T_splines/IO/Atomic_file.h>
#include <CGAL/T_splines/IO/base64.h>
#include <CGAL/T_splines/IO/internal/Text_writer.h>

#include <CGAL/number_type_basic.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL {
namespace T_splines {

namespace internal {

/// Writes a data array of a VTK XML file: base64 of its size in bytes and of the numbers.
template <typename Number>
void format_vtk_array(Text_writer& writer, const std::string_view attributes, const std::vector<Number>& numbers)
{
  const std::vector<std::uint64_t> size{numbers.size() * sizeof(Number)};
  writer << "<DataArray " << attributes << " format=\"binary\">\n"
         << base64(little_endian_bytes(size) + little_endian_bytes(numbers)) << "\n</DataArray>\n";
}

/// The places (i, j) of the control points of a bicubic patch in the order of VTK: corners, sides, inside.
inline const std::array<std::array<int, 2>, 16>& vtk_bezier_order()
{
  static const std::array<std::array<int, 2>, 16> order{{{0, 0},
                                                         {3, 0},
                                                         {3, 3},
                                                         {0, 3}, // corners
                                                         {1, 0},
                                                         {2, 0},
                                                         {3, 1},
                                                         {3, 2}, // bottom, right
                                                         {1, 3},
                                                         {2, 3},
                                                         {0, 1},
                                                         {0, 2}, // top, left
                                                         {1, 1},
                                                         {2, 1},
                                                         {1, 2},
                                                         {2, 2}}};
  return order;
}

template <typename CompiledTSpline>
void format_t_spline_vtu(Text_writer& writer, const CompiledTSpline& surface)
{
  const std::size_t n = surface.number_of_patches();
  std::vector<double> points, weights;
  std::vector<std::int64_t> connectivity, offsets, faces;
  std::vector<std::uint8_t> types(n, 77), caps; // 77: VTK_BEZIER_QUADRILATERAL
  points.reserve(48 * n);
  weights.reserve(16 * n);
  std::int64_t face_number = -1;
  auto last_face = boost::graph_traits<typename CompiledTSpline::Graph>::null_face();
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::array<int, 2>& place : vtk_bezier_order()) {
      const auto p = surface.patch(i).control_point(place[0], place[1]);
      for (const auto& x : {p.x(), p.y(), p.z()})
        points.push_back(CGAL::to_double(x));
      weights.push_back(CGAL::to_double(surface.patch(i).weight(place[0], place[1])));
      connectivity.push_back(static_cast<std::int64_t>(connectivity.size()));
    }
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    const auto domain = surface.domain(i);
    face_number += domain.face != last_face; // the patches of a face follow each other
    last_face = domain.face;
    faces.push_back(face_number);
    caps.push_back(domain.is_cap);
  }
  writer << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
            "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
         << 16 * n << "\" NumberOfCells=\"" << n << "\">\n<PointData RationalWeights=\"RationalWeights\">\n";
  format_vtk_array(writer, "type=\"Float64\" Name=\"RationalWeights\"", weights);
  writer << "</PointData>\n<CellData>\n";
  format_vtk_array(writer, "type=\"Int64\" Name=\"face\"", faces);
  format_vtk_array(writer, "type=\"UInt8\" Name=\"is_cap\"", caps);
  writer << "</CellData>\n<Points>\n";
  format_vtk_array(writer, "type=\"Float64\" NumberOfComponents=\"3\"", points);
  writer << "</Points>\n<Cells>\n";
  format_vtk_array(writer, "type=\"Int64\" Name=\"connectivity\"", connectivity);
  format_vtk_array(writer, "type=\"Int64\" Name=\"offsets\"", offsets);
  format_vtk_array(writer, "type=\"UInt8\" Name=\"types\"", types);
  writer << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

} // namespace internal

/// \ingroup PkgTSplinesIO
/// writes a compiled T-spline surface to a stream, as an unstructured grid of VTK (XML, `.vtu`): one rational bicubic
/// `VTK_BEZIER_QUADRILATERAL` per patch, which VTK 9 and ParaView draw as curved surfaces.
///
/// Points are euclidean control points, in VTK's order; the point data `RationalWeights`, marked as such, are their
/// weights. The cell data
/// `face` tell the number of the patch's face in the T-mesh, `is_cap` whether the patch is a cap at an extraordinary
/// vertex. All numbers are written as they are, in binary (base64).
/// \tparam CompiledTSpline a `Compiled_T_spline`
/// \return `std::io_errc::stream` if the stream failed; converts to `false` if all was written. Complexity: linear.
template <typename CompiledTSpline>
std::error_code write_t_spline_vtu(std::ostream& out, const CompiledTSpline& surface)
{
  internal::Text_writer writer(out);
  internal::format_t_spline_vtu(writer, surface);
  return writer.finish();
}

/// \ingroup PkgTSplinesIO
/// writes a compiled T-spline surface to a file of VTK, as the function that writes to a stream.
///
/// The file appears under its name only when it is complete and on the disk; if anything fails, nothing is left behind.
/// \return the error of the operating system; converts to `false` if the file was written. Complexity: linear.
template <typename CompiledTSpline>
std::error_code write_t_spline_vtu(const std::string& filename, const CompiledTSpline& surface)
{
  return internal::write_file(filename, [&](std::ostream& out) { write_t_spline_vtu(out, surface); });
}

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_WRITE_T_SPLINE_VTU_H
