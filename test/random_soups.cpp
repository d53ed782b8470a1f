// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "box_figures.h"
#include "test_labels.h"
#include "test_meshes.h"

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// All that the manual promises, for meshes and parameters at random.
BOOST_AUTO_TEST_SUITE(random_soups)

using namespace test_meshes;
namespace parameters = CGAL::Spectral_segmentation::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using CGAL::Spectral_segmentation::Segmentation_visitor;

namespace {

const double infinity = std::numeric_limits<double>::infinity();
const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

double random_share(Random& random) { return double(random() % 1001) / 1000; }

// Unit cubes that hang together, so that their boundary has limbs, handles and hollows. Where it is
// no manifold, vertices are duplicated.
Soup random_cubes(Random& random)
{
  Cells cells = {{0, 0, 0}};
  const std::size_t n = random_number(random, 1, 25);
  while (cells.size() < n) {
    Cell cell = *std::next(cells.begin(), std::ptrdiff_t(random() % cells.size()));
    cell[random() % 3] += random() % 2 == 0 ? 1 : -1;
    cells.insert(cell);
  }
  Soup soup = boundary_of(cells);
  PMP::orient_polygon_soup(soup.points, soup.triangles);
  return soup;
}

Soup random_oriented_triangles(Random& random)
{
  Soup soup = random_triangles(random, 12, 25);
  PMP::orient_polygon_soup(soup.points, soup.triangles);
  return soup;
}

Soup random_piece(Random& random)
{
  switch (random() % 6) {
  case 0: return random_cubes(random);
  case 1: return random_oriented_triangles(random);
  case 2: return plate(random_number(random, 1, 12), random_number(random, 1, 8));
  case 3: return dumbbell(random_number(random, 3, 12), random_number(random, 2, 8));
  case 4:
    return torus(3, 1, random_number(random, 3, 14), random_number(random, 3, 8));
  default:
    return connected_sum(sphere(random() % 3), torus(3, 1, random_number(random, 3, 10), 5));
  }
}

// A manifold: of one to three pieces, some with holes, some with noise, some with faces without
// area.
Soup random_soup(Random& random)
{
  Soup soup;
  const std::size_t n = random_number(random, 1, 3);
  for (std::size_t i = 0; i < n; ++i)
    soup = disjoint_union(soup, moved(random_piece(random), 5. * double(i), 0, 0));
  if (random() % 3 == 0) {
    std::vector<std::vector<std::size_t> > rest;
    for (const std::vector<std::size_t>& t : soup.triangles)
      if (random() % 20 != 0)
        rest.push_back(t);
    if (PMP::is_polygon_soup_a_polygon_mesh(rest))
      soup.triangles = rest;
  }
  if (random() % 2 == 0)
    soup = displaced(soup, 0.2, random);
  if (random() % 4 == 0)
    for (Point& p : soup.points)
      if (random() % 10 == 0)
        p = soup.points[random() % soup.points.size()];
  return soup;
}

auto random_parameters(Random& random)
{
  const double thresholds[] = {-infinity, 0, 0.2, 0.42, 0.54, 0.8, 2};
  return parameters::salience_threshold(thresholds[random() % 7])
    .maximum_number_of_segments(random() % 2 == 0 ? unlimited : random_number(random, 1, 30))
    .minimum_segment_size(random() % 2 == 0 ? 0. : 0.1 * random_share(random))
    .number_of_reference_faces(random_number(random, 1, 12))
    .number_of_coarse_faces(random() % 2 == 0 ? 0 : random_number(random, 1, 300))
    .number_of_smoothing_iterations(random() % 3)
    .smooth_boundaries(random() % 2 == 0)
    .distance_weights(random_share(random), random_share(random), random_share(random))
    .random_seed(random());
}

bool is_union_of(const Labels& coarse, const Labels& fine)
{
  std::vector<std::size_t> label(number_of(fine), untouched);
  for (std::size_t f = 0; f < fine.size(); ++f) {
    if (label[fine[f]] == untouched)
      label[fine[f]] = coarse[f];
    if (label[fine[f]] != coarse[f])
      return false;
  }
  return true;
}

// Returns what is wrong.
struct Checker
{
  std::ostringstream failures;

  void check(bool condition, const char* what)
  {
    if (!condition)
      failures << what << "; ";
  }

  void check_hierarchy(const Segmentation_hierarchy& h, const Mesh& mesh)
  {
    check(h.number_of_faces() == num_faces(mesh), "number of faces of the hierarchy");
    std::vector<std::size_t> number_of_parents(h.number_of_nodes(), 0);
    std::size_t leaves = 0;
    for (std::size_t i = 0; i < h.number_of_nodes(); ++i) {
      const Segmentation_hierarchy::Node& n = h.node(i);
      check(h.number_of_faces(i) > 0, "a node without faces");
      check((n.parent == Segmentation_hierarchy::null_node) == (i < h.number_of_roots()),
            "a root with a parent, or another node without");
      check(n.is_leaf() == (n.cut_state != Segmentation_hierarchy::Cut_state::CUT),
            "an accepted cut without children, or children without");
      leaves += n.is_leaf();
      if (n.is_leaf())
        continue;
      std::size_t faces_of_children = 0;
      for (std::size_t child : n.children) {
        check(child > i && child < h.number_of_nodes() && h.node(child).parent == i,
              "a child that does not know its parent");
        ++number_of_parents[child];
        faces_of_children += h.number_of_faces(child);
      }
      check(faces_of_children == h.number_of_faces(i), "children with other faces than the parent");
    }
    check(leaves == h.number_of_segments(), "number of leaves");
    for (std::size_t i = 0; i < h.number_of_nodes(); ++i)
      check(number_of_parents[i] == std::size_t(i >= h.number_of_roots()), "number of parents");
  }

  // Segments for fewer or more salient cuts are unions, without the smoothing of boundaries. By the
  // method of the paper, a run that ended at its maximum may not know the labels for a higher
  // threshold. It may have fewer segments then, as a cut can be lost when it is carried back.
  void check_nesting(const Segmentation_hierarchy& h, std::size_t number_of_segments,
                     bool smooth_boundaries, bool has_maximum)
  {
    Labels finer = run_labels(h), last = finer;
    check(number_of(finer) == number_of_segments, "labels of the hierarchy");
    for (std::size_t n = number_of_segments; n > 1; --n) {
      const Labels labels = labels_above(h, h.salience_threshold(), n - 1);
      check(number_of(labels) == (std::max)(n - 1, h.number_of_roots()),
            "labels for a number of segments");
      check(smooth_boundaries || is_union_of(labels, finer), "nesting by the number of segments");
      finer = labels;
    }
    finer = last;
    for (double threshold : {0., 0.3, 0.5, 0.7, 0.9, infinity})
      if (threshold > h.salience_threshold()) {
        Labels labels;
        try {
          labels = labels_above(h, threshold, number_of_segments);
        }
        catch (const std::out_of_range&) {
          check(has_maximum, "labels for a threshold are not known");
          continue;
        }
        check(smooth_boundaries || is_union_of(labels, finer), "nesting by the threshold");
        check(number_of(labels) <= number_of(finer), "more segments for a higher threshold");
        finer = labels;
      }
  }

  template <class NamedParameters>
  Labels labels_of_polyhedron(const Soup& soup, const NamedParameters& np)
  {
    typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
    typedef boost::graph_traits<Polyhedron>::face_descriptor Face;
    Polyhedron polyhedron;
    PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, polyhedron);
    std::map<Face, std::size_t> label;
    CGAL::segment_spectral_recursive(polyhedron, boost::make_assoc_property_map(label), np);
    Labels result;
    for (Face f : faces(polyhedron))
      result.push_back(label.at(f));
    return result;
  }

  template <class NamedParameters>
  void check_exceptions(const Mesh& mesh, std::size_t number_of_segments, std::size_t random,
                        const NamedParameters& np)
  {
    struct Failure {};
    struct Visitor : Segmentation_visitor
    {
      std::size_t remaining_polls;
      explicit Visitor(std::size_t polls) : remaining_polls(polls) {}
      bool go_further()
      {
        if (remaining_polls-- == 0)
          throw Failure();
        return true;
      }
    };
    Labels labels;
    const auto map = map_to(labels, mesh);
    const auto is_untouched = [&] {
      return std::count(labels.begin(), labels.end(), untouched) == std::ptrdiff_t(labels.size());
    };
    const auto check_thrown = [&](const auto& pack) {
      try {
        CGAL::segment_spectral_recursive(mesh, map, pack);
        check(false, "nothing thrown");
      }
      catch (const Failure&) {
      }
      catch (const std::invalid_argument&) {
      }
      check(is_untouched(), "labels written in spite of an exception");
    };
    check_thrown(np.visitor(Visitor(random % 3)));
    check_thrown(np.maximum_number_of_segments(0));
    if (number_of_segments > 128) {
      std::vector<signed char> ids(labels.size(), 77);
      try {
        CGAL::segment_spectral_recursive(
          mesh, boost::make_iterator_property_map(ids.begin(), get(CGAL::face_index, mesh)), np);
        check(false, "no overflow");
      }
      catch (const std::overflow_error&) {
      }
      check(std::count(ids.begin(), ids.end(), 77) == std::ptrdiff_t(ids.size()),
            "labels written in spite of an overflow");
    }
  }

  template <class NamedParameters>
  void operator()(const Soup& soup, bool smooth_boundaries, std::size_t maximum,
                  bool keep_components_separate, std::size_t random, const NamedParameters& np)
  {
    const Mesh mesh = mesh_of(soup);
    Labels labels, components(num_faces(mesh), 0);
    Segmentation_hierarchy hierarchy;
    const std::size_t n = CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(
      mesh, map_to(labels, mesh), np.hierarchy(hierarchy));
    check(n == number_of(labels), "number that is returned");
    std::size_t next = 0;
    for (std::size_t label : labels) {
      check(label <= next, "segments are not numbered by their first face");
      next += label == next;
    }
    const std::size_t number_of_components = number_of_connected_pieces(mesh, components);
    const bool is_apart = keep_components_separate || number_of_components <= 1;
    check(!is_apart || number_of_connected_pieces(mesh, labels) == n,
          "a segment is not connected");
    const std::size_t number_of_roots = is_apart ? number_of_components : 1;
    check(n >= number_of_roots, "fewer segments than roots");
    check(n <= (std::max)(maximum, number_of_roots), "more segments than the maximum");

    check(labels_of(mesh, np) == labels, "other labels with threads");
    check(labels_of(mesh, np) == labels, "other labels in another run");
    check(labels_of_polyhedron(soup, np) == labels, "other labels for a polyhedron");
    check(hierarchy.number_of_roots() == number_of_roots, "number of roots");
    check(run_labels(hierarchy) == labels, "other labels of the hierarchy");
    check_hierarchy(hierarchy, mesh);
    check_nesting(hierarchy, n, smooth_boundaries, maximum != unlimited);
    if (!soup.triangles.empty())
      check_exceptions(mesh, n, random, np);
  }
};

// On failure the soup is saved to the working directory.
template <class NamedParameters>
void check(unsigned seed, const Soup& soup, bool smooth_boundaries, std::size_t maximum,
           bool keep_components_separate, const NamedParameters& np)
{
  Checker checker;
  try {
    checker(soup, smooth_boundaries, maximum, keep_components_separate, seed, np);
  }
  catch (const std::exception& e) {
    checker.failures << e.what();
  }
  const std::string failures = checker.failures.str();
  const std::string name = "random_soup_" + std::to_string(seed) + ".off";
  if (!failures.empty())
    CGAL::IO::write_polygon_soup(name, soup.points, soup.triangles,
                                 CGAL::parameters::stream_precision(17));
  BOOST_TEST(failures.empty(), "seed " << seed << ", saved as " << name << ": " << failures);
}

} // namespace

BOOST_AUTO_TEST_CASE(with_the_parameters_of_either_method)
{
  for (unsigned seed = 0; seed < 18; ++seed) {
    Random random(seed);
    const Soup soup = random_soup(random);
    check(seed, soup, false, unlimited, true, parameters::zhang_liu_2005());
    if (seed % 3 == 0)
      check(seed, soup, false, unlimited, false, parameters::default_values());
    if (seed % 3 == 1)
      check(seed, soup, false, unlimited, true, parameters::keep_components_separate(true));
  }
}

BOOST_AUTO_TEST_CASE(with_parameters_at_random)
{
  for (unsigned seed = 1000; seed < 1030; ++seed) {
    Random random(seed);
    const Soup soup = random_soup(random);
    const auto np = random_parameters(random);
    namespace tags = CGAL::Spectral_segmentation::internal_np;
    const auto& pack = np.cgal_parameters();
    const bool smooth_boundaries = CGAL::parameters::get_parameter(pack, tags::smooth_boundaries);
    const std::size_t maximum =
      CGAL::parameters::get_parameter(pack, tags::maximum_number_of_segments);
    const bool apart = seed % 2 == 0;
    check(seed, soup, smooth_boundaries, maximum, apart, np.keep_components_separate(apart));
    check(seed, soup, smooth_boundaries, maximum, true, np.zhang_liu_2005());
  }
}

BOOST_AUTO_TEST_SUITE_END()
