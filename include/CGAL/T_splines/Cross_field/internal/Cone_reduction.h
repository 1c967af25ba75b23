// Copyright (c) 2026 The T_splines authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_REDUCTION_H
#define CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_REDUCTION_H

#include <CGAL/T_splines/Cross_field/internal/field_holonomy.h>
#include <CGAL/T_splines/internal/Progress.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace T_splines {
namespace internal {

/// Cones of these numbers of quarter turns are usual: others are not made unless there is no other way.
constexpr int fewest_quarter_turns = 3, most_quarter_turns = 6;

/// When merging cones ends.
struct Cone_reduction_limits {
  int number_of_cones = (std::numeric_limits<int>::max)(); ///< as long as there are more, they are merged at any price
  std::vector<double> energy_change;                       ///< beyond that, the highest price of a merge, per component
};

/// `quarter_turns` of one cone that go to another one; cones are given by their indices.
struct Cone_move {
  int from = -1, to = -1;
  int quarter_turns = 0;
  double energy_change = 0;

  bool is_null() const { return from < 0; }
};

/// What a signature tells, on cones and strips with indices.
struct Cones_and_strips {
  std::vector<int> component;           ///< per cone: quarter turns move within it
  std::vector<int> quarter_turns;       ///< per cone
  std::vector<int> strip_quarter_turns; ///< per strip
};

/// The greedy merging of cones, on numbers alone: where cones and strips lie is in the energies and paths.
///
/// A cone a merged into a cone b becomes regular, and k_b becomes k_b + k_a - 4: the curvature t = (k_b' - k_b) pi/2
/// goes from b to a. With the Green's function G and the mean u of the logarithmic scale factor over the disk of each
/// cone, the first part of `Scale_energy` changes by t (u_a - u_b) + t^2/2 (G_aa - 2 G_ab + G_bb), and u by t (G_a -
/// G_b): no system has to be solved. The second part, of the strips, is 1/2 |y|^2 for a vector y that changes by t d,
/// where d depends on the path from a to b. It cannot decrease by more than itself: paths of merges whose first part is
/// too large for that are not needed.
///
/// The vectors d are kept. Where those of all pairs, on surfaces of high genus, would take too much memory, only merges
/// of cones that are near to each other are tried; the fewer cones are left, the more of them.
/// \tparam ScaleEnergy see `Scale_energy`
/// \tparam Paths see `Cone_paths`
template <typename ScaleEnergy, typename Paths>
class Cone_reduction {
  static constexpr int regular = 4;

public:
  /// \param progress if it is interrupted, all operations end soon, and the signature means nothing any more
  Cone_reduction(const ScaleEnergy& energy, Paths& paths, const Cones_and_strips& signature, Progress& progress)
    : m_energy(energy),
      m_paths(paths),
      m_progress(progress),
      m_signature(signature),
      m_potential(signature.quarter_turns.size()),
      m_period(signature.strip_quarter_turns.size())
  {
    const int n = static_cast<int>(m_potential.size());
    m_total = energy.defect_energy();
    for (int i = 0; i < n; ++i) {
      m_potential[i] = -energy.defect_potential(i);
      for (int j = 0; j < n; ++j)
        m_potential[i] += curvature(j) * energy.interaction(i, j);
      m_total += 0.5 * curvature(i) * (m_potential[i] - energy.defect_potential(i));
      if (signature.quarter_turns[i] != regular)
        m_cones.push_back(i);
    }
    m_partners.resize(n);
    for (int l = 0; l < energy.number_of_strips(); ++l) {
      m_period[l] = signature.strip_quarter_turns[l] * quarter_turn + energy.strip_residual(l);
      for (int i = 0; i < n; ++i)
        m_period[l] += curvature(i) * energy.strip_potential(l, i);
    }
    energy.to_orthonormal(m_period);
    m_total += strip_energy();
  }

  /// changes the numbers of strips by quarter turns, as long as each lowers the energy.
  /// \return how many. Complexity: with l strips, O(l^3), and O(l^2) per quarter turn.
  int straighten_strips()
  {
    const std::size_t n = m_period.size();
    std::vector<std::vector<double>> columns(n, std::vector<double>(n, 0.)); // what a quarter turn adds to y
    for (std::size_t l = 0; l < n; ++l) {
      columns[l][l] = quarter_turn;
      m_energy.to_orthonormal(columns[l]);
      m_progress.go_on_after(1 + n * n / 64);
    }
    for (int number = 0;; ++number) {
      std::size_t best = 0;
      int turns = 0;
      double least = -least_gain;
      for (std::size_t l = 0; l < n; ++l) {
        const double product = scalar_product(m_period, columns[l]);
        const double change = 0.5 * scalar_product(columns[l], columns[l]) - std::abs(product);
        if (change < least) {
          best = l;
          turns = product > 0 ? -1 : 1;
          least = change;
        }
      }
      if (turns == 0 || !m_progress.go_on_after(1 + n * n / 32))
        return number;
      for (std::size_t i = 0; i < n; ++i)
        m_period[i] += turns * columns[best][i];
      m_signature.strip_quarter_turns[best] += turns;
      m_total += least;
    }
  }

  /// moves quarter turns between cones out of the usual range and any other vertices, as long as each lowers the
  /// energy.
  /// \return how many. Complexity: O(n m) for each of m such cones, and what the paths cost.
  int split()
  {
    int number = 0;
    for (;; ++number) {
      const Cone_move move = cheapest_split();
      if (move.is_null() || m_progress.is_interrupted() ||
          move.energy_change > (m_signature.quarter_turns[move.from] == 1 ? 0 : -least_gain))
        break;
      apply(move);
    }
    return number;
  }

  /// merges cones until the limits allow no more. The progress is that of the number of cones. Complexity: O(n^2) per merge, and what the paths cost.
  void reduce(const Cone_reduction_limits& limits)
  {
    for (int i = 0; i < static_cast<int>(m_potential.size()); ++i)
      forget_if_regular(i);
    find_partners(number_of_partners());
    const int before = number_of_cones();
    while (m_progress.go_on()) {
      m_progress.progress(1 - static_cast<double>(number_of_cones()) / (before + 1));
      const bool is_demanded = number_of_cones() > limits.number_of_cones;
      const Cone_move move = is_demanded ? demanded_move() : cheapest_affordable_merge(limits.energy_change);
      if (m_progress.is_interrupted())
        return;
      const bool is_acceptable = !move.is_null();
      if (is_acceptable) {
        apply(move);
        m_merges.push_back(move);
        forget_if_regular(move.from);
        forget_if_regular(move.to);
      }
      const int more_partners = is_demanded && !is_acceptable ? 2 * m_number_of_partners : number_of_partners();
      if (!m_pairs_are_all && more_partners >= (is_acceptable ? 2 : 1) * m_number_of_partners + (is_acceptable ? 0 : 1))
        find_partners(more_partners);
      else if (!is_acceptable)
        return;
    }
  }

  double energy() const { return m_total; }
  int number_of_cones() const { return static_cast<int>(m_cones.size()); }
  const Cones_and_strips& signature() const { return m_signature; }
  const std::vector<Cone_move>& merges() const { return m_merges; } ///< in this order
  const std::vector<Cone_move>& moves() const { return m_moves; }   ///< all of them, in this order

private:
  using Range = std::pair<int, int>;
  static constexpr double least_gain = 0.05; // of energy, for which quarter turns are moved
  static constexpr Range usual_range{fewest_quarter_turns, most_quarter_turns};

  // How many partners per cone there is memory for.
  int number_of_partners() const
  {
    constexpr std::size_t most_numbers = 1 << 23;
    constexpr std::size_t fewest = 8;
    const std::size_t per_partner = (std::max)(m_period.size() * m_cones.size(), std::size_t(1));
    return static_cast<int>((std::max)(most_numbers / per_partner, fewest));
  }

  // Chooses with which cones each one may be merged: all others, or the nearest ones.
  void find_partners(const int number)
  {
    m_number_of_partners = number;
    m_pairs_are_all = m_period.empty() || number_of_cones() <= 2 * number;
    m_directions.clear();
    if (!m_period.empty())
      m_paths.restart();
    for (std::vector<int>& partners : m_partners)
      partners.clear();
    if (m_pairs_are_all)
      return;
    for (const int a : m_cones) {
      if (m_progress.is_interrupted())
        return;
      for (const int b : m_paths.nearest(a, number)) {
        m_partners[a].push_back(b);
        m_partners[b].push_back(a);
      }
    }
    for (std::vector<int>& partners : m_partners) {
      std::sort(partners.begin(), partners.end());
      partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
    }
  }

  void forget_if_regular(const int i)
  {
    if (m_signature.quarter_turns[i] == regular)
      m_paths.forget(i);
  }

  double curvature(const int i) const { return (regular - m_signature.quarter_turns[i]) * quarter_turn; }

  double strip_energy() const
  {
    return 0.5 * std::inner_product(m_period.begin(), m_period.end(), m_period.begin(), 0.);
  }

  // The part of the change that does not depend on paths.
  double cone_energy_change(const Cone_move& move) const
  {
    const int a = move.from, b = move.to;
    const double t = move.quarter_turns * quarter_turn;
    return t * (m_potential[a] - m_potential[b]) +
           0.5 * t * t * (m_energy.interaction(a, a) - 2 * m_energy.interaction(a, b) + m_energy.interaction(b, b));
  }

  // What merging the first cone of a pair into the second one adds to y, for a curvature of 1; `from` < `to`.
  struct Direction {
    std::vector<double> change; // d
    double length = 0;          // |d|
  };

  const Direction& direction(const int from, const int to)
  {
    Direction& direction = m_directions[{from, to}];
    if (direction.change.empty()) {
      const std::vector<int> crossings = m_paths.crossings(from, to);
      direction.change.resize(m_period.size());
      for (int l = 0; l < static_cast<int>(m_period.size()); ++l)
        direction.change[l] = m_energy.strip_potential(l, from) - m_energy.strip_potential(l, to) - crossings[l];
      m_energy.to_orthonormal(direction.change);
      direction.length = std::sqrt(scalar_product(direction.change, direction.change));
    }
    return direction;
  }

  static double scalar_product(const std::vector<double>& a, const std::vector<double>& b)
  {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
  }

  // The curvature that a move carries in the direction of its pair.
  static double directed_curvature(const Cone_move& move)
  {
    return (move.from < move.to ? move.quarter_turns : -move.quarter_turns) * quarter_turn;
  }

  double strip_energy_change(const Cone_move& move)
  {
    if (m_period.empty())
      return 0;
    const Direction& d = direction((std::min)(move.from, move.to), (std::max)(move.from, move.to));
    const double t = directed_curvature(move);
    return t * scalar_product(m_period, d.change) + 0.5 * t * t * d.length * d.length;
  }

  // A lower bound of the same, which does not need paths that are not known. \param length |y|
  double least_strip_energy_change(const Cone_move& move, const double length) const
  {
    const auto known = m_directions.find(std::minmax(move.from, move.to));
    if (known == m_directions.end())
      return -0.5 * length * length;
    const double change = std::abs(directed_curvature(move)) * known->second.length;
    return change * (0.5 * change - length);
  }

  // Whether `a` is tried later than `b`: more expensive, or, for equal results everywhere, of higher indices.
  static bool is_later(const Cone_move& a, const Cone_move& b)
  {
    if (a.energy_change != b.energy_change)
      return a.energy_change > b.energy_change;
    return a.from != b.from ? a.from > b.from : a.to > b.to;
  }

  // The move that raises the energy least among those that `turns(a, b)` offers; it is 0 where there is none.
  template <typename Turns>
  Cone_move cheapest_move(const Turns& turns)
  {
    m_candidates.clear();
    const double length = std::sqrt(2 * strip_energy());
    for (const int a : m_cones) {
      const std::vector<int>& others = m_pairs_are_all ? m_cones : m_partners[a];
      for (const int b : others)
        if (m_signature.quarter_turns[b] != regular)
          add_candidate(a, b, turns, length);
      m_progress.go_on_after(others.size());
    }
    return cheapest_candidate();
  }

  // Of those that bring the number of a cone nearer to the usual range, and no other one out of it.
  Cone_move cheapest_split()
  {
    const auto is_usual = [](const int k) { return usual_range.first <= k && k <= usual_range.second; };
    m_candidates.clear();
    const double length = std::sqrt(2 * strip_energy());
    for (const int a : m_cones) {
      if (is_usual(m_signature.quarter_turns[a]))
        continue;
      m_progress.go_on_after(m_potential.size());
      for (int b = 0; b < static_cast<int>(m_potential.size()); ++b)
        add_candidate(
            a, b,
            [&](const int from, const int to) {
              const int k_a = m_signature.quarter_turns[from], k_b = m_signature.quarter_turns[to];
              const int turns = k_a < usual_range.first ? -1 : 1;
              return is_usual(k_b + turns) || (k_a == 1 && k_b == 3) ? turns : 0;
            },
            length);
    }
    return cheapest_candidate();
  }

  // \param length |y|
  template <typename Turns>
  void add_candidate(const int a, const int b, const Turns& turns, const double length)
  {
    if (a == b || m_signature.component[a] != m_signature.component[b])
      return;
    Cone_move move{a, b, turns(a, b), 0.};
    if (move.quarter_turns == 0)
      return;
    move.energy_change = cone_energy_change(move) + least_strip_energy_change(move, length);
    m_candidates.push_back(move);
  }

  // It is null, too, if the progress is interrupted.
  Cone_move cheapest_candidate()
  {
    const std::size_t work = 10 + m_period.size();
    std::make_heap(m_candidates.begin(), m_candidates.end(), is_later);
    Cone_move cheapest;
    while (!m_candidates.empty() &&
           (cheapest.is_null() || m_candidates.front().energy_change <= cheapest.energy_change)) {
      std::pop_heap(m_candidates.begin(), m_candidates.end(), is_later);
      if (!m_progress.go_on_after(work))
        return Cone_move();
      Cone_move move = m_candidates.back();
      m_candidates.pop_back();
      move.energy_change = cone_energy_change(move) + strip_energy_change(move);
      if (cheapest.is_null() || is_later(cheapest, move))
        cheapest = move;
    }
    return cheapest;
  }

  // What merging a into b moves; 0 where it would leave a number of quarter turns out of a range.
  int merged_turns(const int a, const int b, const Range& range) const
  {
    const int turns = m_signature.quarter_turns[a] - regular;
    const int k = m_signature.quarter_turns[b] + turns;
    return range.first <= k && k <= range.second ? turns : 0;
  }

  // Of the merges that leave numbers of quarter turns in a range.
  Cone_move cheapest_merge(const Range& range)
  {
    return cheapest_move([&](const int a, const int b) { return merged_turns(a, b, range); });
  }

  // The cheapest one of those whose component allows its price; it is null where there is none.
  Cone_move cheapest_affordable_merge(const std::vector<double>& limit_of_component)
  {
    const auto limit = [&](const int cone) { return limit_of_component[m_signature.component[cone]]; };
    double refused = -std::numeric_limits<double>::infinity();
    for (;;) {
      const Cone_move move = cheapest_move(
          [&](const int a, const int b) { return limit(a) > refused ? merged_turns(a, b, usual_range) : 0; });
      if (move.is_null() || move.energy_change <= limit(move.from))
        return move;
      refused = limit(move.from); // nothing is cheap enough for components of the same limit or a lower one
    }
  }

  // As long as a component has more cones than it needs (three on a sphere, none on a torus, one else), two of them can
  // be merged to one with a positive number of quarter turns: otherwise the sum of 4 - k over each pair would be four
  // or more. Over all pairs this is n - 1 times the sum over all cones, which is at most eight: only four cones of k =
  // 2 on a sphere are left as an exception. A quarter turn from one to another of them makes merges possible.
  Cone_move demanded_move()
  {
    constexpr int any = (std::numeric_limits<int>::max)();
    for (const Range& range : {usual_range, Range(2, any), Range(1, any)}) {
      const Cone_move merge = cheapest_merge(range);
      if (!merge.is_null())
        return merge;
    }
    const auto& k = m_signature.quarter_turns;
    return cheapest_move([&k](const int a, const int b) { return k[a] == 2 && k[b] == 2 ? -1 : 0; });
  }

  void apply(const Cone_move& move)
  {
    m_moves.push_back(move);
    const double t = move.quarter_turns * quarter_turn;
    if (!m_period.empty()) {
      const Direction& d = direction((std::min)(move.from, move.to), (std::max)(move.from, move.to));
      const std::vector<int> crossings = m_paths.crossings(move.from, move.to);
      for (std::size_t l = 0; l < m_period.size(); ++l) {
        m_period[l] += directed_curvature(move) * d.change[l];
        m_signature.strip_quarter_turns[l] -= move.quarter_turns * crossings[l];
      }
    }
    m_signature.quarter_turns[move.from] -= move.quarter_turns;
    m_signature.quarter_turns[move.to] += move.quarter_turns;
    CGAL_assertion(m_signature.quarter_turns[move.to] >= 1);
    m_total += move.energy_change;
    m_cones.clear();
    for (int i = 0; i < static_cast<int>(m_potential.size()); ++i)
      if (m_signature.quarter_turns[i] != regular)
        m_cones.push_back(i);
    for (int i = 0; i < static_cast<int>(m_potential.size()); ++i)
      m_potential[i] += t * (m_energy.interaction(i, move.from) - m_energy.interaction(i, move.to));
  }

  const ScaleEnergy& m_energy;
  Paths& m_paths;
  Progress& m_progress;
  Cones_and_strips m_signature;
  std::vector<double> m_potential; // per cone: u
  std::vector<double> m_period;    // per strip: y
  std::map<std::pair<int, int>, Direction> m_directions;
  std::vector<std::vector<int>> m_partners; // per cone, unless all pairs are tried
  int m_number_of_partners = 0;
  bool m_pairs_are_all = true;
  std::vector<int> m_cones; // those that are not regular, by increasing index
  std::vector<Cone_move> m_candidates;
  std::vector<Cone_move> m_merges, m_moves;
  double m_total = 0;
};

} // namespace internal
} // namespace T_splines
} // namespace CGAL

#endif // CGAL_T_SPLINES_CROSS_FIELD_INTERNAL_CONE_REDUCTION_H
