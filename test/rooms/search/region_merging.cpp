// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "test_meshes.h"
#include "tree_of_hierarchy.h"

#include <CGAL/Spectral_segmentation/internal/search/Merge_tree.h>
#include <CGAL/Spectral_segmentation/internal/search/best_cut.h>
#include <CGAL/Spectral_segmentation/internal/search/recursion.h>
#include <CGAL/Spectral_segmentation/internal/search/region_merging.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(region_merging)

namespace tt = boost::test_tools;
using namespace test_meshes;
namespace internal = CGAL::Spectral_segmentation::internal;
using CGAL::Spectral_segmentation::Calibrated_part_salience;
using CGAL::Spectral_segmentation::Salience_factors;
using internal::Cut_hierarchy;
using internal::Cut_node;
using internal::Cut_state;
using internal::Evaluation_context;
using CGAL::Spectral_segmentation::Part_salience;
using internal::quantized;

namespace {

typedef std::set<Index> Faces;

Surface graph_of(const Soup& soup)
{ return graph_with_distances(soup, weights_of_calibrated_method); }

// Divides each component at random into connected regions, which grow from random faces.
Cut_hierarchy random_regions(const Surface& graph, std::size_t number, Random& random)
{
  const std::size_t n = graph.number_of_faces(), components = graph.components.number;
  Cut_hierarchy result = uncut_hierarchy(graph);
  const std::vector<Index> component = result.leaf;
  std::vector<Index> region(n, internal::null_index);
  std::set<std::size_t> has_region;
  Index next = 0;
  for (std::size_t f = 0; f < n; ++f) // each component has one
    if (has_region.insert(component[f]).second)
      region[f] = next++;
  for (Index f; next < number;)
    if (region[f = Index(random() % n)] == internal::null_index)
      region[f] = next++;
  while (std::count(region.begin(), region.end(), internal::null_index) > 0) {
    const Index h = Index(random() % (3 * n));
    Index& other = region[graph.neighbor(h)];
    if (other == internal::null_index)
      other = region[h / 3];
  }
  // The nodes of the regions, in an order of their own.
  std::vector<Index> node(next);
  for (Index i = 0; i < next; ++i)
    node[i] = Index(components) + i;
  std::shuffle(node.begin(), node.end(), random);
  result.nodes.resize(components + next);
  for (std::size_t f = 0; f < n; ++f)
    result.leaf[f] = node[region[f]];
  return result;
}

// Merges like the method, but with sets and from scratch in each step.
struct Naive_merging
{
  struct Merge
  {
    Faces first, second;
    double salience; // the salience of the cut between them
    Salience_factors factors;
  };

  std::vector<Merge> merges;
  std::vector<Faces> regions; // in the order of their first faces; in the end the components

  // Takes the salience in whose order regions are merged, and the salience of the cuts.
  Naive_merging(const Surface& graph, const Cut_hierarchy& start, const Part_salience& in_merging,
                const Part_salience& part_salience)
  {
    const Evaluation_context context(graph);
    std::map<Index, Faces> by_leaf;
    for (Index f = 0; f < graph.number_of_faces(); ++f)
      by_leaf[start.leaf[f]].insert(f);
    for (const auto& [leaf, faces] : by_leaf)
      regions.push_back(faces);
    sort();
    for (;;) {
      std::optional<Merge> best;
      std::size_t place[2] = {0, 0};
      for (std::size_t i = 0; i < regions.size(); ++i)
        for (std::size_t j = i + 1; j < regions.size(); ++j) {
          if (!are_neighbors(graph, regions[i], regions[j]))
            continue;
          int common = 0, of_first = 0, of_second = 0;
          for (std::size_t k = 0; k < regions.size(); ++k)
            if (k != i && k != j) {
              const bool touches_first = are_neighbors(graph, regions[k], regions[i]);
              const bool touches_second = are_neighbors(graph, regions[k], regions[j]);
              common += touches_first && touches_second;
              of_first += touches_first;
              of_second += touches_second;
            }
          const Merge merge = evaluated(graph, context, regions[i], regions[j], common,
                                        std::min(of_first, of_second), in_merging);
          if (!best || quantized(merge.salience) < quantized(best->salience)) {
            best = merge;
            place[0] = i;
            place[1] = j;
          }
        }
      if (!best)
        return;
      best->salience = part_salience(best->factors);
      merges.push_back(*best);
      regions[place[0]].insert(best->second.begin(), best->second.end());
      regions.erase(regions.begin() + std::ptrdiff_t(place[1]));
      sort();
    }
  }

private:
  void sort()
  {
    std::sort(regions.begin(), regions.end(), [](const Faces& a, const Faces& b)
              { return *a.begin() < *b.begin(); });
  }

  static bool are_neighbors(const Surface& graph, const Faces& a, const Faces& b)
  {
    for (Index f : a)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (b.count(graph.neighbor(h)) > 0)
          return true;
    return false;
  }

  static double area(const Surface& graph, const Faces& faces)
  {
    double sum = 0;
    for (Index f : faces)
      sum += graph.areas[f];
    return sum;
  }

  static Merge evaluated(const Surface& graph, const Evaluation_context& context,
                         const Faces& first, const Faces& second,
                         double number_of_common_neighbors, double number_of_other_neighbors,
                         const Part_salience& part_salience)
  {
    Faces both = first;
    both.insert(second.begin(), second.end());
    const std::vector<Index> faces(both.begin(), both.end());
    const bool first_is_smaller = area(graph, first) <= area(graph, second);
    internal::Sides side;
    for (Index f : faces)
      side.push_back((first.count(f) > 0) == first_is_smaller ? 0 : 1);
    const Surface part = internal::Part_extractor(graph)(faces);
    Salience_factors factors = internal::Cut_evaluator(part, faces, context)(side, true);
    factors.number_of_common_neighbors = number_of_common_neighbors;
    factors.number_of_other_neighbors = number_of_other_neighbors;
    return {first, second, part_salience(factors), factors};
  }
};

Cut_hierarchy merged(const Surface& graph, const Cut_hierarchy& regions,
                     const Part_salience& part_salience)
{
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  const Evaluation_context context(graph);
  return internal::hierarchy_of(
    internal::Region_merging(sequential, graph, context, part_salience, monitor)(regions.leaf));
}

Faces faces_of(const Cut_hierarchy& hierarchy, std::size_t node)
{
  const internal::Nested_ranges ranges(hierarchy);
  return Faces(ranges[node].begin(), ranges[node].end());
}

double area_of(const Surface& graph, const Faces& faces)
{
  double sum = 0;
  for (Index f : faces)
    sum += graph.areas[f];
  return sum;
}

void check_hierarchy(const Surface& graph, const Cut_hierarchy& regions,
                     const Cut_hierarchy& result)
{
  BOOST_TEST(!result.is_monotonic);
  BOOST_TEST(result.has_all_cuts);
  BOOST_TEST(result.number_of_roots == regions.number_of_roots);
  BOOST_TEST_REQUIRE(result.leaf.size() == regions.leaf.size());

  // Its leaves are the regions.
  std::map<Index, Index> region_of_leaf, leaf_of_region;
  for (std::size_t f = 0; f < result.leaf.size(); ++f) {
    BOOST_TEST(result.nodes[result.leaf[f]].is_leaf());
    BOOST_TEST(region_of_leaf.emplace(result.leaf[f], regions.leaf[f]).first->second ==
               regions.leaf[f]);
    BOOST_TEST(leaf_of_region.emplace(regions.leaf[f], result.leaf[f]).first->second ==
               result.leaf[f]);
  }
  BOOST_TEST(result.number_of_segments() == leaf_of_region.size());

  // Cuts are decided on in the order of their children.
  BOOST_TEST_REQUIRE(result.cut_order.size() ==
                     (result.nodes.size() - result.number_of_roots) / 2);
  for (std::size_t i = 0; i < result.cut_order.size(); ++i) {
    const Cut_node& n = result.nodes[result.cut_order[i]];
    BOOST_TEST(n.children[0] == result.number_of_roots + 2 * i);
  }
  for (std::size_t i = 0; i < result.nodes.size(); ++i) {
    const Cut_node& n = result.nodes[i];
    BOOST_TEST((n.cut_state == (n.is_leaf() ? Cut_state::NO_CUT : Cut_state::CUT)));
    BOOST_TEST(n.area == area_of(graph, faces_of(result, i)), tt::tolerance(1e-9));
    if (!n.is_leaf())
      BOOST_TEST(result.nodes[n.children[0]].area <= result.nodes[n.children[1]].area);
  }
}

std::vector<Soup> shapes(Random& random)
{
  return {displaced(dumbbell(10, 8), 0.02, random), displaced(torus(2, 0.7, 12, 7), 0.05, random),
          plate(9, 6), disjoint_union(sphere(1), disjoint_union(plate(5, 4), sphere(0))), pillow()};
}

// Returns the same salience for many boundaries.
double coarse_salience(const Salience_factors& factors)
{
  return std::round(4 * factors.size + 4 * factors.concavity_near_cut +
                    factors.number_of_common_neighbors + factors.number_of_other_neighbors) / 4;
}

} // namespace

BOOST_AUTO_TEST_CASE(merges_equal_merges_of_sets_that_are_evaluated_anew_in_each_step)
{
  const Calibrated_part_salience calibrated;
  const std::pair<Part_salience, Part_salience> saliences[] = {
    {[=](const Salience_factors& f) { return calibrated.in_merging(f); }, calibrated},
    {coarse_salience, coarse_salience}};
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (const auto& [in_merging, part_salience] : saliences) {
      BOOST_TEST_CONTEXT("seed " << seed) {
        Random random(seed);
        const std::vector<Soup> soups = shapes(random);
        const Surface graph = graph_of(soups[seed % soups.size()]);
        const Cut_hierarchy regions = random_regions(
          graph, std::min<std::size_t>(2 + random() % 7, graph.number_of_faces()), random);
        const Naive_merging expected(graph, regions, in_merging, part_salience);
        const Cut_hierarchy result = merged(graph, regions, part_salience);
        check_hierarchy(graph, regions, result);

        const std::size_t n = expected.merges.size();
        BOOST_TEST_REQUIRE(result.cut_order.size() == n);
        for (std::size_t i = 0; i < n; ++i) { // the i-th cut is the last but i merge
          const Naive_merging::Merge& merge = expected.merges[n - 1 - i];
          const Cut_node& cut = result.nodes[result.cut_order[i]];
          const Faces sides[] = {faces_of(result, cut.children[0]),
                                 faces_of(result, cut.children[1])};
          BOOST_TEST(((sides[0] == merge.first && sides[1] == merge.second) ||
                      (sides[1] == merge.first && sides[0] == merge.second)));
          BOOST_TEST(cut.salience == merge.salience, tt::tolerance(1e-9));
          BOOST_TEST(cut.factors.is_boundary);
          for (const auto& [name, value] : CGAL::Spectral_segmentation::named_factors)
            BOOST_TEST_CONTEXT(name)
              BOOST_TEST(std::abs(cut.factors.*value - merge.factors.*value) < 1e-9);
        }
        BOOST_TEST_REQUIRE(result.number_of_roots == expected.regions.size());
        for (std::size_t root = 0; root < result.number_of_roots; ++root)
          BOOST_TEST((faces_of(result, root) == expected.regions[root]));
      }
    }
}

BOOST_AUTO_TEST_CASE(one_region_for_each_component_needs_no_merge)
{
  Random random(4);
  const Surface graph = graph_of(disjoint_union(sphere(0), plate(3, 2)));
  const Cut_hierarchy regions = random_regions(graph, 2, random);
  const Cut_hierarchy result =
    merged(graph, regions, Calibrated_part_salience());
  BOOST_TEST(result.nodes.size() == 2u);
  BOOST_TEST(result.cut_order.empty());
  check_hierarchy(graph, regions, result);
}

BOOST_AUTO_TEST_CASE(a_salience_that_is_no_number_counts_as_the_least)
{
  Random random(5);
  const Surface graph = graph_of(dumbbell(10, 8));
  const Cut_hierarchy regions = random_regions(graph, 6, random);
  const Cut_hierarchy result = merged(
    graph, regions,
    [](const Salience_factors& f) { return f.size < 0.3 ? std::sqrt(-1.) : f.size; });
  check_hierarchy(graph, regions, result);
  BOOST_TEST(result.nodes[result.cut_order.back()].salience ==
             -std::numeric_limits<double>::infinity());
}

// The whole search of the calibrated method on a small mesh.
BOOST_AUTO_TEST_CASE(regions_of_an_over_segmentation_become_the_bodies_of_a_chain)
{
  // Three balls in a row.
  std::vector<std::pair<double, double> > profile = {{-1, 0}};
  for (int ball = 0; ball < 3; ++ball)
    for (int i = 1; i <= 8; ++i) {
      const double z = -1 + 0.25 * i;
      profile.emplace_back(2 * ball + z, i == 8 ? (ball == 2 ? 0 : 0.3)
                                                : std::sqrt(1.05 - z * z));
    }
  const Surface graph = graph_of(surface_of_revolution(profile, 16));
  const CGAL::Spectral_segmentation::Options options;
  internal::Run_control control;
  internal::Run_monitor monitor(control);
  const internal::Calibrated_cut best_cut(graph, options);
  const Cut_hierarchy regions = internal::hierarchy_of(
    internal::Recursion(sequential, graph, best_cut, options, monitor).by_salience(8));
  BOOST_TEST(regions.number_of_segments() == 8u);
  const Cut_hierarchy result = internal::hierarchy_of(internal::Region_merging(
    sequential, graph, best_cut.context(), options.part_salience, monitor)(regions.leaf));
  check_hierarchy(graph, regions, result);
  // The first two cuts are the necks.
  std::set<int> balls;
  for (std::size_t i = 1; i < 5; ++i) {
    const Cut_node& n = result.nodes[i];
    if (!n.is_leaf() && n.children[0] < 5)
      continue;
    std::set<int> balls_of_node;
    const double smallest = graph.centroid(0).z(), largest =
      graph.centroid(Index(graph.number_of_faces() - 1)).z();
    for (Index f : faces_of(result, i))
      balls_of_node.insert(int(std::floor(3 * (graph.centroid(f).z() - smallest) /
                                          (largest - smallest) * (1 - 1e-9))));
    BOOST_TEST(balls_of_node.size() == 1u);
    balls.insert(balls_of_node.begin(), balls_of_node.end());
  }
  BOOST_TEST(balls == std::set<int>({0, 1, 2}), tt::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
