// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_TRACING_INTERNAL_PLACES_ON_CHORDS_H
#define CGAL_T_SPLINES_TRACING_INTERNAL_PLACES_ON_CHORDS_H

#include <CGAL/T_splines/Similarity_map/support/Seamless_layout.h>
#include <CGAL/T_splines/Tracing/internal/Lines_in_faces.h>
#include <CGAL/T_splines/Tracing/internal/Motorcycle_traces.h>
#include <CGAL/T_splines/Tracing/internal/isoline_directions.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Whether a chord covers a place of its line, its ends included. \param along the coordinate of the place
template <typename FT, typename TracingTraits>
bool chord_covers(const Motorcycle_traces<FT>& traces, const Lines_in_faces<FT, TracingTraits>& lines,
                  const typename Motorcycle_traces<FT>::Chord& chord, const Enclosed_number<FT>& along)
{
  return (chord.start == traces.none || !lines.is_ahead(chord.direction, along, traces.coordinates[chord.start])) &&
         (chord.stop == traces.none || !lines.is_ahead(chord.direction, traces.coordinates[chord.stop], along));
}

/// Whether a place of a chord lies strictly inside the face, and no line through it ends on the chord or covers it.
template <typename FT, typename TracingTraits>
bool is_free_place(const Seamless_layout<FT>& layout, const Motorcycle_traces<FT>& traces,
                   const Lines_in_faces<FT, TracingTraits>& lines, const TracingTraits& traits,
                   const typename Motorcycle_traces<FT>::Chord& chord, const Enclosed_number<FT>& along)
{
  if (!chord_covers(traces, lines, chord, along))
    return false;
  int h = layout.mesh().halfedge_of_face(chord.face);
  for (int i = 0; i < 3; ++i, h = layout.mesh().next(h))
    if (traits.orientation(lines.corner(layout.mesh().previous(h)), lines.corner(h),
                           lines.point_on_line(chord.direction, chord.line, along)) != CGAL::POSITIVE)
      return false;
  for (int c = traces.first_chord_in_face[chord.face]; c != traces.none; c = traces.chords[c].next_in_place)
    if (axis_along(traces.chords[c].direction) != axis_along(chord.direction) &&
        traits.compare(traces.chords[c].line, along) == CGAL::EQUAL)
      return false;
  return true;
}

/// A double that is a free place of a chord across a face; none if the chord is too short to have one of those tried.
template <typename FT, typename TracingTraits>
std::optional<double> free_place_on_chord(const Seamless_layout<FT>& layout, const Motorcycle_traces<FT>& traces,
                                          const Lines_in_faces<FT, TracingTraits>& lines, const TracingTraits& traits,
                                          const typename Motorcycle_traces<FT>::Chord& chord)
{
  constexpr int finest_fraction = 256;
  const int axis = axis_along(chord.direction);
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  int h = layout.mesh().halfedge_of_face(chord.face);
  for (int i = 0; i < 3; ++i, h = layout.mesh().next(h)) {
    lower = (std::min)(lower, layout.uv(h)[axis]);
    upper = (std::max)(upper, layout.uv(h)[axis]);
  }
  for (int denominator = 2; denominator <= finest_fraction; denominator *= 2)
    for (int numerator = 1; numerator < denominator; numerator += 2) {
      const double x = lower + (upper - lower) * numerator / denominator;
      if (is_free_place(layout, traces, lines, traits, chord, {x, x, nullptr}))
        return x;
    }
  return std::nullopt;
}

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_TRACING_INTERNAL_PLACES_ON_CHORDS_H
