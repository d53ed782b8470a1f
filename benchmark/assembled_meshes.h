// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_ASSEMBLED_MESHES_H
#define SEGMENTATION_BENCHMARK_ASSEMBLED_MESHES_H

#include "Uniform_random.h"
#include "triangulations.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <queue>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The same shape put together from many closed components, as artists build their models. They
// refine what a person has made out, so that a segmentation has to unite them.
namespace segmentation_benchmark {

// Components are apart by gaps, or they intersect.
inline const std::vector<std::string>& assembly_names()
{
  static const std::vector<std::string> names = {"gaps", "intersecting"};
  return names;
}

inline bool is_assembly(const std::string& name)
{ return std::count(assembly_names().begin(), assembly_names().end(), name) != 0; }

inline double scale_of_components(const std::string& assembly)
{ return assembly == "gaps" ? 0.995 : 1.01; }

constexpr std::size_t number_of_cells = 30;
constexpr double least_share_of_faces = 0.002;

// Calls f(g) for each face g on the other side of an edge of a face.
template <class Function>
void for_each_neighbor(const Mesh& mesh, Mesh::Face_index face, const Function& f)
{
  for (Mesh::Face_index g : CGAL::faces_around_face(mesh.halfedge(face), mesh))
    if (g != Mesh::null_face())
      f(g);
}

// The first n faces of a random order.
inline std::vector<Mesh::Face_index> random_faces(const Mesh& mesh, std::size_t n,
                                                  Uniform_random& random)
{
  std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  n = (std::min)(n, faces.size());
  for (std::size_t i = 0; i < n; ++i)
    std::swap(faces[i], faces[i + random.below(faces.size() - i)]);
  faces.resize(n);
  return faces;
}

// For each face, which of the centers is the nearest by the number of edges between. Faces that no
// center reaches have the number of centers.
inline Labels cells(const Mesh& mesh, const std::vector<Mesh::Face_index>& centers)
{
  Labels result(mesh.number_of_faces(), centers.size());
  std::queue<Mesh::Face_index> front;
  for (std::size_t i = 0; i < centers.size(); ++i) {
    result[centers[i]] = i;
    front.push(centers[i]);
  }
  for (; !front.empty(); front.pop())
    for_each_neighbor(mesh, front.front(), [&](Mesh::Face_index g) {
      if (result[g] == centers.size()) {
        result[g] = result[front.front()];
        front.push(g);
      }
    });
  return result;
}

// The connected sets of faces that have one label in both segmentations.
inline Labels overlay(const Mesh& mesh, const Labels& a, const Labels& b)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  std::vector<char> is_seam(mesh.number_of_edges(), 0);
  for (Mesh::Edge_index e : mesh.edges())
    if (!mesh.is_border(e)) {
      const std::size_t f = mesh.face(mesh.halfedge(e, 0)), g = mesh.face(mesh.halfedge(e, 1));
      is_seam[e] = a[f] != a[g] || b[f] != b[g];
    }
  Labels sets(mesh.number_of_faces());
  PMP::connected_components(
    mesh, CGAL::make_property_map(sets),
    CGAL::parameters::edge_is_constrained_map(CGAL::make_property_map(is_seam)));
  return sets;
}

// Joins sets of too few faces, the smallest one first, to the neighbor that they have most edges in
// common with. A set that is a whole component of the mesh stays.
class Joiner_of_small_sets
{
  struct Set
  {
    std::size_t faces = 0;
    std::map<std::size_t, std::size_t> edges_in_common; // indexed by neighbor
  };

  Labels labels_;
  std::vector<Set> sets_;
  std::set<std::pair<std::size_t, std::size_t> > small_; // number of faces, set

  static std::size_t main_neighbor(const Set& set)
  {
    const auto& edges = set.edges_in_common;
    return std::max_element(edges.begin(), edges.end(), [](const auto& a, const auto& b)
                            { return a.second < b.second; })->first;
  }

  void unite(std::size_t from, std::size_t to)
  {
    for (const auto& [neighbor, edges] : sets_[from].edges_in_common) {
      sets_[neighbor].edges_in_common.erase(from);
      if (neighbor != to) {
        sets_[neighbor].edges_in_common[to] += edges;
        sets_[to].edges_in_common[neighbor] += edges;
      }
    }
    sets_[to].faces += sets_[from].faces;
    std::replace(labels_.begin(), labels_.end(), from, to);
  }

public:
  Joiner_of_small_sets(const Mesh& mesh, const Labels& labels)
    : labels_(labels), sets_(number_of_segments(labels))
  {
    for (Mesh::Face_index f : mesh.faces()) {
      Set& set = sets_[labels[f]];
      ++set.faces;
      for_each_neighbor(mesh, f, [&](Mesh::Face_index g) {
        if (labels[g] != labels[f])
          ++set.edges_in_common[labels[g]];
      });
    }
  }

  // No set but the whole components has fewer than `least` faces then.
  Labels operator()(double least)
  {
    const auto is_small = [&](std::size_t set)
    { return static_cast<double>(sets_[set].faces) < least; };
    for (std::size_t set = 0; set < sets_.size(); ++set)
      if (is_small(set))
        small_.emplace(sets_[set].faces, set);
    while (!small_.empty()) {
      const std::size_t smallest = small_.begin()->second;
      small_.erase(small_.begin());
      if (sets_[smallest].edges_in_common.empty())
        continue;
      const std::size_t to = main_neighbor(sets_[smallest]);
      small_.erase({sets_[to].faces, to});
      unite(smallest, to);
      if (is_small(to))
        small_.emplace(sets_[to].faces, to);
    }
    return contiguous(labels_);
  }
};

// The overlay of a segmentation with cells around random faces, without sets of few faces.
inline Labels component_labels(const Mesh& mesh, const Labels& segmentation, std::uint64_t seed)
{
  Uniform_random random(seed);
  const Labels of_cells = cells(mesh, random_faces(mesh, number_of_cells, random));
  const double least = least_share_of_faces * static_cast<double>(mesh.number_of_faces());
  return Joiner_of_small_sets(mesh, overlay(mesh, segmentation, of_cells))(least);
}

// Makes each set of faces a component of its own, scaled about the centroid of its faces and closed
// by a fan of triangles around the centroid of each border loop. Vertices where a set only touches
// itself come apart, so that any set becomes a closed manifold.
class Assembler
{
  const Mesh& mesh_;
  const Labels& sets_;
  double scale_;
  std::vector<Kernel::Point_3> centroids_;
  Mesh result_;
  std::vector<Mesh::Vertex_index> new_targets_; // one per halfedge with a face

  // Whether the set of the face ends at the halfedge.
  bool is_seam(Mesh::Halfedge_index h) const
  {
    const Mesh::Halfedge_index o = mesh_.opposite(h);
    return mesh_.is_border(o) || sets_[mesh_.face(o)] != sets_[mesh_.face(h)];
  }

  void compute_centroids()
  {
    std::vector<Kernel::Vector_3> sums(number_of_segments(sets_), CGAL::NULL_VECTOR);
    std::vector<double> faces(sums.size(), 0.);
    for (Mesh::Face_index f : mesh_.faces()) {
      sums[sets_[f]] += centroid(mesh_, f) - CGAL::ORIGIN;
      ++faces[sets_[f]];
    }
    for (std::size_t set = 0; set < sums.size(); ++set)
      centroids_.push_back(CGAL::ORIGIN + sums[set] / faces[set]);
  }

  // One vertex for the faces around the target that are connected within the set.
  void add_target(Mesh::Halfedge_index h)
  {
    Mesh::Halfedge_index first = h;
    while (!is_seam(first)) {
      first = mesh_.prev(mesh_.opposite(first));
      if (first == h)
        break;
    }
    const Kernel::Point_3& center = centroids_[sets_[mesh_.face(h)]];
    const Mesh::Vertex_index v =
      result_.add_vertex(center + scale_ * (mesh_.point(mesh_.target(h)) - center));
    for (h = first; ; h = mesh_.opposite(mesh_.next(h))) {
      new_targets_[h] = v;
      if (is_seam(mesh_.next(h)) || mesh_.opposite(mesh_.next(h)) == first)
        return;
    }
  }

  void add_face(Mesh::Vertex_index a, Mesh::Vertex_index b, Mesh::Vertex_index c)
  {
    if (result_.add_face(a, b, c) == Mesh::null_face())
      throw std::runtime_error("the components of a mesh are no manifold");
  }

  void add_faces()
  {
    for (Mesh::Halfedge_index h : mesh_.halfedges())
      if (!mesh_.is_border(h) && new_targets_[h] == Mesh::null_vertex())
        add_target(h);
    for (Mesh::Face_index f : mesh_.faces()) {
      const Mesh::Halfedge_index h = mesh_.halfedge(f), next = mesh_.next(h);
      add_face(new_targets_[h], new_targets_[next], new_targets_[mesh_.next(next)]);
    }
  }

  std::vector<Mesh::Halfedge_index> border_loop(Mesh::Halfedge_index first) const
  {
    std::vector<Mesh::Halfedge_index> loop;
    Mesh::Halfedge_index h = first;
    do {
      loop.push_back(h);
      h = mesh_.next(h);
      while (!is_seam(h))
        h = mesh_.next(mesh_.opposite(h));
    } while (h != first);
    return loop;
  }

  void close(const std::vector<Mesh::Halfedge_index>& loop)
  {
    Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
    for (Mesh::Halfedge_index h : loop)
      sum += result_.point(new_targets_[h]) - CGAL::ORIGIN;
    const Mesh::Vertex_index apex =
      result_.add_vertex(CGAL::ORIGIN + sum / static_cast<double>(loop.size()));
    Mesh::Vertex_index source = new_targets_[loop.back()];
    for (Mesh::Halfedge_index h : loop) {
      add_face(new_targets_[h], source, apex);
      source = new_targets_[h];
    }
  }

  void add_caps()
  {
    std::vector<char> is_closed(mesh_.number_of_halfedges(), 0);
    for (Mesh::Halfedge_index first : mesh_.halfedges())
      if (!mesh_.is_border(first) && is_seam(first) && !is_closed[first]) {
        const std::vector<Mesh::Halfedge_index> loop = border_loop(first);
        for (Mesh::Halfedge_index h : loop)
          is_closed[h] = 1;
        close(loop);
      }
  }

public:
  Assembler(const Mesh& mesh, const Labels& sets, double scale)
    : mesh_(mesh), sets_(sets), scale_(scale),
      new_targets_(mesh.number_of_halfedges(), Mesh::null_vertex())
  { compute_centroids(); }

  // The faces of the mesh come first and in their order.
  Mesh operator()()
  {
    add_faces();
    add_caps();
    return std::move(result_);
  }
};

inline Mesh assembled_from(const Labels& sets, const Mesh& mesh, double scale)
{ return Assembler(mesh, sets, scale)(); }

// Labels of caps are not carried back. The segmentation is a person's, the seed is that of the
// cells.
inline Retriangulated_mesh assembled(const std::string& assembly, const Mesh& mesh,
                                     const Labels& segmentation, std::uint64_t seed)
{
  Retriangulated_mesh result{assembled_from(component_labels(mesh, segmentation, seed), mesh,
                                            scale_of_components(assembly)), {}};
  for (Mesh::Face_index f : mesh.faces())
    result.faces_on.push_back({f});
  return result;
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_ASSEMBLED_MESHES_H
