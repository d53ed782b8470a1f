// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/segment_spectral_recursive.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

struct Center
{
  Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
  double weight = 0;

  void add(const Point& point, double w)
  {
    sum += w * (point - CGAL::ORIGIN);
    weight += w;
  }

  Point point() const { return CGAL::ORIGIN + sum / weight; }
};

// The center of each part, and of each boundary between two parts.
typedef boost::adjacency_list<boost::setS, boost::vecS, boost::undirectedS, Center, Center>
  Part_graph;

template <class SegmentIdMap>
Part_graph part_graph(const Mesh& mesh, SegmentIdMap segment_ids, std::size_t number_of_segments)
{
  Part_graph parts(number_of_segments);
  for (Mesh::Edge_index e : edges(mesh)) {
    const Mesh::Halfedge_index h = halfedge(e, mesh);
    const Point &p = mesh.point(source(h, mesh)), &q = mesh.point(target(h, mesh));
    const double length = std::sqrt(CGAL::squared_distance(p, q));
    const Point middle = CGAL::midpoint(p, q);
    const Mesh::Face_index f = face(h, mesh), g = face(opposite(h, mesh), mesh);
    for (Mesh::Face_index side : {f, g})
      if (side != Mesh::null_face())
        parts[segment_ids[side]].add(middle, length);
    if (!is_border(e, mesh) && segment_ids[f] != segment_ids[g])
      parts[add_edge(segment_ids[f], segment_ids[g], parts).first].add(middle, length);
  }
  return parts;
}

// Keeps only the two longest boundaries as joints where three parts touch each other.
Part_graph skeleton(const Part_graph& parts)
{
  typedef boost::graph_traits<Part_graph>::edge_descriptor Boundary;
  const auto minus_length = boost::make_function_property_map<Boundary>(
    [&](Boundary boundary) { return -parts[boundary].weight; });
  std::vector<Boundary> joints;
  boost::kruskal_minimum_spanning_tree(parts, std::back_inserter(joints),
                                       boost::weight_map(minus_length));

  Part_graph result(num_vertices(parts));
  for (std::size_t part : CGAL::make_range(vertices(parts)))
    result[part] = parts[part];
  for (Boundary joint : joints)
    add_edge(source(joint, parts), target(joint, parts), parts[joint], result);
  return result;
}

// Returns the ends of limbs: for each part with only one joint, the vertex farthest from it.
template <class SegmentIdMap>
std::map<std::size_t, Point> tips(const Mesh& mesh, SegmentIdMap segment_ids,
                                  const Part_graph& parts)
{
  std::map<std::size_t, Point> result;
  for (Mesh::Face_index f : faces(mesh)) {
    const std::size_t part = segment_ids[f];
    if (out_degree(part, parts) != 1)
      continue;
    const Point joint = parts[*out_edges(part, parts).first].point();
    Point& tip = result.emplace(part, joint).first->second;
    for (Mesh::Vertex_index v : vertices_around_face(halfedge(f, mesh), mesh))
      if (CGAL::has_larger_distance_to_point(joint, mesh.point(v), tip))
        tip = mesh.point(v);
  }
  return result;
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto segment_ids = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids);
  const Part_graph parts = skeleton(part_graph(mesh, segment_ids, n));
  std::cout << n << " parts, " << num_edges(parts) << " joints" << std::endl;

  std::ofstream out("skeleton.polylines.txt");
  for (const auto& joint : CGAL::make_range(edges(parts)))
    out << "3 " << parts[source(joint, parts)].point() << ' ' << parts[joint].point() << ' '
        << parts[target(joint, parts)].point() << '\n';
  for (const auto& [part, tip] : tips(mesh, segment_ids, parts))
    out << "2 " << parts[part].point() << ' ' << tip << '\n';
  return out.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
