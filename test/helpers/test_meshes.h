// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_MESHES_H
#define SPECTRAL_SEGMENTATION_TEST_MESHES_H

#include <CGAL/Spectral_segmentation/internal/surface/Surface.h>
#include <CGAL/Spectral_segmentation/internal/weights/face_distances.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Triangle meshes with known properties. Faces are oriented outwards, counterclockwise.
namespace test_meshes {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

struct Soup
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t> > triangles;
};

constexpr double pi = 3.14159265358979323846;

// Vertices and faces of the mesh have the numbers of the soup, which must be a manifold.
Mesh mesh_of(const Soup& soup);

// A flat grid of nx * ny squares of side 1 in the plane z = 0, each cut in two, seen from above.
Soup plate(std::size_t nx, std::size_t ny);

// Splits each face in four at the midpoints of its edges. Face 4f + i is a part of face f.
Soup subdivided(const Soup& soup);

// The unit sphere: an icosahedron, each face cut in four `level` times; 20 * 4^level faces.
Soup sphere(std::size_t level);

// A torus around the z axis of radius R and tube radius r, with nu * nv squares cut in two.
Soup torus(double R, double r, std::size_t nu, std::size_t nv);

// The surface of revolution around the z axis with the given (z, radius), from the lowest z to the
// highest. It is closed at an end where the radius is 0, and open at others.
Soup surface_of_revolution(const std::vector<std::pair<double, double> >& profile,
                           std::size_t n_around);

// Two unit spheres along the z axis, joined by a thin concave neck of radius 0.2 at z = 0; closed.
Soup dumbbell(std::size_t n_around, std::size_t n_along);

// Each triangle on vertices of its own, at the same places.
Soup loose_triangles(const Soup& soup);

Soup scaled(Soup soup, double factor);

Soup moved(Soup soup, double x, double y, double z);

Soup turned_inside_out(Soup soup);

Soup disjoint_union(Soup a, const Soup& b);

// Makes n triangles on a line, far from each other.
Soup separate_triangles(std::size_t n);

// Makes n triangles at the edge from (0, 0, 0) to (0, 0, 1), in all directions around it.
Soup fan_at_edge(std::size_t n);

// Makes a ring of n by m squares of two triangles, with a radius of 1 and a width of 0.8, that is
// closed with a number of half turns.
Soup twisted_band(std::size_t n, std::size_t m, int half_turns);

// Joins two closed surfaces by removing the first triangle of each and identifying their vertices;
// the genera add up.
Soup connected_sum(const Soup& a, const Soup& b);

// Closed and open, connected and not.
const std::vector<Soup>& small_soups();

// Two triangles glued on all three edges.
Soup pillow();

// Moves each point to where a function has it.
template <class Function>
Soup transformed(Soup soup, const Function& function)
{
  for (Point& p : soup.points)
    p = function(p);
  return soup;
}

Point centroid(const Soup& soup, std::size_t face);

// Returns the value of a function at the centroid of each face.
template <class Value, class Function>
std::vector<Value> by_place(const Soup& soup, const Function& value_at)
{
  std::vector<Value> result;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    result.push_back(Value(value_at(centroid(soup, f))));
  return result;
}

typedef std::mt19937 Random;

// Moves each coordinate by up to `amount`.
Soup displaced(Soup soup, double amount, Random& random);

// Puts vertices and faces in a random order, and faces on a random corner. `face` gets the new
// number of each face.
Soup renumbered(const Soup& soup, Random& random, std::vector<std::size_t>& face);

std::size_t random_number(Random& random, std::size_t smallest, std::size_t largest);

// Returns triangles of three different points each, of few points.
Soup random_triangles(Random& random, std::size_t most_points, std::size_t most_triangles);

typedef CGAL::Spectral_segmentation::internal::Surface Surface;
typedef CGAL::Spectral_segmentation::internal::Index Index;
constexpr CGAL::Spectral_segmentation::internal::Execution sequential =
  CGAL::Spectral_segmentation::internal::Execution::SEQUENTIAL;

// Faces and vertices have the numbers of the mesh, in its own unit.
Surface read_surface(const Mesh& mesh);

Surface read_surface(const Soup& soup);

// Returns a surface without weights, whose faces and vertices have the numbers of the mesh. Points
// are normalized, like in a run.
Surface surface_of(const Mesh& mesh);

Surface surface_of(const Soup& soup);

// Returns the unit of the surface, in the coordinates of the soup.
double unit_of(const Soup& soup);

inline auto face_normals(const Surface& graph,
                         const std::vector<CGAL::Spectral_segmentation::internal::Vector>& points)
{ return CGAL::Spectral_segmentation::internal::face_normals(sequential, graph, points); }

typedef CGAL::Spectral_segmentation::internal::Distance_weights Distance_weights;
constexpr Distance_weights weights_of_paper = {0.01, 1, 0.1};
constexpr Distance_weights weights_of_calibrated_method = {0.03, 1, 0.1, 0.02};

void set_face_distances(Surface& graph, const Distance_weights& weights);

Surface graph_with_distances(const Soup& soup,
                             const Distance_weights& weights = weights_of_paper);

// Returns a connected part of n random faces. It may touch itself at a vertex, like parts of cuts.
Surface random_part(const Surface& graph, std::size_t n, Random& random);

// A mesh of the test data, oriented; vertices are duplicated where it is not a manifold.
Soup read(const std::string& name);

} // namespace test_meshes

#endif // SPECTRAL_SEGMENTATION_TEST_MESHES_H
