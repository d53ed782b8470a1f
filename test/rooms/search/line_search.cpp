// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/Part_salience.h>
#include <CGAL/Spectral_segmentation/internal/search/face_orders.h>
#include <CGAL/Spectral_segmentation/internal/search/line_search.h>
#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>
#include <CGAL/Spectral_segmentation/internal/weights/shortest_paths.h>


#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(line_search)

namespace tt = boost::test_tools;
namespace internal = CGAL::Spectral_segmentation::internal;
using namespace test_meshes;
using CGAL::Spectral_segmentation::Salience_factors;
using CGAL::Spectral_segmentation::Weighted_part_salience;
using CGAL::Spectral_segmentation::internal::Cut;
using CGAL::Spectral_segmentation::internal::Growth;
using CGAL::Spectral_segmentation::internal::Vector;
using CGAL::Spectral_segmentation::internal::grow_along;
using CGAL::Spectral_segmentation::internal::Edge_weights;
using CGAL::Spectral_segmentation::internal::Execution;
using CGAL::Spectral_segmentation::internal::quantized;
using CGAL::Spectral_segmentation::internal::rest_is_connected;
using CGAL::Spectral_segmentation::internal::shortest_paths;
using CGAL::Spectral_segmentation::internal::spectral_order;
using CGAL::Spectral_segmentation::internal::total_area;

namespace {

typedef std::set<Index> Faces;

// The line search of Sections 5.3 and 6 with sets: all is computed anew at each visited face.
class Search_by_sets
{
  struct Edge
  {
    Faces faces;
    double angle, concavity;
  };

  const Surface& part_;
  std::map<std::pair<Index, Index>, Edge> edges_; // inner ones, by their vertices
  std::map<Index, Faces> neighbors_;
  double largest_angle_ = 0;

  double area(const Faces& faces) const
  {
    double sum = 0;
    for (Index f : faces) {
      const auto& c = part_.corners[f];
      const Vector u = part_.points[c[1]] - part_.points[c[0]];
      const Vector v = part_.points[c[2]] - part_.points[c[0]];
      sum += u.cross(v).norm() / 2;
    }
    return sum;
  }

  Faces component(const Faces& faces, Index first) const
  {
    Faces found = {first};
    std::vector<Index> stack = {first};
    while (!stack.empty()) {
      const Index f = stack.back();
      stack.pop_back();
      for (Index g : neighbors_.at(f))
        if (faces.count(g) && found.insert(g).second)
          stack.push_back(g);
    }
    return found;
  }

public:
  struct Step
  {
    Faces q;
    double smaller_area;
    double size;
    double cut_strength;
    double base; // the product of the two largest eigenvalues
  };

  explicit Search_by_sets(const Surface& part) : part_(part)
  {
    for (Index h = 0; h < part.number_of_halfedges(); ++h) {
      Edge& e = edges_[std::minmax(part.source_vertex(h), part.target_vertex(h))];
      e.faces.insert(h / 3);
      e.angle = part.weights[h].angle;
      e.concavity = part.weights[h].concavity;
    }
    for (Index f = 0; f < part.number_of_faces(); ++f)
      neighbors_[f];
    for (auto edge = edges_.begin(); edge != edges_.end();) {
      const Edge& e = edge->second;
      if (e.faces.size() == 1) {
        edge = edges_.erase(edge);
        continue;
      }
      BOOST_REQUIRE(e.faces.size() == 2u);
      const Index f = *e.faces.begin(), g = *e.faces.rbegin();
      neighbors_[f].insert(g);
      neighbors_[g].insert(f);
      largest_angle_ = std::max(largest_angle_, e.angle);
      ++edge;
    }
  }

  // The cut between q and the rest.
  Step cut(const Faces& q, const Faces& rest) const
  {
    Step step;
    step.q = q;
    step.smaller_area = std::min(area(q), area(rest));
    step.size = step.smaller_area / (area(q) + area(rest));
    double strength = 0, number_of_edges = 0;
    std::set<Index> vertices;
    for (const auto& [ends, edge] : edges_)
      if (q.count(*edge.faces.begin()) != q.count(*edge.faces.rbegin())) {
        ++number_of_edges;
        strength += edge.concavity / largest_angle_;
        vertices.insert({ends.first, ends.second});
      }
    step.cut_strength = strength / number_of_edges;
    Vector mean;
    for (Index v : vertices)
      mean += part_.points[v] / static_cast<double>(vertices.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (Index v : vertices) {
      const Vector from_mean = part_.points[v] - mean;
      const Eigen::Vector3d d(from_mean.x(), from_mean.y(), from_mean.z());
      covariance += d * d.transpose() / static_cast<double>(vertices.size());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
    step.base = solver.eigenvalues()[1] * solver.eigenvalues()[2];
    return step;
  }

  // The cuts to compare: after each visited face that joins the patch of the first one.
  std::vector<Step> steps(const std::vector<Index>& line, double minimum_area) const
  {
    std::vector<Step> result;
    Faces visited, all(line.begin(), line.end());
    for (Index f : line) {
      visited.insert(f);
      const Faces q = component(visited, line.front());
      if (!q.count(f))
        continue;
      Faces rest;
      std::set_difference(all.begin(), all.end(), q.begin(), q.end(),
                          std::inserter(rest, rest.end()));
      if (rest.empty() || component(rest, *rest.begin()) != rest)
        continue;
      const Step step = cut(q, rest);
      if (step.smaller_area >= minimum_area)
        result.push_back(step);
    }
    return result;
  }
};

Salience_factors factors_of(const Search_by_sets::Step& step)
{
  Salience_factors factors;
  factors.size = step.size;
  factors.cut_strength = step.cut_strength;
  factors.protrusiveness = 1 - 4 * std::sqrt(std::max(step.base, 0.)) / step.smaller_area;
  return factors;
}

// Compares every step and the chosen cut; returns the number of compared cuts.
std::size_t compare_with_sets(const Surface& part, const std::vector<Index>& line,
                              const Weighted_part_salience& part_salience, double minimum_area)
{
  std::vector<Salience_factors> observed;
  const auto observing_salience = [&](const Salience_factors& factors) {
    observed.push_back(factors);
    return part_salience(factors);
  };
  const std::optional<Cut> cut =
    internal::line_search(sequential, part, line, observing_salience, minimum_area);
  const std::vector<Search_by_sets::Step> expected = Search_by_sets(part).steps(line, minimum_area);

  BOOST_REQUIRE(observed.size() == expected.size());
  // The second half is swept from the other end.
  const auto is_of_first_half = [&](const Search_by_sets::Step& step)
  { return 2 * step.q.size() <= part.number_of_faces(); };
  std::reverse(observed.begin() + std::count_if(expected.begin(), expected.end(),
                                                is_of_first_half), observed.end());
  BOOST_REQUIRE(cut.has_value() == !expected.empty());
  std::size_t best = 0;
  double largest = 0; // salience, by the search with sets
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Search_by_sets::Step& step = expected[i];
    const Salience_factors& factors = observed[i];
    BOOST_TEST(std::abs(factors.size - step.size) < 1e-12);
    BOOST_TEST(std::abs(factors.cut_strength - step.cut_strength) < 1e-12);
    // Before the root is taken, which near 0 doubles the digits that rounding costs.
    const double base = std::pow((1 - factors.protrusiveness) * step.smaller_area / 4, 2);
    BOOST_TEST(std::abs(base - step.base) < 1e-13);
    if (quantized(part_salience(factors)) > quantized(part_salience(observed[best])))
      best = i;
    const double salience = part_salience(factors_of(step));
    largest = i == 0 ? salience : std::max(largest, salience);
  }
  if (!cut)
    return 0;

  BOOST_TEST((cut->side == internal::line_search(
    Execution::PARALLEL, part, line, part_salience, minimum_area)->side));
  BOOST_TEST(cut->salience == part_salience(observed[best]));
  BOOST_TEST(cut->salience > largest - 1e-5 * std::max(1., std::abs(largest)));
  BOOST_TEST(cut->factors.size == observed[best].size);
  BOOST_TEST(cut->factors.cut_strength == observed[best].cut_strength);
  BOOST_TEST(cut->factors.protrusiveness == observed[best].protrusiveness);
  BOOST_TEST(cut->area[0] <= cut->area[1]);
  const char side_of_q = cut->side[line.front()];
  double area[2] = {0, 0};
  for (Index f = 0; f < part.number_of_faces(); ++f) {
    BOOST_TEST(expected[best].q.count(f) == (cut->side[f] == side_of_q));
    area[int(cut->side[f])] += part.areas[f];
  }
  for (int side : {0, 1})
    BOOST_TEST(cut->area[side] == area[side], tt::tolerance(1e-9));
  return observed.size();
}

std::vector<Index> random_line(const Surface& part, Random& random)
{
  std::vector<Index> line(part.number_of_faces());
  std::iota(line.begin(), line.end(), Index(0));
  std::shuffle(line.begin(), line.end(), random);
  return line;
}

std::vector<Index> line_between(const Surface& part, Index s, Index t)
{
  return spectral_order(shortest_paths(part, &Edge_weights::combined, s),
                        shortest_paths(part, &Edge_weights::combined, t));
}

// A spectral line, of which some faces are visited at another time.
std::vector<Index> disturbed_line(const Surface& part, Random& random)
{
  const std::size_t n = part.number_of_faces();
  std::vector<Index> line = line_between(part, Index(random() % n), Index(random() % n));
  for (std::size_t i = 0; i < n / 5; ++i)
    std::swap(line[random() % n], line[random() % n]);
  return line;
}

void compare_on_random_meshes(unsigned number, const std::vector<Soup>& shapes, bool is_cut_out)
{
  std::size_t compared = 0;
  for (unsigned seed = 1; seed <= number; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed) {
      Random random(seed);
      Surface part =
        graph_with_distances(displaced(shapes[seed % shapes.size()], 0.25, random));
      if (is_cut_out)
        part = random_part(part, 2 + random() % part.number_of_faces(), random);
      const std::size_t n = part.number_of_faces();
      const Weighted_part_salience weights[] = {{0.1, 0.6, 0.3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
      const double minimum_area = total_area(part) * (seed % 3) * 0.0371;
      for (const std::vector<Index>& line :
           {random_line(part, random), disturbed_line(part, random),
            line_between(part, Index(random() % n), Index(random() % n))})
        compared += compare_with_sets(part, line, weights[seed % 4], minimum_area);
    }
  BOOST_TEST(compared > 10 * number);
}

} // namespace

BOOST_AUTO_TEST_CASE(it_agrees_with_sets_on_closed_meshes)
{
  compare_on_random_meshes(
    60, {sphere(0), sphere(1), dumbbell(5, 4), surface_of_revolution({{-1, 0}, {0, 1}, {1, 0}}, 9)},
    false);
}

BOOST_AUTO_TEST_CASE(it_agrees_with_sets_on_meshes_with_border)
{
  compare_on_random_meshes(
    60, {plate(6, 5), plate(12, 1), surface_of_revolution({{0, 1}, {1, 2}, {2, 1}, {3, 1}}, 8)},
    false);
  compare_on_random_meshes(
    120, {plate(7, 7), sphere(1), torus(2, 0.7, 7, 6), dumbbell(6, 5)}, true);
}

BOOST_AUTO_TEST_CASE(it_agrees_with_sets_on_meshes_of_genus_1)
{
  compare_on_random_meshes(
    60, {torus(2, 0.7, 3, 3), torus(2, 0.7, 5, 4), torus(2, 0.7, 8, 8), torus(3, 0.5, 20, 3)},
    false);
}

BOOST_AUTO_TEST_CASE(it_agrees_with_sets_on_meshes_of_genus_2)
{
  const std::vector<Soup> shapes = {
    connected_sum(torus(2, 0.7, 4, 4), torus(2, 1, 5, 4)),
    connected_sum(connected_sum(sphere(1), torus(2, 0.7, 3, 3)), torus(1, 0.4, 5, 3))};
  for (const Soup& shape : shapes) {
    const Mesh mesh = mesh_of(shape);
    const auto euler = int(num_vertices(mesh)) - int(num_edges(mesh)) + int(num_faces(mesh));
    BOOST_REQUIRE(euler == 2 - 2 * 2);
  }
  compare_on_random_meshes(60, shapes, false);
}

BOOST_AUTO_TEST_CASE(faces_that_do_not_touch_the_patch_wait)
{
  // A strip of six faces, 0 to 5 in this order.
  const Surface strip = surface_of(
    {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0), Point(0, 2, 0),
      Point(1, 2, 0), Point(0, 3, 0), Point(1, 3, 0)},
     {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}, {4, 5, 6}, {6, 5, 7}}});
  const Growth growth = grow_along(strip, {0, 3, 5, 2, 1, 4});
  BOOST_TEST(growth.faces == std::vector<Index>({0, 1, 2, 3, 4, 5}), tt::per_element());
  BOOST_TEST(growth.sizes == std::vector<Index>({1, 4, 6}), tt::per_element());
  const Growth from_the_middle = grow_along(strip, {2, 0, 3, 1, 5, 4});
  BOOST_TEST(from_the_middle.faces == std::vector<Index>({2, 3, 1, 0, 4, 5}), tt::per_element());
  BOOST_TEST(from_the_middle.sizes == std::vector<Index>({1, 2, 4, 6}), tt::per_element());
  BOOST_TEST(rest_is_connected(strip, from_the_middle.faces) ==
             std::vector<bool>({true, false, false, false, true, true, false}),
             tt::per_element());
}

BOOST_AUTO_TEST_CASE(a_patch_that_is_closed_around_a_hole_is_no_cut)
{
  // Face by face, but 24 in the middle last; its neighbors are 15, 25 and 27.
  const Surface part = graph_with_distances(plate(5, 5));
  std::vector<Index> line(50);
  std::iota(line.begin(), line.end(), Index(0));
  line.erase(line.begin() + 24);
  line.push_back(24);
  const std::vector<Index> sizes = internal::sizes_of_cuts(part, grow_along(part, line));
  BOOST_REQUIRE(sizes.size() > 2u);
  BOOST_TEST(sizes[sizes.size() - 2] == 26u); // without 27, that is
  BOOST_TEST(sizes.back() == 49u);
}

BOOST_AUTO_TEST_CASE(the_first_of_equally_salient_cuts_is_taken)
{
  const Surface part = graph_with_distances(plate(5, 4));
  std::vector<Index> line(40);
  std::iota(line.begin(), line.end(), Index(0));
  const std::vector<Index> sizes = internal::sizes_of_cuts(part, grow_along(part, line));
  const auto first = std::find_if(sizes.begin(), sizes.end(), [](Index size) { return size >= 4; });
  const std::optional<Cut> cut = internal::line_search(
    sequential, part, line, [](const Salience_factors&) { return 0.5; },
    0.1 * (1 - 1e-9) * total_area(part));
  BOOST_REQUIRE(cut.has_value());
  BOOST_TEST(std::count(cut->side.begin(), cut->side.end(), 0) == *first);
}

BOOST_AUTO_TEST_CASE(the_side_of_smaller_area_is_side_0_whichever_end_the_line_starts_at)
{
  const Surface part = graph_with_distances(dumbbell(8, 6));
  const Index last = static_cast<Index>(part.number_of_faces() - 1);
  for (const auto& [s, t] : {std::pair(Index(0), last), std::pair(last, Index(0))}) {
    const std::optional<Cut> cut = internal::line_search(sequential, part, line_between(part, s, t),
                                                         Weighted_part_salience(), 0);
    BOOST_REQUIRE(cut.has_value());
    double area[2] = {0, 0};
    for (Index f = 0; f <= last; ++f)
      area[int(cut->side[f])] += part.areas[f];
    BOOST_TEST(area[0] <= area[1] * (1 + 1e-12));
    BOOST_TEST(cut->side[s] != cut->side[t]);
  }
}

BOOST_AUTO_TEST_CASE(a_part_without_a_cut_has_none)
{
  Random random(1);
  const Surface face = random_part(graph_with_distances(sphere(0)), 1, random);
  BOOST_TEST(
    !internal::line_search(sequential, face, {0}, Weighted_part_salience(), 0).has_value());
  const Surface part = graph_with_distances(sphere(1));
  BOOST_TEST(!internal::line_search(sequential, part, random_line(part, random),
                                    Weighted_part_salience(), 0.51 * total_area(part))
                .has_value());
}

BOOST_AUTO_TEST_SUITE_END()
