// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_T_MESH_CARRIED_SAMPLES_H
#define CGAL_T_SPLINES_T_MESH_CARRIED_SAMPLES_H

#include <CGAL/T_splines/T_mesh/T_mesh_observer.h>
#include <CGAL/T_splines/T_mesh/move_place.h>
#include <CGAL/T_splines/internal/converted_number.h>
#include <CGAL/T_splines/internal/converted_similarity.h>

#include <CGAL/assertions.h>

#include <boost/container_hash/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {

/// \ingroup PkgTSplinesTMesh
/// Samples of a surface that stay where they are on the surface while the T-mesh changes under them: `samples()` has
/// their places in the T-mesh as it is, and is what `fit_T_spline()` takes.
///
/// Give `observer()` to the operations that change the T-mesh. They move places by `move_place()`, which keeps each in the
/// closed rectangle of its face; each takes time linear in the number of samples in the faces that it touches.
///
/// It can be filled by `sample_T_mesh()` and `std::back_inserter()`.
/// \tparam Graph_ a model of `FaceGraph`
/// \tparam Sample_ a copyable type with the member `place`, a `T_mesh_place<Graph, NT>`, and whatever goes with it:
///         `T_mesh_sample`, or another model of `TMeshSample`
template <typename Graph_, typename Sample_>
class Carried_samples {
public:
  using Graph = Graph_;                                                         ///< the T-mesh's graph
  using Sample = Sample_;                                                       ///< a sample
  using value_type = Sample;                                                    ///< what `push_back()` takes
  using NT = std::decay_t<decltype(std::declval<Sample>().place.u)>;            ///< number type of the places
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor; ///< a face of the graph

  /// The observer that moves the samples from old faces to new ones, a model of `TMeshObserver`. It refers to the samples.
  ///
  /// \cgalModels{TMeshObserver}
  class Observer : public T_mesh_observer {
  public:
    /// refers to `samples`.
    explicit Observer(Carried_samples& samples) : m_samples(&samples) {}

    /// follows the change of faces.
    template <typename FT>
    void faces_replaced(const std::vector<T_mesh_piece<Graph, FT>>& pieces) const
    {
      m_samples->replace_faces(pieces);
    }

  private:
    Carried_samples* m_samples;
  };

  /// has no samples.
  Carried_samples() = default;
  /// takes over samples whose places are in the T-mesh as it is.
  explicit Carried_samples(std::vector<Sample> samples) : m_samples(std::move(samples)) {}

  /// adds a sample whose place is in the T-mesh as it is.
  void push_back(Sample sample) { m_samples.push_back(std::move(sample)); }

  /// returns all samples, in the order in which they came.
  const std::vector<Sample>& samples() const { return m_samples; }
  /// returns all samples, to be changed: a fit moves places. Changes end with the next change of the T-mesh; after it, call
  /// this function again. Which samples are in a face is then found anew, in linear time.
  std::vector<Sample>& samples()
  {
    m_numbers.clear();
    m_number_of_known = 0;
    return m_samples;
  }

  /// returns the numbers of the samples in the face `f`, counted from 0 and in no particular order; valid until the T-mesh
  /// or the samples change.
  const std::vector<std::size_t>& samples_in_face(const face_descriptor f) const
  {
    find_numbers();
    const auto found = m_numbers.find(f);
    return found == m_numbers.end() ? m_none : found->second;
  }

  /// returns the observer that keeps it up to date; it refers to this object.
  Observer observer() { return Observer(*this); }

private:
  using Piece = T_mesh_piece<Graph, NT>;

  // What leaves an old face, and the ways.
  struct Departure {
    std::vector<std::size_t> numbers;
    std::vector<Piece> pieces;
  };

  void find_numbers() const
  {
    for (; m_number_of_known < m_samples.size(); ++m_number_of_known)
      m_numbers[m_samples[m_number_of_known].place.face].push_back(m_number_of_known);
  }

  template <typename FT>
  void replace_faces(const std::vector<T_mesh_piece<Graph, FT>>& pieces)
  {
    find_numbers();
    for (const Departure& departure : departures(pieces))
      for (const std::size_t i : departure.numbers) {
        [[maybe_unused]] const Piece* way = move_place(m_samples[i].place, departure.pieces);
        CGAL_precondition_msg(way != nullptr, "a place was changed without a new call of samples()");
        m_numbers[m_samples[i].place.face].push_back(i);
      }
  }

  // Takes the samples out of the old faces.
  template <typename FT>
  std::vector<Departure> departures(const std::vector<T_mesh_piece<Graph, FT>>& pieces)
  {
    std::vector<Departure> result;
    std::unordered_map<face_descriptor, std::size_t, boost::hash<face_descriptor>> index;
    for (const T_mesh_piece<Graph, FT>& piece : pieces) {
      const auto [known, is_new] = index.emplace(piece.from, result.size());
      if (is_new) {
        result.emplace_back();
        const auto found = m_numbers.find(piece.from);
        if (found != m_numbers.end()) {
          result.back().numbers.swap(found->second);
          m_numbers.erase(found);
        }
      }
      Departure& departure = result[known->second];
      if (!departure.numbers.empty())
        departure.pieces.push_back({piece.from, piece.to, internal::converted_similarity<NT>(piece.transition),
                                    internal::converted_number<NT>(piece.width),
                                    internal::converted_number<NT>(piece.height)});
    }
    return result;
  }

  std::vector<Sample> m_samples;
  // Of the samples of each face; only the first ones may be known.
  mutable std::unordered_map<face_descriptor, std::vector<std::size_t>, boost::hash<face_descriptor>> m_numbers;
  mutable std::size_t m_number_of_known = 0;
  std::vector<std::size_t> m_none;
};

} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_T_MESH_CARRIED_SAMPLES_H
