// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_meshes.h"

#include <CGAL/Spectral_segmentation/internal/read/read_triangle_mesh.h>
#include <CGAL/Spectral_segmentation/internal/surface/connected_components.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace test_meshes {

Mesh mesh_of(const Soup& soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh mesh;
  if (!PMP::is_polygon_soup_a_polygon_mesh(soup.triangles))
    throw std::invalid_argument("the triangles do not form a manifold");
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  return mesh;
}

Soup plate(std::size_t nx, std::size_t ny)
{
  Soup soup;
  for (std::size_t y = 0; y <= ny; ++y)
    for (std::size_t x = 0; x <= nx; ++x)
      soup.points.emplace_back(double(x), double(y), 0.);
  for (std::size_t y = 0; y < ny; ++y)
    for (std::size_t x = 0; x < nx; ++x) {
      const std::size_t v = y * (nx + 1) + x;
      soup.triangles.push_back({v, v + 1, v + nx + 2});
      soup.triangles.push_back({v, v + nx + 2, v + nx + 1});
    }
  return soup;
}

Soup subdivided(const Soup& soup)
{
  Soup result;
  result.points = soup.points;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> midpoints;
  const auto midpoint = [&](std::size_t i, std::size_t j) {
    const auto [entry, is_new] = midpoints.emplace(std::minmax(i, j), result.points.size());
    if (is_new)
      result.points.push_back(CGAL::midpoint(soup.points[i], soup.points[j]));
    return entry->second;
  };
  for (const std::vector<std::size_t>& t : soup.triangles) {
    const std::size_t a = midpoint(t[0], t[1]), b = midpoint(t[1], t[2]), c = midpoint(t[2], t[0]);
    result.triangles.insert(result.triangles.end(),
                            {{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}});
  }
  return result;
}

Soup sphere(std::size_t level)
{
  Soup soup;
  const auto add = [&](double x, double y, double z) {
    const double norm = std::sqrt(x * x + y * y + z * z);
    soup.points.emplace_back(x / norm, y / norm, z / norm);
  };
  const double g = (1 + std::sqrt(5.)) / 2;
  for (double a : {-1., 1.})
    for (double b : {-g, g}) {
      add(a, b, 0);
      add(0, a, b);
      add(b, 0, a);
    }
  // Faces are the triples of vertices at the distance of an edge.
  const auto are_adjacent = [&](std::size_t i, std::size_t j)
  { return CGAL::squared_distance(soup.points[i], soup.points[j]) < 1.2; };
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k)
        if (are_adjacent(i, j) && are_adjacent(j, k) && are_adjacent(k, i)) {
          if (CGAL::orientation(Point(0, 0, 0), soup.points[i], soup.points[j], soup.points[k]) ==
              CGAL::POSITIVE)
            soup.triangles.push_back({i, j, k});
          else
            soup.triangles.push_back({i, k, j});
        }

  for (; level > 0; --level) {
    const Soup finer = subdivided(soup);
    for (std::size_t v = soup.points.size(); v < finer.points.size(); ++v)
      add(finer.points[v].x(), finer.points[v].y(), finer.points[v].z());
    soup.triangles = finer.triangles;
  }
  return soup;
}

Soup torus(double R, double r, std::size_t nu, std::size_t nv)
{
  Soup soup;
  for (std::size_t i = 0; i < nu; ++i)
    for (std::size_t j = 0; j < nv; ++j) {
      const double u = 2 * pi * double(i) / double(nu), v = 2 * pi * double(j) / double(nv);
      const double radius = R + r * std::cos(v);
      soup.points.emplace_back(radius * std::cos(u), radius * std::sin(u), r * std::sin(v));
    }
  for (std::size_t i = 0; i < nu; ++i)
    for (std::size_t j = 0; j < nv; ++j) {
      const std::size_t next_i = (i + 1) % nu, next_j = (j + 1) % nv;
      const std::size_t a = i * nv + j, b = next_i * nv + j, c = next_i * nv + next_j,
                        d = i * nv + next_j;
      soup.triangles.push_back({a, b, c});
      soup.triangles.push_back({a, c, d});
    }
  return soup;
}

Soup surface_of_revolution(const std::vector<std::pair<double, double> >& profile,
                                  std::size_t n_around)
{
  Soup soup;
  std::vector<std::vector<std::size_t> > rings; // one vertex at the axis
  for (const auto& [z, radius] : profile) {
    rings.emplace_back();
    for (std::size_t i = 0; i < (radius == 0 ? 1 : n_around); ++i) {
      const double u = 2 * pi * double(i) / double(n_around);
      rings.back().push_back(soup.points.size());
      soup.points.emplace_back(radius * std::cos(u), radius * std::sin(u), z);
    }
  }
  for (std::size_t k = 0; k + 1 < rings.size(); ++k)
    for (std::size_t i = 0; i < n_around; ++i) {
      const std::vector<std::size_t>&low = rings[k], &high = rings[k + 1];
      const std::size_t next = (i + 1) % n_around;
      if (low.size() > 1)
        soup.triangles.push_back({low[i], low[next], high[next % high.size()]});
      if (high.size() > 1)
        soup.triangles.push_back({low[i % low.size()], high[next], high[i]});
    }
  return soup;
}

Soup dumbbell(std::size_t n_around, std::size_t n_along)
{
  const double neck = 0.2, height = std::sqrt(1 - neck * neck);
  const double start = std::acos(height); // angle of the neck, seen from the center of a sphere
  std::vector<std::pair<double, double> > profile;
  for (std::size_t i = 0; i < n_along; ++i) {
    const double angle = pi + (start - pi) * double(i) / double(n_along);
    profile.emplace_back(-height + std::cos(angle), i == 0 ? 0 : std::sin(angle));
  }
  profile.emplace_back(0., neck);
  for (std::size_t i = n_along; i-- > 0;)
    profile.emplace_back(-profile[i].first, profile[i].second);
  return surface_of_revolution(profile, n_around);
}

Soup loose_triangles(const Soup& soup)
{
  Soup result;
  for (const auto& t : soup.triangles) {
    result.triangles.emplace_back();
    for (std::size_t v : t) {
      result.triangles.back().push_back(result.points.size());
      result.points.push_back(soup.points[v]);
    }
  }
  return result;
}

Soup scaled(Soup soup, double factor)
{
  return transformed(std::move(soup), [factor](const Point& p)
    { return Point(factor * p.x(), factor * p.y(), factor * p.z()); });
}

Soup moved(Soup soup, double x, double y, double z)
{
  return transformed(std::move(soup), [=](const Point& p)
    { return Point(p.x() + x, p.y() + y, p.z() + z); });
}

Soup turned_inside_out(Soup soup)
{
  for (std::vector<std::size_t>& t : soup.triangles)
    std::swap(t[1], t[2]);
  return soup;
}

Soup disjoint_union(Soup a, const Soup& b)
{
  const std::size_t offset = a.points.size();
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (std::vector<std::size_t> t : b.triangles) {
    for (std::size_t& v : t)
      v += offset;
    a.triangles.push_back(std::move(t));
  }
  return a;
}

Soup separate_triangles(std::size_t n)
{
  Soup soup;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = 10. * double(i);
    soup.points.insert(soup.points.end(), {{x, 0, 0}, {x + 1, 0, 0}, {x, 1 + double(i % 7), 0}});
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

Soup fan_at_edge(std::size_t n)
{
  Soup soup{{Point(0, 0, 0), Point(0, 0, 1)}, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * pi * double(i) / double(n);
    soup.points.emplace_back(std::cos(angle), std::sin(angle), 0.5);
    soup.triangles.push_back({0, 1, i + 2});
  }
  return soup;
}

Soup twisted_band(std::size_t n, std::size_t m, int half_turns)
{
  Soup soup;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= m; ++j) {
      const double angle = 2 * pi * double(i) / double(n), turn = half_turns * angle / 2,
                   side = 0.8 * double(j) / double(m) - 0.4, radius = 1 + side * std::cos(turn);
      soup.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                               side * std::sin(turn));
    }
  const auto vertex = [=](std::size_t i, std::size_t j) {
    if (i < n)
      return (m + 1) * i + j;
    return half_turns % 2 == 0 ? j : m - j;
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      const std::size_t a = vertex(i, j), c = vertex(i + 1, j + 1);
      soup.triangles.push_back({a, vertex(i + 1, j), c});
      soup.triangles.push_back({a, c, vertex(i, j + 1)});
    }
  return soup;
}

Soup connected_sum(const Soup& a, const Soup& b)
{
  Soup soup = disjoint_union(a, b);
  const std::size_t offset = a.points.size();
  const std::vector<std::size_t> hole = a.triangles.front(), other = b.triangles.front();
  soup.triangles.erase(soup.triangles.begin() + std::ptrdiff_t(a.triangles.size()));
  soup.triangles.erase(soup.triangles.begin());
  for (std::vector<std::size_t>& t : soup.triangles)
    for (std::size_t& v : t)
      for (std::size_t i = 0; i < 3; ++i)
        if (v == offset + other[i])
          v = hole[(3 - i) % 3];
  CGAL::Polygon_mesh_processing::remove_isolated_points_in_polygon_soup(soup.points,
                                                                        soup.triangles);
  return soup;
}

const std::vector<Soup>& small_soups()
{
  static const std::vector<Soup> result = {
    plate(1, 1), plate(4, 3), sphere(0), sphere(2), torus(2, 0.7, 3, 3), torus(2, 0.7, 9, 5),
    surface_of_revolution({{0, 0}, {1, 1}, {2, 1}}, 7), dumbbell(6, 4),
    connected_sum(torus(2, 0.7, 5, 4), torus(3, 1, 4, 6)), disjoint_union(sphere(0), plate(2, 2))};
  return result;
}

Soup pillow()
{ return {{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}, {2, 1, 0}}}; }

Point centroid(const Soup& soup, std::size_t face)
{
  const std::vector<std::size_t>& t = soup.triangles[face];
  return CGAL::centroid(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
}

Soup displaced(Soup soup, double amount, Random& random)
{
  std::uniform_real_distribution<double> offset(-amount, amount);
  for (Point& p : soup.points) {
    const double x = offset(random), y = offset(random), z = offset(random);
    p = Point(p.x() + x, p.y() + y, p.z() + z);
  }
  return soup;
}

Soup renumbered(const Soup& soup, Random& random, std::vector<std::size_t>& face)
{
  std::vector<std::size_t> vertex(soup.points.size());
  face.resize(soup.triangles.size());
  std::iota(vertex.begin(), vertex.end(), std::size_t(0));
  std::iota(face.begin(), face.end(), std::size_t(0));
  std::shuffle(vertex.begin(), vertex.end(), random);
  std::shuffle(face.begin(), face.end(), random);
  Soup result = soup;
  for (std::size_t v = 0; v < vertex.size(); ++v)
    result.points[vertex[v]] = soup.points[v];
  for (std::size_t f = 0; f < face.size(); ++f) {
    const std::vector<std::size_t>& t = soup.triangles[f];
    const std::size_t first = random() % 3;
    result.triangles[face[f]] = {vertex[t[first]], vertex[t[(first + 1) % 3]],
                                 vertex[t[(first + 2) % 3]]};
  }
  return result;
}

std::size_t random_number(Random& random, std::size_t smallest, std::size_t largest)
{ return smallest + random() % (largest - smallest + 1); }

Soup random_triangles(Random& random, std::size_t most_points, std::size_t most_triangles)
{
  Soup soup;
  const std::size_t number_of_points = random_number(random, 3, most_points);
  for (std::size_t v = 0; v < number_of_points; ++v) {
    const double x = double(random() % 4), y = double(random() % 4), z = double(random() % 4);
    soup.points.emplace_back(x, y, z);
  }
  const std::size_t number_of_triangles = random_number(random, 1, most_triangles);
  while (soup.triangles.size() < number_of_triangles) {
    const std::size_t a = random() % number_of_points, b = random() % number_of_points,
                      c = random() % number_of_points;
    if (a != b && b != c && c != a)
      soup.triangles.push_back({a, b, c});
  }
  return soup;
}

Surface read_surface(const Mesh& mesh)
{
  const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  return CGAL::Spectral_segmentation::internal::read_triangle_mesh(mesh, faces, mesh.points(),
                                                                   Kernel());
}

Surface read_surface(const Soup& soup) { return read_surface(mesh_of(soup)); }

Surface surface_of(const Mesh& mesh)
{
  namespace internal = CGAL::Spectral_segmentation::internal;
  Surface surface = read_surface(mesh);
  internal::normalize(surface.points);
  internal::set_areas(sequential, surface);
  surface.components = internal::connected_components(surface);
  return surface;
}

Surface surface_of(const Soup& soup) { return surface_of(mesh_of(soup)); }

double unit_of(const Soup& soup)
{
  Surface surface = read_surface(soup);
  return CGAL::Spectral_segmentation::internal::normalize(surface.points);
}

void set_face_distances(Surface& graph, const Distance_weights& weights)
{
  CGAL::Spectral_segmentation::internal::set_face_distances(
    sequential, graph, graph.points, face_normals(graph, graph.points), weights);
}

Surface graph_with_distances(const Soup& soup, const Distance_weights& weights)
{
  Surface graph = surface_of(soup);
  set_face_distances(graph, weights);
  return graph;
}

Surface random_part(const Surface& graph, std::size_t n, Random& random)
{
  std::vector<std::size_t> piece(graph.number_of_faces(), 1);
  std::vector<Index> front(1, Index(random() % graph.number_of_faces()));
  while (n > 0 && !front.empty()) {
    std::swap(front[random() % front.size()], front.back());
    const Index f = front.back();
    front.pop_back();
    if (piece[f] == 0)
      continue;
    piece[f] = 0;
    --n;
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      front.push_back(graph.neighbor(h));
  }
  return CGAL::Spectral_segmentation::internal::split(graph, piece, 2).front();
}

Soup read(const std::string& name)
{
  Soup soup;
  const std::string path = std::string(SPECTRAL_SEGMENTATION_TEST_DATA_DIR) + "/" + name;
  if (!CGAL::IO::read_polygon_soup(path, soup.points, soup.triangles))
    throw std::runtime_error("cannot read " + path);
  CGAL::Polygon_mesh_processing::orient_polygon_soup(soup.points, soup.triangles);
  return soup;
}

} // namespace test_meshes
