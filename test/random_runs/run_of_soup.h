// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_FUZZ_RUN_OF_SOUP_H
#define SPECTRAL_SEGMENTATION_TEST_FUZZ_RUN_OF_SOUP_H

#include "Event_visitor.h"
#include "random_meshes.h"

#include <CGAL/Spectral_segmentation/IO/hierarchy.h>
#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Parameters at random, and runs with them of which all that the caller sees is kept.
namespace random_runs {

namespace parameters = CGAL::Spectral_segmentation::parameters;
using CGAL::Spectral_segmentation::Method;
using CGAL::Spectral_segmentation::Options;
using CGAL::Spectral_segmentation::Segmentation_hierarchy;

typedef std::vector<std::size_t> Labels;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Broken_invariant : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

inline void require(bool condition, const std::string& invariant)
{
  if (!condition)
    throw Broken_invariant(invariant);
}

// Returns all digits that matter, however small the number is.
inline std::string text(double number)
{
  std::ostringstream os;
  os << number;
  return os.str();
}

struct Parameters
{
  Options options;
  std::vector<int> groups; // of the faces; empty for no face_group_map
  std::vector<int> seeds;  // of the faces; empty for no face_seed_map
  std::vector<std::array<double, 2> > features; // of the faces; empty for none
  std::vector<char> edges; // of a mesh: 'c' if constrained, 'u' if uncuttable; empty for no maps

  bool has_constraints() const { return !seeds.empty() || !edges.empty(); }
};

inline std::ostream& operator<<(std::ostream& os, const Parameters& p)
{
  const Options& o = p.options;
  os << (o.method == Method::CALIBRATED ? "calibrated" : "zhang_liu_2005");
  if (o.number_of_segments)
    os << " number_of_segments=" << *o.number_of_segments;
  return os << " maximum_number_of_segments=" << std::ptrdiff_t(o.maximum_number_of_segments)
            << " salience_threshold="
            << (o.salience_threshold ? std::to_string(*o.salience_threshold) : "none")
            << " keep_components_separate=" << o.keep_components_separate
            << " minimum_segment_size=" << o.minimum_segment_size
            << " number_of_coarse_faces=" << o.number_of_coarse_faces
            << " number_of_smoothing_iterations=" << o.number_of_smoothing_iterations
            << " distance_weights=" << o.geodesic_weight << ',' << o.concave_angle_weight << ','
            << o.convex_angle_weight
            << " number_of_reference_faces=" << o.number_of_reference_faces
            << " random_seed=" << (o.random_seed ? std::to_string(*o.random_seed) : "none")
            << " feature_weight=" << (p.features.empty() ? 0 : o.feature_weight)
            << " face_groups=" << !p.groups.empty() << " seeds="
            << p.seeds.size() - std::size_t(std::count(p.seeds.begin(), p.seeds.end(), -1))
            << " constrained_edges=" << std::count(p.edges.begin(), p.edges.end(), 'c')
            << " uncuttable_edges=" << std::count(p.edges.begin(), p.edges.end(), 'u');
}

inline Options random_options(std::size_t number_of_faces, Random& random)
{
  Options o = one_in(random, 4) ? Options::zhang_liu_2005() : Options();
  if (one_in(random, 2))
    o.number_of_segments = one_in(random, 8) ? random() % (number_of_faces + 2)
                                             : random_number(random, 1, 12);
  else {
    if (one_in(random, 2))
      o.maximum_number_of_segments = random_number(random, 1, 30);
    const double beyond = o.method == Method::CALIBRATED ? 0 : 1; // saliences are no probabilities
    if (one_in(random, 2))
      o.salience_threshold = one_of(
        random, std::vector<double>{-infinity, -beyond, 0, 0.2, 0.5, 0.8, 1, 1 + beyond, infinity});
  }
  if (o.method == Method::CALIBRATED)
    o.keep_components_separate = one_in(random, 4);
  if (one_in(random, 2))
    o.minimum_segment_size = one_of(random, std::vector<double>{0, 0, 0.02, 0.1, 0.25, 0.5});
  // Large numbers, with which a run takes long, are rare.
  o.number_of_coarse_faces = one_of(
    random, std::vector<std::size_t>{0, 0, 0, 1, 2, 5, 10, 20, 20, 50, 50, 100, 100, 300, 4000});
  o.number_of_smoothing_iterations = one_in(random, 4) ? random() % 4 : 0;
  if (one_in(random, 4)) {
    o.geodesic_weight = random_fraction(random);
    o.concave_angle_weight = random_fraction(random);
    o.convex_angle_weight = random_fraction(random);
  }
  if (one_in(random, 4))
    o.number_of_reference_faces = random_number(random, 1, 20);
  if (one_in(random, 4))
    o.random_seed = random();
  return o;
}

inline void spoil(Options& o, Random& random)
{
  switch (random() % 5) {
  case 0: o.number_of_segments = 0; break;
  case 1: o.salience_threshold = std::numeric_limits<double>::quiet_NaN(); break;
  case 2: o.minimum_segment_size = 0.51; break;
  case 3: o.geodesic_weight = -1; break;
  default: o.number_of_reference_faces = 0;
  }
}

// Returns a few groups, of ranges of faces or of faces at random.
inline std::vector<int> random_groups(std::size_t number_of_faces, Random& random)
{
  std::vector<int> result;
  const std::size_t n = random_number(random, 1, 4), length = random_number(random, 1, 100);
  const bool are_ranges = !one_in(random, 4);
  for (std::size_t f = 0; f < number_of_faces; ++f)
    result.push_back(7 * int((are_ranges ? f / length : random()) % n) - 7);
  return result;
}

// Returns few different vectors or many, for ranges of faces or for faces at random.
inline std::vector<std::array<double, 2> > random_features(std::size_t number_of_faces,
                                                           Random& random)
{
  std::vector<std::array<double, 2> > result;
  const std::size_t n = random_number(random, 1, 4), length = random_number(random, 1, 100);
  const bool are_ranges = !one_in(random, 4);
  const double noise = one_of(random, std::vector<double>{0, 0, 1e-9, 0.2, 1e9});
  for (std::size_t f = 0; f < number_of_faces; ++f) {
    const std::size_t i = (are_ranges ? f / length : random()) % n;
    const double x = double(i % 2) + noise * random_fraction(random),
                 y = double(i / 2) + noise * random_fraction(random);
    result.push_back({x, y});
  }
  return result;
}

struct Visitor_failure {};

// Counts the calls, and at one of them throws or stops the run.
struct Visitor : Event_visitor<Visitor>
{
  static constexpr std::size_t never = std::size_t(-1);

  std::size_t number_of_calls = 0, throws_at = never, stops_at = never;

  void event()
  {
    if (number_of_calls++ == throws_at)
      throw Visitor_failure();
  }

  bool go_further()
  {
    event();
    return number_of_calls <= stops_at;
  }
};

inline std::string written(const Segmentation_hierarchy& hierarchy)
{
  std::ostringstream os;
  CGAL::Spectral_segmentation::write_hierarchy(os, hierarchy);
  return os.str();
}

struct Outcome
{
  Labels labels; // by the index of the face; empty after an exception
  Segmentation_hierarchy hierarchy;
  std::string error; // empty without an exception
};

// Calls f with the named parameters and the constraints of a run, for `Face` as the key of maps.
template <class Face, class NamedParameters, class Function>
std::size_t with_constraints(const Parameters& p, const NamedParameters& np, const Function& f)
{
  if (!p.has_constraints())
    return f(np);
  const auto with_seeds = np.face_seed_map(boost::make_function_property_map<Face>(
    [&p](const Face& face) { return p.seeds.empty() ? -1 : p.seeds[std::size_t(face)]; }));
  if constexpr (std::is_same<Face, Mesh::Face_index>::value)
    if (!p.edges.empty()) {
      const auto map_of = [&p](char kind) {
        return boost::make_function_property_map<Mesh::Edge_index>(
          [&p, kind](const Mesh::Edge_index& e) { return p.edges[std::size_t(e)] == kind; });
      };
      return f(with_seeds.edge_is_constrained_map(map_of('c'))
                 .edge_is_uncuttable_map(map_of('u')));
    }
  return f(with_seeds);
}

// Calls f with the named parameters of a run.
template <class Face, class Function>
std::size_t with_parameters(const Parameters& p, Segmentation_hierarchy& hierarchy,
                            Visitor& visitor, const Function& f)
{
  Options options = p.options;
  if (p.features.empty())
    options.feature_weight = 0;
  const auto np =
    parameters::options(options).hierarchy(hierarchy).visitor(std::ref(visitor))
      .face_feature_map(boost::make_function_property_map<Face>([&p](const Face& face) {
        return p.features.empty() ? std::array<double, 2>{0, 0} : p.features[std::size_t(face)];
      }));
  if (p.groups.empty())
    return with_constraints<Face>(p, np, f);
  return with_constraints<Face>(p, np.face_group_map(boost::make_function_property_map<Face>(
    [&p](const Face& face) { return p.groups[std::size_t(face)]; })), f);
}

template <class Tag, class Map, class NamedParameters>
std::size_t segment(const Soup& soup, Map labels, const NamedParameters& np)
{ return CGAL::segment_spectral_recursive<Tag>(soup.points, soup.triangles, labels, np); }

template <class Tag, class Map, class NamedParameters>
std::size_t segment(const Mesh& mesh, Map labels, const NamedParameters& np)
{ return CGAL::segment_spectral_recursive<Tag>(mesh, labels, np); }

inline std::size_t number_of_faces(const Soup& soup) { return soup.triangles.size(); }
inline std::size_t number_of_faces(const Mesh& mesh) { return num_faces(mesh); }

template <class Shape>
using Face_of = std::conditional_t<std::is_same<Shape, Mesh>::value, Mesh::Face_index,
                                   std::size_t>;

// Runs the function on a soup or a mesh. Checks what holds for every run: ids are numbered by their
// first face, and an exception has a message and leaves the ids and the hierarchy.
template <class Tag = CGAL::Sequential_tag, class Shape>
Outcome run(const Shape& shape, const Parameters& p, Visitor& visitor,
            const Segmentation_hierarchy& before = Segmentation_hierarchy())
{
  typedef Face_of<Shape> Face;
  constexpr std::size_t untouched = 1234567;
  Outcome result;
  result.hierarchy = before;
  result.labels.assign(number_of_faces(shape), untouched);
  std::size_t n = 0;
  try {
    n = with_parameters<Face>(p, result.hierarchy, visitor, [&](const auto& np) {
      return segment<Tag>(shape, boost::make_function_property_map<Face, std::size_t&>(
        [&](const Face& f) -> std::size_t& { return result.labels[std::size_t(f)]; }), np);
    });
  }
  catch (const Visitor_failure&) {
    result.error = "the visitor has thrown";
  }
  catch (const std::invalid_argument& e) {
    result.error = e.what();
    require(result.error.find("segment_spectral_recursive: ") == 0 && result.error.size() > 40 &&
              result.error.size() < 300, "an exception has a message: " + result.error);
  }
  if (!result.error.empty()) {
    require(result.labels == Labels(result.labels.size(), untouched),
            "an exception leaves the ids as they are: " + result.error);
    require(written(result.hierarchy) == written(before),
            "an exception leaves the hierarchy as it is: " + result.error);
    result.labels.clear();
    return result;
  }
  std::size_t next = 0;
  for (std::size_t label : result.labels) {
    require(label <= next, "segments are numbered by their first face");
    next += label == next;
  }
  require(next == n, "the number of segments is returned");
  require(result.hierarchy.labels(result.hierarchy.nodes()) == result.labels,
          "the hierarchy has the ids of the run");
  return result;
}

} // namespace random_runs

#endif // SPECTRAL_SEGMENTATION_TEST_FUZZ_RUN_OF_SOUP_H
