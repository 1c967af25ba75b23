// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_IO_INTERNAL_SIDE_PAIRING_H
#define CGAL_T_SPLINES_IO_INTERNAL_SIDE_PAIRING_H

#include <CGAL/T_splines/IO/internal/Boundary_sides.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Two boundary sides that are one edge.
struct Side_pair {
  Polygon_side first, second;
  bool is_opposite; ///< they run in opposite directions, as the sides of an oriented surface do
};

/// Finds boundary sides that coincide up to a distance, both of them each other's nearest. Where several coincide, as
/// where bodies touch, those follow each other around the edge inside of a body.
class Side_pairing {
public:
  explicit Side_pairing(const Polygon_soup& soup) : m_soup(soup), m_directions(soup) {}

  /// Finds the pairs that coincide exactly and removes them from `sides`.
  void pair_coincident(std::vector<Polygon_side>& sides, std::vector<Side_pair>& pairs)
  {
    for (bool goes_on = true; goes_on && sides.size() > 1;) {
      std::unordered_map<Ends, std::vector<std::size_t>, boost::hash<Ends>> sides_of_ends;
      for (std::size_t a = 0; a < sides.size(); ++a)
        sides_of_ends[ends_of(sides[a])].push_back(a);
      const auto choose = [&](const std::size_t a, const bool is_opposite) {
        const auto position = sides_of_ends.find(is_opposite ? reversed(ends_of(sides[a])) : ends_of(sides[a]));
        return position == sides_of_ends.end() ? none : follower(sides, a, position->second, is_opposite);
      };
      goes_on = take_mutual(choose, sides, pairs);
    }
  }

  /// The same for pairs whose ends are at most `distance` apart. What differs by no more than `round_off` coincides.
  void pair_near(const double distance, const double round_off, std::vector<Polygon_side>& sides,
                 std::vector<Side_pair>& pairs)
  {
    for (bool goes_on = true; goes_on && sides.size() > 1;) {
      std::vector<Numbered_ends> points;
      for (std::size_t a = 0; a < sides.size(); ++a)
        points.push_back({ends_of(sides[a]), a});
      const Tree tree(points.begin(), points.end());
      const auto choose = [&](const std::size_t a, const bool is_opposite) {
        return nearest(tree, sides, a, is_opposite, distance, round_off);
      };
      goes_on = take_mutual(choose, sides, pairs);
    }
  }

  /// The larger one of the distances between the ends.
  double distance(const Side_pair& pair) const
  {
    const Ends a = ends_of(pair.first), b = ends_of(pair.second);
    return end_distance(a, pair.is_opposite ? reversed(b) : b);
  }

private:
  /// The coordinates of source and target.
  using Ends = std::array<double, 6>;

  struct Numbered_ends {
    Ends coordinates;
    std::size_t side;
  };
  struct Coordinates_of {
    using result_type = const double*;
    const double* operator()(const Numbered_ends& p) const { return p.coordinates.data(); }
    const double* operator()(const Numbered_ends& p, int) const { return p.coordinates.data() + 6; }
  };
  using Traits = CGAL::Search_traits<double, Numbered_ends, const double*, Coordinates_of, CGAL::Dimension_tag<6>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  using Tree = Search::Tree;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  Ends ends_of(const Polygon_side& side) const
  {
    const auto &p = m_soup.points[side.source], &q = m_soup.points[side.target];
    return {p[0], p[1], p[2], q[0], q[1], q[2]};
  }
  static Ends reversed(const Ends& e) { return {e[3], e[4], e[5], e[0], e[1], e[2]}; }
  static double end_distance(const Ends& a, const Ends& b)
  {
    return std::max(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]),
                    std::hypot(a[3] - b[3], a[4] - b[4], a[5] - b[5]));
  }

  /// Of sides that coincide, the one that follows on `a`; `none` if there is none but `a`.
  std::size_t follower(const std::vector<Polygon_side>& sides, const std::size_t a,
                       const std::vector<std::size_t>& others, const bool is_opposite) const
  {
    std::size_t first = none;
    double least = 0;
    for (const std::size_t b : others) {
      if (b == a)
        continue;
      const double angle = is_opposite ? m_directions.angle_inside(sides[a], sides[b]) : 0;
      if (first == none || angle < least) {
        first = b;
        least = angle;
      }
    }
    return first;
  }

  std::size_t nearest(const Tree& tree, const std::vector<Polygon_side>& sides, const std::size_t a,
                      const bool is_opposite, const double distance, const double round_off) const
  {
    constexpr unsigned int most = 16; // sides of one edge: there eight bodies would touch
    const Ends ends = ends_of(sides[a]), query = is_opposite ? reversed(ends) : ends;
    std::vector<std::pair<double, std::size_t>> found;
    double least = distance;
    for (const auto& [point, squared_distance] : Search(tree, Numbered_ends{query, a}, most)) {
      const double d = end_distance(query, point.coordinates);
      if (point.side == a || d > distance)
        continue;
      found.emplace_back(d, point.side);
      least = std::min(least, d);
    }
    std::vector<std::size_t> others;
    for (const auto& [d, b] : found)
      if (d <= least + round_off)
        others.push_back(b);
    return follower(sides, a, others, is_opposite);
  }

  /// Moves sides that have chosen each other to the pairs. \return whether there were any.
  /// \param choose the partner of a side among those that run the other way, or among those that run the same way
  template <typename Choose>
  static bool take_mutual(const Choose& choose, std::vector<Polygon_side>& sides, std::vector<Side_pair>& pairs)
  {
    std::vector<std::pair<std::size_t, bool>> choices;
    for (std::size_t a = 0; a < sides.size(); ++a) {
      const std::size_t b = choose(a, true);
      choices.emplace_back(b != none ? b : choose(a, false), b != none);
    }
    std::vector<Polygon_side> rest;
    for (std::size_t a = 0; a < sides.size(); ++a) {
      const auto [b, is_opposite] = choices[a];
      if (b == none || choices[b].first != a)
        rest.push_back(sides[a]);
      else if (a < b)
        pairs.push_back({sides[a], sides[b], is_opposite});
    }
    const bool has_found = rest.size() < sides.size();
    sides = std::move(rest);
    return has_found;
  }

  const Polygon_soup& m_soup;
  Side_directions m_directions;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_IO_INTERNAL_SIDE_PAIRING_H
