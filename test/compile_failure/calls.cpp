// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that the functions refuse.

#include <CGAL/Segmented_mesh/split_into_segments.h>
#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace params = CGAL::Spectral_segmentation::parameters;

const Mesh& mesh();
const CGAL::Spectral_segmentation::Segmentation_hierarchy& hierarchy();
Mesh::Property_map<Mesh::Face_index, int> ids();
Mesh::Property_map<Mesh::Face_index, double> fractions();
Mesh::Property_map<Mesh::Face_index, bool> flags();
Mesh::Property_map<Mesh::Face_index, std::string> names();
Mesh::Property_map<Mesh::Vertex_index, int> ids_of_vertices();
std::map<Mesh::Face_index, int> not_a_property_map();

std::size_t n_01 = CGAL::segment_spectral_recursive(mesh(), fractions()); // error: the values of the segment id map must be of an integer type
std::size_t n_02 = CGAL::segment_spectral_recursive(mesh(), flags());     // error: the values of the segment id map must be of an integer type
std::size_t n_03 = CGAL::segment_spectral_recursive(mesh(), ids(), 0.3);  // error: the last argument is not a pack of named parameters
std::size_t n_04 = CGAL::segment_spectral_recursive<CGAL::Parallel_tag>(mesh(), ids()); // error: Parallel_tag is enabled but TBB is unavailable
std::size_t n_05 = CGAL::segment_spectral_recursive(mesh(), ids(), CGAL::parameters::number_of_iterations(3)); // error: this pack holds a named parameter that the function does not use
std::size_t n_22 = CGAL::segment_spectral_recursive(mesh(), ids(), params::from(CGAL::parameters::verbose(true))); // error: this pack holds a named parameter that the function does not use

std::size_t n_06 = hierarchy().write(mesh(), ids(), {0}, params::random_seed(1)); // error: the labels of a Segmentation_hierarchy depend on no named parameter but face_index_map

std::size_t n_12 = CGAL::segment_spectral_recursive(mesh(), names());           // error: the values of the segment id map must be of an integer type
std::size_t n_13 = CGAL::segment_spectral_recursive(mesh(), ids_of_vertices()); // error: the keys of the segment id map must be the faces of the mesh
std::size_t n_14 = hierarchy().write(mesh(), ids_of_vertices(), {0}); // error: the keys of the segment id map must be the faces of the mesh
std::size_t n_15 = CGAL::segment_spectral_recursive(mesh(), not_a_property_map()); // error: the segment ids are given by a property map

// Points and triangles.

typedef std::vector<std::array<double, 3> > Points;
typedef std::vector<std::array<int, 3> > Triangles;

struct Ids_of_positions
{
  typedef std::size_t key_type;
  typedef int value_type;
  typedef void reference;
  typedef boost::writable_property_map_tag category;
  friend void put(const Ids_of_positions&, std::size_t, int) {}
};

std::size_t n_07 = CGAL::segment_spectral_recursive(Points(), Triangles(), Ids_of_positions()); // compiles
std::size_t n_08 = CGAL::segment_spectral_recursive(Points(), Triangles(), Ids_of_positions(), params::vertex_point_map(mesh().points())); // error: vertex_point_map, face_index_map and geom_traits apply to meshes
std::size_t n_09 = CGAL::segment_spectral_recursive(Points(), Triangles(), Ids_of_positions(), params::face_index_map(ids())); // error: vertex_point_map, face_index_map and geom_traits apply to meshes
std::size_t n_10 = CGAL::segment_spectral_recursive(Points(), Triangles(), Ids_of_positions(), params::geom_traits(Kernel())); // error: vertex_point_map, face_index_map and geom_traits apply to meshes
std::size_t n_11 = CGAL::segment_spectral_recursive(Points(), Triangles(), Ids_of_positions(), 0.3f); // error: the last argument is not a pack of named parameters
std::size_t n_16 = CGAL::segment_spectral_recursive(Points(), Triangles(), ids()); // error: the keys of the segment id map must be the faces of the mesh, or the positions of triangles

// Constraints with other keys, a result of another kind, and a visitor of another class.

struct No_visitor
{
  bool go_further() { return true; }
};

Mesh::Property_map<Mesh::Halfedge_index, bool> flags_of_halfedges();
std::map<int, Mesh> no_sequence;
No_visitor no_visitor;

std::size_t n_17 = CGAL::segment_spectral_recursive(mesh(), ids(), params::face_seed_map(ids_of_vertices())); // error: the keys of face_seed_map, face_group_map and face_feature_map must be the faces of the mesh
std::size_t n_18 = CGAL::segment_spectral_recursive(mesh(), ids(), params::edge_is_constrained_map(flags_of_halfedges())); // error: the keys of face_seed_map, face_group_map and face_feature_map must be the faces of the mesh
std::size_t n_19 = CGAL::segment_spectral_recursive(mesh(), ids(), params::number_of_segments("5")); // error: number_of_segments takes an integer
std::size_t n_20 = CGAL::segment_spectral_recursive(mesh(), ids(), params::visitor(std::ref(no_visitor))); // error: visitor takes a class derived from Segmentation_visitor
struct Misspelt_visitor : CGAL::Spectral_segmentation::Segmentation_visitor
{
  bool go_futher() { return false; }
};
std::size_t n_23 = CGAL::segment_spectral_recursive(mesh(), ids(), CGAL::parameters::visitor(Misspelt_visitor())); // error: visitor takes a class derived from Segmentation_visitor that redefines one of its functions; is a name misspelt
auto n_21 = CGAL::split_into_segments(mesh(), ids(), no_sequence); // error: the parts are received by a sequence of meshes
