// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// The WebAssembly module behind index.js, which checks the arguments: meshes and their runs.

#include <CGAL/Spectral_segmentation/Options.h>
#include <CGAL/Spectral_segmentation/Segmentation_hierarchy.h>
#include <CGAL/Spectral_segmentation/Segmentation_visitor.h>
#include <CGAL/Spectral_segmentation/version.h>
#include <CGAL/property_map.h>
#include <CGAL/segment_spectral_recursive.h>
#include <CGAL/tags.h>

#include <files/Face_vectors.h>
#include <files/Segmented_soup.h>
#include <files/segment_colors.h>
#include <files/write_mesh_file.h>
#include <meshes/hierarchy_json.h>
#include <meshes/page/page_data.h>
#include <meshes/part_tree.h>
#include <meshes/read_input.h>
#include <meshes/refined_input.h>
#include <meshes/segment_neighbors.h>

#include <boost/property_map/function_property_map.hpp>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace web {

namespace segmentation = CGAL::Spectral_segmentation;
using emscripten::val;
using segment_mesh::Index;
using segment_mesh::Input;

// Returns a copy of numbers as a typed array. A view of the memory would end when it grows.
template <class Number>
val typed_array(const std::vector<Number>& numbers)
{
  return val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<val>("slice");
}

template <class Number, class Triple>
val typed_array_of_triples(const std::vector<Triple>& triples)
{
  const auto* const numbers = reinterpret_cast<const Number*>(triples.data());
  return val(emscripten::typed_memory_view(3 * triples.size(), numbers)).call<val>("slice");
}

// Returns the points of a typed array of any number type.
std::vector<mesh_file::Point> points_of(const val& array)
{
  std::vector<mesh_file::Point> result(array["length"].as<std::size_t>() / 3);
  val(emscripten::typed_memory_view(3 * result.size(), reinterpret_cast<double*>(result.data())))
    .call<void>("set", array);
  return result;
}

// Returns the numbers of a typed array; none if it is undefined.
template <class Number>
std::vector<Number> numbers_of(const val& array)
{
  std::vector<Number> result;
  if (!array.isUndefined()) {
    result.resize(array["length"].as<std::size_t>());
    val(emscripten::typed_memory_view(result.size(), result.data())).call<void>("set", array);
  }
  return result;
}

val typed_array_of_bytes(const std::string& bytes)
{
  return val(emscripten::typed_memory_view(
    bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()))).call<val>("slice");
}

// A mesh, which each of its runs keeps alive.
class Mesh
{
  std::shared_ptr<const Input> input_;

  explicit Mesh(Input&& input) : input_(std::make_shared<const Input>(std::move(input))) {}

public:
  static Mesh read(const std::string& bytes, const std::string& extension)
  {
    segment_mesh::Scene scene;
    scene.soup = mesh_file::read_mesh_file(bytes, mesh_file::format_of_extension(extension), true);
    Mesh result(segment_mesh::triangulated(std::move(scene)));
    if (result.input_->triangles.empty())
      throw std::runtime_error("it has no face with three different corners" +
                               segment_mesh::first_warning(result.input_->soup));
    return result;
  }

  static Mesh of_arrays(const val& points, const val& triangles)
  {
    mesh_file::Polygon_soup soup;
    soup.points = points_of(points);
    soup.corners = numbers_of<Index>(triangles);
    for (std::size_t i = 3; i <= soup.corners.size(); i += 3)
      soup.first_corner.push_back(static_cast<Index>(i));
    return Mesh(segment_mesh::input_of_arrays(std::move(soup)));
  }

  const std::shared_ptr<const Input>& input() const { return input_; }
  std::size_t number_of_faces() const { return input_->soup.number_of_polygons(); }
  val points() const { return typed_array_of_triples<double>(input_->soup.points); }
  val triangles() const { return typed_array_of_triples<Index>(input_->triangles); }
  val face_of_triangle() const { return typed_array(input_->polygon_of_triangle); }
  val warnings() const { return val::array(input_->soup.warnings); }
};

// Asks a function of JavaScript, which returns whether to go on.
class Progress : public segmentation::Segmentation_visitor
{
  const val& function_;
  bool goes_on_ = true;

public:
  explicit Progress(const val& function) : function_(function) {}

  void progress(double fraction)
  {
    if (goes_on_ && !function_.isUndefined())
      goes_on_ = function_(fraction).as<bool>();
  }

  bool go_further() { return goes_on_; }
};

typedef std::pair<std::size_t, std::size_t> Edge;

Edge edge_of(std::size_t a, std::size_t b) { return std::minmax(a, b); }

std::vector<Edge> sorted_edges(const std::vector<mesh_file::Triangle>& triangles)
{
  std::vector<Edge> result;
  for (const mesh_file::Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      result.push_back(edge_of(t[i], t[(i + 1) % 3]));
  std::sort(result.begin(), result.end());
  return result;
}

// The constraints of a run, as maps of triangles and edges.
class Constraint_maps
{
  const std::vector<Index>& face_of_triangle_;
  std::vector<std::int32_t> seed_of_face_;
  std::vector<std::int32_t> group_of_face_;
  std::vector<Edge> constrained_edges_;
  std::vector<Edge> uncuttable_edges_;

  // Returns the edges of a constraint, sorted. Throws if one is not in the mesh. `known` gets the
  // edges of the mesh, sorted, when they are first needed.
  static std::vector<Edge> read_edges(const Input& input, const val& given, const char* name,
                                      std::vector<Edge>& known)
  {
    const std::vector<std::int32_t> corners = numbers_of<std::int32_t>(given[name]);
    std::vector<Edge> result;
    if (corners.empty())
      return result;
    if (known.empty())
      known = sorted_edges(input.triangles);
    for (std::size_t i = 0; i < corners.size(); i += 2) {
      result.push_back(edge_of(corners[i], corners[i + 1]));
      if (!std::binary_search(known.begin(), known.end(), result.back()))
        throw std::invalid_argument(
          std::string(name) + " has the edge (" + std::to_string(corners[i]) + ", " +
          std::to_string(corners[i + 1]) + "), which no triangle has");
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  static auto edge_map(const std::vector<Edge>& edges)
  {
    return boost::make_function_property_map<Edge>(
      [&edges](const Edge& e) { return std::binary_search(edges.begin(), edges.end(), e); });
  }

  auto triangle_map(const std::vector<std::int32_t>& value_of_face) const
  {
    return boost::make_function_property_map<std::size_t>([&](std::size_t t) {
      return value_of_face.empty() ? -1 : value_of_face[face_of_triangle_[t]];
    });
  }

public:
  Constraint_maps(const Input& input, const val& given)
    : face_of_triangle_(input.polygon_of_triangle),
      seed_of_face_(numbers_of<std::int32_t>(given["faceSeeds"])),
      group_of_face_(numbers_of<std::int32_t>(given["faceGroups"]))
  {
    std::vector<Edge> known;
    constrained_edges_ = read_edges(input, given, "constrainedEdges", known);
    uncuttable_edges_ = read_edges(input, given, "uncuttableEdges", known);
  }

  auto seed_map() const { return triangle_map(seed_of_face_); }
  auto group_map() const { return triangle_map(group_of_face_); }
  auto constrained_edge_map() const { return edge_map(constrained_edges_); }
  auto uncuttable_edge_map() const { return edge_map(uncuttable_edges_); }
};

// Returns the features of the faces. `features` has the labels or the vectors of all faces, one
// after the other.
mesh_file::Face_vectors read_features(const Input& input, const val& given)
{
  if (given["features"].isUndefined())
    return {};
  if (given["featuresAreLabels"].as<bool>()) {
    const auto labels = numbers_of<std::int32_t>(given["features"]);
    return mesh_file::face_vectors_of_labels({labels.begin(), labels.end()});
  }
  std::vector<double> numbers = numbers_of<double>(given["features"]);
  const std::size_t dimension = numbers.size() / input.soup.number_of_polygons();
  return mesh_file::face_vectors(dimension, std::move(numbers));
}

// Returns the name of an option in JavaScript.
std::string camel_case(const std::string& name)
{
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i)
    result += name[i] == '_' ? static_cast<char>(std::toupper(name[++i])) : name[i];
  return result;
}

// Returns the kind of each option that is a number or a truth value.
val option_kinds()
{
  val result = val::object();
  const segmentation::Options defaults;
  for_each_option(defaults, [&](const segmentation::Option_description& option, const auto&)
    { result.set(camel_case(option.name), std::string(option.kind)); });
  return result;
}

segmentation::Options read_options(const val& given)
{
  const bool uses_paper_method =
    !given["method"].isUndefined() && given["method"].as<std::string>() == "paper";
  segmentation::Options o =
    uses_paper_method ? segmentation::Options::zhang_liu_2005() : segmentation::Options();
  const auto weight = [&](const char* name, int i) { return given[name][i].as<double>(); };
  if (!given["salienceWeights"].isUndefined()) {
    const char* const name = "salienceWeights";
    o.part_salience =
      segmentation::Weighted_part_salience{weight(name, 0), weight(name, 1), weight(name, 2)};
  }
  if (!given["distanceWeights"].isUndefined()) {
    o.geodesic_weight = weight("distanceWeights", 0);
    o.concave_angle_weight = weight("distanceWeights", 1);
    o.convex_angle_weight = weight("distanceWeights", 2);
  }
  if (!given["randomSeed"].isUndefined()) // numbers of JavaScript are doubles
    o.random_seed = static_cast<std::uint64_t>(given["randomSeed"].as<double>());
  for_each_option(o, [&](const segmentation::Option_description& option, auto& field) {
    const val value = given[camel_case(option.name)];
    if (!value.isUndefined())
      option.set(field, value.as<std::conditional_t<
                          std::is_same<decltype(field), bool&>::value, bool, double> >());
  });
  check(o);
  if (given["features"].isUndefined())
    o.feature_weight = 0;
  return o;
}

class Segmentation
{
  std::shared_ptr<const Input> input_;
  segmentation::Options options_;
  segmentation::Segmentation_hierarchy tree_;
  std::vector<Index> label_of_triangle_; // one per triangle of the run

  // Returns the labels that `choice` demands; those of the run if it is undefined.
  std::vector<Index> labels_of_triangles(const val& choice) const
  {
    if (choice.isUndefined())
      return label_of_triangle_;
    const auto number = [&](const char* name, auto otherwise) {
      return choice[name].isUndefined() ? otherwise : choice[name].as<decltype(otherwise)>();
    };
    const std::size_t exact = number("numberOfSegments", std::size_t(0));
    const std::vector<std::size_t> labels = tree_.labels(
      exact > 0 ? tree_.nodes(exact)
                : tree_.nodes_above(number("salienceThreshold", tree_.salience_threshold()),
                                    number("maximumNumberOfSegments", segmentation::unlimited)));
    return {labels.begin(), labels.end()};
  }

  static std::size_t number_of_labels(const std::vector<Index>& labels)
  {
    const auto largest = std::max_element(labels.begin(), labels.end());
    return largest == labels.end() ? 0 : std::size_t(*largest) + 1;
  }

public:
  Segmentation(const Mesh& mesh, const val& options, const val& progress)
    : input_(mesh.input()), options_(read_options(options))
  {
    Progress visitor(progress);
    const Constraint_maps constraints(*input_, options);
    const mesh_file::Face_vectors features = read_features(*input_, options);
    label_of_triangle_.resize(input_->triangles.size());
    CGAL::segment_spectral_recursive<CGAL::Sequential_tag>(
      input_->soup.points, input_->triangles, CGAL::make_property_map(label_of_triangle_),
      segmentation::parameters::options(options_)
        .edge_is_constrained_map(constraints.constrained_edge_map())
        .edge_is_uncuttable_map(constraints.uncuttable_edge_map())
        .face_seed_map(constraints.seed_map())
        .face_group_map(constraints.group_map())
        .face_feature_map(boost::make_function_property_map<std::size_t>([&](std::size_t t)
          { return features[input_->polygon_of_triangle[t]]; }))
        .hierarchy(tree_).visitor(std::ref(visitor)));
  }

  std::size_t number_of_segments() const { return number_of_labels(label_of_triangle_); }
  std::size_t maximum_number_of_segments() const { return tree_.number_of_segments(); }

  val labels(const val& choice) const
  { return typed_array(segment_mesh::labels_of_polygons(*input_, labels_of_triangles(choice))); }

  val write(const std::string& extension, const val& choice) const
  {
    const std::vector<Index> of_triangles = labels_of_triangles(choice);
    const std::size_t number = number_of_labels(of_triangles);
    const std::vector<Index> of_faces = segment_mesh::labels_of_polygons(*input_, of_triangles);
    const std::vector<mesh_file::Rgb> colors = segment_mesh::segment_colors(
      segment_mesh::segment_neighbors(*input_, of_triangles, number));
    const segment_mesh::Refined_input refined =
      segment_mesh::Input_refinement(*input_, of_triangles)(of_faces);
    std::ostringstream out;
    mesh_file::write_mesh_file(out, extension,
                               {refined.input.soup, refined.segment, colors,
                                segment_mesh::part_tree(tree_, of_triangles, number)});
    return typed_array_of_bytes(out.str());
  }

  // Returns the output of `segment_mesh --hierarchy` without the numbers of polygons.
  std::string json() const
  {
    std::ostringstream out;
    segment_mesh::write_json(out, tree_, segment_mesh::json_of_hierarchy(tree_));
    return out.str();
  }

  // Returns the data that the viewer of `segment_mesh --html` shows, see page/decode.js.
  std::string page_data(const std::string& name) const
  {
    segment_mesh::Page_options options;
    options.name = name;
    options.number_of_segments = number_of_segments();
    options.is_salience_probability =
      options_.part_salience.target<segmentation::Calibrated_part_salience>() != nullptr;
    return segment_mesh::page_data(*input_, tree_, options)
      .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }
};

// Returns the error of an exception that came to JavaScript as a number.
val error_of(std::intptr_t exception)
{
  const auto* const e = reinterpret_cast<const std::exception*>(exception);
  val result = val::object();
  result.set("isMemory", dynamic_cast<const std::bad_alloc*>(e) != nullptr);
  result.set("message", std::string(e->what()));
  return result;
}

std::string version() { return CGAL_SPECTRAL_SEGMENTATION_VERSION; }

} // namespace web

EMSCRIPTEN_BINDINGS(spectral_segmentation)
{
  using namespace emscripten;
  function("version", &web::version);
  function("errorOf", &web::error_of);
  function("optionKinds", &web::option_kinds);
  class_<web::Mesh>("Mesh")
    .class_function("read", &web::Mesh::read)
    .class_function("ofArrays", &web::Mesh::of_arrays)
    .function("numberOfFaces", &web::Mesh::number_of_faces)
    .function("points", &web::Mesh::points)
    .function("triangles", &web::Mesh::triangles)
    .function("faceOfTriangle", &web::Mesh::face_of_triangle)
    .function("warnings", &web::Mesh::warnings);
  class_<web::Segmentation>("Segmentation")
    .constructor<const web::Mesh&, val, val>()
    .function("numberOfSegments", &web::Segmentation::number_of_segments)
    .function("maximumNumberOfSegments", &web::Segmentation::maximum_number_of_segments)
    .function("labels", &web::Segmentation::labels)
    .function("write", &web::Segmentation::write)
    .function("json", &web::Segmentation::json)
    .function("pageData", &web::Segmentation::page_data);
}
