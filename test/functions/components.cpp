// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

// Meshes of several components, soups, and a number of segments that is met exactly.
BOOST_AUTO_TEST_SUITE(components)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using CGAL::Spectral_segmentation::unlimited;

namespace {

const double infinity = std::numeric_limits<double>::infinity();

template <class NamedParameters>
Labels labels_of_soup(const Soup& soup, const NamedParameters& np)
{
  Labels labels(soup.triangles.size(), untouched);
  const std::size_t n =
    CGAL::segment_spectral_recursive(soup.points, soup.triangles, labels.data(), np);
  BOOST_TEST(n == number_of(labels));
  check_numbering(labels);
  return labels;
}

Labels labels_of_soup(const Soup& soup)
{ return labels_of_soup(soup, parameters::default_values()); }

Soup double_sided(Soup soup)
{
  const std::size_t n = soup.triangles.size();
  for (std::size_t f = 0; f < n; ++f) {
    const auto t = soup.triangles[f];
    soup.triangles.push_back({t[2], t[1], t[0]});
  }
  return soup;
}

Labels first_labels(const Labels& labels, std::size_t n)
{ return Labels(labels.begin(), labels.begin() + std::ptrdiff_t(n)); }

Labels first_half(const Labels& labels) { return first_labels(labels, labels.size() / 2); }

Labels second_half(const Labels& labels)
{ return Labels(labels.begin() + std::ptrdiff_t(labels.size() / 2), labels.end()); }

Soup union_of(const std::vector<Soup>& soups)
{
  Soup result;
  for (const Soup& soup : soups)
    result = disjoint_union(result, soup);
  return result;
}

// Soups that no surface is made of.
std::vector<std::pair<const char*, Soup> > adversarial_soups()
{
  std::vector<std::pair<const char*, Soup> > result;
  result.emplace_back("fan", fan_at_edge(300));
  Soup triples; // all triples of some points
  Random random(1);
  for (std::size_t i = 0; i < 12; ++i)
    triples.points.push_back(Point(double(random() % 100), double(random() % 100),
                                   double(random() % 100)));
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        triples.triangles.push_back({i, j, k});
  result.emplace_back("all triples", triples);
  result.emplace_back("spheres in one place", union_of(std::vector<Soup>(20, sphere(1))));
  std::vector<Soup> shells;
  for (int i = 1; i <= 10; ++i)
    shells.push_back(scaled(sphere(1), 0.1 * i));
  result.emplace_back("nested shells", union_of(shells));
  Cells sponge;
  for (int x = 0; x < 9; ++x)
    for (int y = 0; y < 9; ++y)
      for (int z = 0; z < 9; ++z) {
        const auto is_hole = [](int a, int b) {
          return (a % 3 == 1 && b % 3 == 1) || (a / 3 == 1 && b / 3 == 1);
        };
        if (!is_hole(x, y) && !is_hole(y, z) && !is_hole(z, x))
          sponge.insert({x, y, z});
      }
  result.emplace_back("Menger sponge", loose_triangles(boundary_of(sponge)));
  result.emplace_back("needle among spheres",
                      union_of({sphere(2), moved(sphere(2), 1e6, 0, 0),
                                {{Point(0, 0, 0), Point(1e6, 0, 0), Point(0, 1e-9, 0)},
                                 {{0, 1, 2}}}}));
  result.emplace_back("triangles with one centroid",
                      Soup{{Point(-1, -1, 0), Point(1, -1, 0), Point(0, 2, 0), Point(-1, 0, -1),
                            Point(1, 0, -1), Point(0, 0, 2)}, {{0, 1, 2}, {3, 4, 5}}});
  result.emplace_back("specks far away",
                      union_of({dumbbell(16, 12), moved(scaled(sphere(0), 1e-6), 1e5, 0, 0),
                                moved(scaled(sphere(0), 1e-6), 0, 1e5, 1e5)}));
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(loose_triangles_have_the_parts_of_their_surface)
{
  const Soup soup = dumbbell(24, 20);
  const Labels whole = labels_of_soup(soup), loose = labels_of_soup(loose_triangles(soup));
  BOOST_TEST(number_of(whole) >= 2u);
  BOOST_TEST(number_of(loose) == number_of(whole));
  BOOST_TEST(rand_index(whole, loose) > 0.9);
}

BOOST_AUTO_TEST_CASE(a_ball_on_a_ball_is_two_parts_however_its_halves_are_joined)
{
  // Two balls that touch, the second of which comes in eight components.
  Soup soup = sphere(3);
  std::vector<Soup> octants(8);
  const Soup small = moved(scaled(sphere(3), 0.7), 1.6, 0, 0);
  for (std::size_t f = 0; f < small.triangles.size(); ++f) {
    const auto& t = small.triangles[f];
    const Point c = centroid(small, f);
    Soup& octant = octants[(c.x() > 1.6) + 2 * (c.y() > 0) + 4 * (c.z() > 0)];
    octant = disjoint_union(octant, {{small.points[t[0]], small.points[t[1]], small.points[t[2]]},
                                     {{0, 1, 2}}});
  }
  const Labels labels = labels_of_soup(disjoint_union(soup, union_of(octants)));
  BOOST_TEST(number_of(labels) == 2u);
  Labels expected(soup.triangles.size(), 0);
  expected.resize(labels.size(), 1);
  BOOST_TEST(rand_index(labels, expected) > 0.9);
}

BOOST_AUTO_TEST_CASE(a_face_that_is_there_twice_counts_once)
{
  for (const Soup& soup : {dumbbell(24, 20), plate(8, 3)}) {
    const Labels one_sided = labels_of_soup(soup);
    const Labels labels = labels_of_soup(double_sided(soup));
    BOOST_TEST(first_half(labels) == one_sided, boost::test_tools::per_element());
    BOOST_TEST(second_half(labels) == one_sided, boost::test_tools::per_element());
    const Labels of_mesh = labels_of(mesh_of(disjoint_union(soup, turned_inside_out(soup))),
                                     parameters::default_values());
    BOOST_TEST(first_half(of_mesh) == second_half(of_mesh), boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_component_is_a_part_unless_it_is_small)
{
  // A sphere on a sphere has about r^2 of the area.
  const auto number_of_parts = [](double r) {
    return number_of(labels_of_soup(
      disjoint_union(sphere(3), moved(scaled(sphere(3), r), 1 + r, 0, 0))));
  };
  BOOST_TEST(number_of_parts(0.05) == 1u);
  BOOST_TEST(number_of_parts(0.08) == 1u);
  BOOST_TEST(number_of_parts(0.15) == 2u);
  BOOST_TEST(number_of_parts(1) == 2u);
}

BOOST_AUTO_TEST_CASE(a_small_component_belongs_to_the_part_that_it_touches)
{
  // A dumbbell with a bead at each end
  const Soup soup = dumbbell(24, 20);
  double end = 0;
  for (const Point& p : soup.points)
    end = (std::max)(end, p.z());
  const Soup bead = scaled(sphere(1), 0.02 * end);
  const Labels labels =
    labels_of_soup(union_of({soup, moved(bead, 0, 0, end), moved(bead, 0, 0, -end)}));
  const std::size_t n = soup.triangles.size(), m = bead.triangles.size();
  const auto label_at = [&](bool is_top) {
    for (std::size_t f = 0; f < n; ++f)
      for (std::size_t v : soup.triangles[f])
        if (std::abs(soup.points[v].z() - (is_top ? end : -end)) < 1e-6)
          return labels[f];
    return untouched;
  };
  BOOST_TEST(label_at(true) != label_at(false));
  for (std::size_t f = 0; f < m; ++f) {
    BOOST_TEST(labels[n + f] == label_at(true));
    BOOST_TEST(labels[n + m + f] == label_at(false));
  }
}

// Returns the labels of n faces, numbered from the first on.
Labels numbered(const Labels& labels, std::size_t first, std::size_t n)
{
  std::map<std::size_t, std::size_t> number;
  Labels result;
  for (std::size_t f = first; f < first + n; ++f)
    result.push_back(number.emplace(labels[f], number.size()).first->second);
  return result;
}

BOOST_AUTO_TEST_CASE(a_large_component_with_parts_is_cut_like_the_mesh_alone)
{
  const Soup elephant = read("elephant.off"), twin_balls = dumbbell(24, 20);
  double size = 0;
  for (const Point& p : elephant.points)
    size = (std::max)(size, p.x());
  const Soup ball = moved(scaled(sphere(3), size / 2), 3 * size, 0, 0);
  const std::size_t n = elephant.triangles.size(), m = twin_balls.triangles.size();
  const Labels of_elephant = labels_of_soup(elephant);
  BOOST_TEST(number_of(of_elephant) > 5u);
  BOOST_TEST(numbered(labels_of_soup(disjoint_union(elephant, ball)), 0, n) == of_elephant,
             boost::test_tools::per_element());
  BOOST_TEST(numbered(labels_of_soup(disjoint_union(ball, elephant)), ball.triangles.size(), n) ==
               of_elephant, boost::test_tools::per_element());
  for (double distance : {1.9, 9.}) { // touching, and not
    const Labels labels =
      labels_of_soup(disjoint_union(twin_balls, moved(twin_balls, distance, 0, 0)));
    const Labels alone = labels_of_soup(twin_balls);
    BOOST_TEST(number_of(alone) >= 2u);
    BOOST_TEST(number_of(labels) == 2 * number_of(alone));
    BOOST_TEST(numbered(labels, 0, m) == alone, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(a_component_with_little_evidence_of_parts_among_many_is_not_cut)
{
  // The one cut of a dumbbell is too little among 20 dumbbells. It is among the next cuts.
  const Soup soup = dumbbell(24, 20);
  std::vector<Soup> dumbbells;
  for (int i = 0; i < 20; ++i)
    dumbbells.push_back(moved(soup, 9 * i, 0, 0));
  const Mesh mesh = mesh_of(union_of(dumbbells));
  const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, parameters::default_values());
  const Labels labels = run_labels(hierarchy), more = labels_above(hierarchy, 0.1, unlimited);
  BOOST_TEST(number_of(labels) == 20u);
  BOOST_TEST(number_of(more) > 35u);
  for (std::size_t f = 0; f < labels.size(); ++f)
    BOOST_TEST(labels[f] == f / soup.triangles.size());
}

BOOST_AUTO_TEST_CASE(a_closed_component_that_points_inward_has_the_parts_of_the_outward_one)
{
  const Soup soup = dumbbell(24, 20), inward = turned_inside_out(soup);
  for_both_methods([&](const auto& np) {
    const Labels outward = labels_of_soup(soup, np);
    BOOST_TEST(number_of(outward) >= 2u);
    BOOST_TEST(labels_of_soup(inward, np) == outward, boost::test_tools::per_element());
    BOOST_TEST(labels_of(mesh_of(inward), np) == outward, boost::test_tools::per_element());
    // one of two that nothing joins
    const Labels both = labels_of_soup(disjoint_union(soup, moved(inward, 9, 0, 0)), np);
    BOOST_TEST(number_of(both) == 2 * number_of(outward));
  });
  // With a large hole the direction is taken as it is: the neck is convex if faces point inward.
  Soup open = soup;
  open.triangles.erase(std::remove_if(open.triangles.begin(), open.triangles.end(),
                                      [&](const std::vector<std::size_t>& t)
                                      { return open.points[t[0]].x() > 0.05; }),
                       open.triangles.end());
  const auto salience = [](const Soup& s)
    { return hierarchy_of(mesh_of(s), parameters::default_values()).node(0).salience; };
  BOOST_TEST(salience(turned_inside_out(open)) < salience(open) - 0.1);
}

BOOST_AUTO_TEST_CASE(patches_that_meet_edge_to_edge_are_one_surface)
{
  const Soup whole = dumbbell(24, 20);
  Soup patches[2], all;
  for (std::size_t f = 0; f < whole.triangles.size(); ++f)
    patches[centroid(whole, f).x() > 0].triangles.push_back(whole.triangles[f]);
  Labels expected;
  const Labels of_whole = labels_of_soup(whole);
  for (Soup& patch : patches) {
    patch.points = whole.points;
    all = disjoint_union(all, patch);
    for (const auto& t : patch.triangles)
      expected.push_back(of_whole[std::size_t(
        std::find(whole.triangles.begin(), whole.triangles.end(), t) - whole.triangles.begin())]);
  }
  const Labels labels = labels_of_soup(all);
  BOOST_TEST(number_of(labels) == number_of(of_whole));
  BOOST_TEST(rand_index(labels, expected) > 0.95);
}

BOOST_AUTO_TEST_CASE(a_sheet_under_a_model_changes_nothing_in_it)
{
  // Two balls and a bead of 2 % of their area, on a plate of 50 times their area
  const Soup model = union_of({sphere(3), moved(scaled(sphere(3), 0.5), 0, 0, 1.5),
                               moved(scaled(sphere(2), 0.16), 1.16, 0, 0)});
  const Soup sheet = moved(scaled(plate(20, 20), 2), -20, -20, -1);
  const Labels alone = labels_of_soup(model);
  BOOST_TEST(number_of(alone) == 3u);
  const Labels labels = labels_of_soup(disjoint_union(model, sheet));
  BOOST_TEST(number_of(labels) == 4u);
  BOOST_TEST(first_labels(labels, alone.size()) == alone,
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(groups_count_as_components)
{
  const Soup soup = sphere(3);
  const Labels groups =
    by_place<std::size_t>(soup, [](const Point& p) { return p.z() > 0 ? 7 : 3; });
  BOOST_TEST(number_of(labels_of_soup(soup)) == 1u);
  for_both_methods([&](const auto& np) {
    const Labels labels = labels_of_soup(soup, np.face_group_map(groups.data()));
    BOOST_TEST(number_of(labels) == 2u);
    BOOST_TEST(rand_index(labels, groups) == 1);
    const Mesh mesh = mesh_of(soup);
    const auto of_face = boost::make_function_property_map<Mesh::Face_index, int>(
      [&](Mesh::Face_index f) { return static_cast<int>(groups[f]); });
    BOOST_TEST(labels_of(mesh, np.face_group_map(of_face)) == labels,
               boost::test_tools::per_element());
  });
  const Soup dumbbell = test_meshes::dumbbell(24, 20);
  const Labels one_group(dumbbell.triangles.size(), 5);
  BOOST_TEST(labels_of_soup(dumbbell, parameters::face_group_map(one_group.data())) ==
               labels_of_soup(dumbbell), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(no_leaf_spans_two_groups)
{
  // Random groups, and faces twice, in the same or in another group
  Random random(1);
  const Soup soup = double_sided(dumbbell(12, 10));
  for (int i = 0; i < 10; ++i) {
    Labels groups;
    for (const auto& t : soup.triangles)
      groups.push_back(std::size_t(soup.points[t[0]].z() * 2 + 9) % 3 + random() % 2 * (i % 2));
    Segmentation_hierarchy hierarchy;
    labels_of_soup(soup, parameters::face_group_map(groups.data()).hierarchy(hierarchy)
                           .number_of_searches(2));
    const std::size_t n = soup.triangles.size() / 2;
    for (std::size_t node = 0; node < hierarchy.number_of_nodes(); ++node)
      if (hierarchy.node(node).is_leaf()) {
        std::set<std::size_t> possible = {0, 1, 2, 3};
        for (auto f : hierarchy.faces(node)) { // of two faces one counts
          std::set<std::size_t> both;
          for (std::size_t group : {groups[f % n], groups[f % n + n]})
            if (possible.count(group) == 1)
              both.insert(group);
          possible = both;
        }
        BOOST_TEST(!possible.empty());
      }
  }
}

BOOST_AUTO_TEST_CASE(isolated_components_stay_apart_and_are_joined_nearest_first)
{
  const Soup soup = union_of({sphere(2), moved(sphere(2), 10, 0, 0), moved(sphere(2), 14, 0, 0)});
  const Mesh mesh = mesh_of(soup);
  const std::size_t n = sphere(2).triangles.size();
  for (double threshold : {0.4, 0.99, infinity})
    BOOST_TEST(number_of(labels_of(mesh, parameters::salience_threshold(threshold))) == 3u);
  const Labels two = labels_of(mesh, parameters::number_of_segments(2));
  BOOST_TEST(two[0] == 0u);
  BOOST_TEST(two[n] == 1u);
  BOOST_TEST(two[2 * n] == 1u);
  const Segmentation_hierarchy hierarchy = hierarchy_of(mesh, parameters::default_values());
  BOOST_TEST(hierarchy.number_of_roots() == 1u);
  BOOST_TEST(hierarchy.node(0).salience == infinity);
  BOOST_TEST((labels_above(hierarchy, 0.4, 2) == two));
  const auto apart = parameters::keep_components_separate(true);
  BOOST_TEST(hierarchy_of(mesh, apart).number_of_roots() == 3u);
}

BOOST_AUTO_TEST_CASE(keep_components_separate_are_parts_from_the_start)
{
  const Soup soup = disjoint_union(sphere(3), moved(sphere(3), 1.9, 0, 0));
  BOOST_TEST(number_of(labels_of_soup(soup, parameters::keep_components_separate(true)
                                              .maximum_number_of_segments(1))) == 2u);
  BOOST_TEST(number_of(labels_of_soup(soup, parameters::zhang_liu_2005()
                                              .maximum_number_of_segments(1))) == 2u);
  BOOST_TEST(number_of(labels_of_soup(soup, parameters::maximum_number_of_segments(1))) == 1u);
  BOOST_CHECK_THROW(labels_of(soup, parameters::zhang_liu_2005().keep_components_separate(false)),
                    std::invalid_argument);
}

// A dome, a room, a plinth, a thick slab, a hilly terrain, and a plinth in a dome, whichever way
// their faces point.
BOOST_AUTO_TEST_CASE(a_body_has_its_parts_in_any_surroundings)
{
  const Soup& body = doll();
  const std::size_t n = body.triangles.size();
  const Labels alone = labels_of_soup(body);
  BOOST_TEST(number_of(alone) > 2u);
  const double unit = unit_of(body);
  Cells cell;
  add_box(cell, {0, 0, 0}, {1, 1, 1});
  const auto box = [&](double x, double y, double z, double below) {
    return transformed(boundary_of(cell), [=](const Point& p) {
      return Point(unit * x * (p.x() - 0.5), unit * y * (p.y() - 0.5),
                   unit * (z * p.z() - below));
    });
  };
  const Soup dome = scaled(sphere(3), 6 * unit), room = box(8, 9, 10, 5), plinth = box(9, 9, 1, 3),
             slab = box(6, 5, 1.5, 3.6), terrain = transformed(plate(20, 20), [=](const Point& p) {
    return Point(unit / 2 * (p.x() - 10), unit / 2 * (p.y() - 10),
                 unit * (0.3 * std::sin(p.x() / 3) * std::sin(p.y() / 4) - 4));
  });
  for (const Soup& surroundings :
       {dome, room, plinth, slab, terrain, disjoint_union(scaled(dome, 2), plinth)})
    for (const Soup& turned : {surroundings, turned_inside_out(surroundings)}) {
      const Labels labels = labels_of_soup(disjoint_union(body, turned));
      BOOST_TEST(first_labels(labels, n) == alone,
                 boost::test_tools::per_element());
      BOOST_TEST(number_of(labels) > number_of(alone));
    }
}

// A body, and a bead on it of 2 % of its area, in a dome of many times their size.
BOOST_AUTO_TEST_CASE(several_components_have_their_parts_in_a_dome)
{
  const Soup model = union_of({sphere(3), moved(scaled(sphere(3), 0.5), 0, 0, 1.5),
                               moved(scaled(sphere(2), 0.16), 1.16, 0, 0),
                               moved(scaled(sphere(2), 0.05), -1.2, 0, 0)});
  const Labels alone = labels_of_soup(model);
  const Labels labels =
    labels_of_soup(disjoint_union(model, turned_inside_out(scaled(sphere(3), 50))));
  BOOST_TEST(first_labels(labels, alone.size()) == alone,
             boost::test_tools::per_element());
  BOOST_TEST(number_of(labels) == number_of(alone) + 1);
}

BOOST_AUTO_TEST_CASE(solids_that_touch_have_segments_of_their_own)
{
  // A plate with a bar in a groove and another on top, on the points of one grid
  Cells plate, bar, top;
  add_box(plate, {0, 0, 0}, {12, 8, 2});
  add_box(bar, {2, 3, 1}, {10, 5, 2});
  for (const Cell& c : bar)
    plate.erase(c);
  add_box(top, {0, 0, 2}, {2, 8, 5});
  const std::vector<Cells> solids = {plate, bar, top};
  Soup all;
  Labels solid;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    all = disjoint_union(all, boundary_of(solids[i]));
    solid.resize(all.triangles.size(), i);
  }
  for (unsigned seed = 0; seed < 10; ++seed) {
    Random random(seed);
    std::vector<std::size_t> face;
    const Labels labels = labels_of_soup(renumbered(all, random, face));
    std::map<std::size_t, std::size_t> solid_of_segment;
    for (std::size_t f = 0; f < solid.size(); ++f)
      BOOST_TEST(solid_of_segment.emplace(labels[face[f]], solid[f]).first->second == solid[f]);
    BOOST_TEST(number_of(labels) >= solids.size());
  }
}

BOOST_AUTO_TEST_CASE(details_of_a_block_are_not_in_a_room)
{
  // A ball of a third of a percent of the area, half in a cube
  Cells cell;
  add_box(cell, {0, 0, 0}, {1, 1, 1});
  const Soup block = disjoint_union(scaled(boundary_of(cell), 10),
                                    moved(scaled(sphere(2), 0.4), 5, 5, 9.95));
  BOOST_TEST(number_of(labels_of_soup(block)) == 1u);
}

BOOST_AUTO_TEST_CASE(an_open_body_that_points_inward_has_its_parts)
{
  Soup body = doll();
  body.triangles.pop_back(); // a hole
  BOOST_TEST(labels_of_soup(turned_inside_out(body)) == labels_of_soup(body),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_large_component_that_is_kept_is_cut_as_if_it_was_alone)
{
  const Soup& body = doll();
  const std::size_t n = body.triangles.size();
  const Soup all = disjoint_union(body, moved(scaled(sphere(2), unit_of(body)), 50, 0, 0));
  const Labels alone = labels_of_soup(body),
               labels = labels_of_soup(all, parameters::keep_components_separate(true));
  BOOST_TEST(number_of(labels) == number_of(alone) + 1);
  BOOST_TEST(first_labels(labels, n) == alone,
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_number_asked_for_is_the_number_given)
{
  for (const Soup& soup : {dumbbell(6, 4), plate(5, 2),
                           disjoint_union(sphere(1), moved(sphere(0), 1.9, 0, 0)),
                           disjoint_union(sphere(0), moved(sphere(0), 9, 0, 0)),
                           loose_triangles(sphere(0))}) {
    const Mesh mesh = mesh_of(soup);
    const std::size_t n = soup.triangles.size();
    for_both_methods([&](const auto& np) {
      const std::size_t least = hierarchy_of(mesh, np).number_of_roots();
      for (std::size_t number : {least, (std::min)(least + 4, n), n})
        BOOST_TEST(check_labels(mesh, labels_of(mesh, np.number_of_segments(number))) == number);
      for (std::size_t number : {std::size_t(0), least - 1, n + 1})
        check_refused(mesh, np.number_of_segments(number));
    });
  }
  BOOST_CHECK_THROW(labels_of(Mesh(), parameters::number_of_segments(1)), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_number_of_segments_refines_the_parts)
{
  const Mesh mesh = mesh_of(dumbbell(16, 12));
  const Segmentation_hierarchy hierarchy =
    hierarchy_of(mesh, parameters::number_of_segments(60));
  Labels fine = labels_of(mesh, parameters::number_of_segments(60));
  for (std::size_t number : {59, 30, 7, 2, 1}) {
    const Labels coarse = labels_above(hierarchy, -infinity, number);
    BOOST_TEST(number_of(coarse) == number);
    std::set<std::pair<std::size_t, std::size_t> > pairs;
    for (std::size_t f = 0; f < fine.size(); ++f)
      pairs.insert({fine[f], coarse[f]});
    BOOST_TEST(pairs.size() == number_of(fine));
    fine = coarse;
  }
}

BOOST_AUTO_TEST_CASE(no_soup_is_too_wild)
{
  for (const auto& [name, soup] : adversarial_soups())
    BOOST_TEST_CONTEXT(name) {
      const auto np = parameters::number_of_searches(2); // 5 take longer
      const Labels labels = labels_of_soup(soup, np);
      BOOST_TEST(labels == labels_of_soup(soup, np), boost::test_tools::per_element());
      const std::size_t most = (std::min)(soup.triangles.size(), std::size_t(22));
      for (std::size_t number : {std::size_t(1), most})
        BOOST_TEST(number_of(labels_of_soup(soup, np.number_of_segments(number))) == number);
      labels_of_soup(soup, parameters::zhang_liu_2005());
    }
}

BOOST_AUTO_TEST_SUITE_END()
