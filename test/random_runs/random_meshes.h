// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_TEST_FUZZ_RANDOM_MESHES_H
#define SPECTRAL_SEGMENTATION_TEST_FUZZ_RANDOM_MESHES_H

#include "box_figures.h"
#include "test_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

// Small triangle meshes and soups at random, damaged at random. A seed gives the same triangles on
// every machine: std::mt19937 does, its numbers are mapped here, and coordinates are rounded.
namespace random_runs {

using namespace test_meshes;

inline double random_fraction(Random& random) { return double(random() % 1025) / 1024; }

inline bool one_in(Random& random, unsigned n) { return random() % n == 0; }

template <class T>
T one_of(Random& random, const std::vector<T>& values)
{ return values[random() % values.size()]; }

// Removes the last digits, in which the functions of <cmath> differ between machines.
inline Soup rounded(Soup soup)
{
  const auto round = [](double x) { return std::nearbyint(std::ldexp(x, 20)) / 1048576; };
  for (Point& p : soup.points)
    p = Point(round(p.x()), round(p.y()), round(p.z()));
  return soup;
}

// Unit cubes that hang together, also by edges and vertices only. Their boundary has limbs, handles
// and hollows.
inline Soup random_cubes(Random& random)
{
  Cells cells = {{0, 0, 0}};
  const std::size_t n = random_number(random, 1, 25);
  while (cells.size() < n) {
    Cell cell = *std::next(cells.begin(), std::ptrdiff_t(random() % cells.size()));
    const std::size_t axis = random() % 3;
    cell[axis] += one_in(random, 2) ? 1 : -1;
    cells.insert(cell);
  }
  return boundary_of(cells);
}

// Triangles around one vertex, or at one edge.
inline Soup random_fan(Random& random)
{
  Soup soup;
  const std::size_t n = random_number(random, 1, 24);
  const bool is_book = one_in(random, 3);
  soup.points = {Point(0, 0, 0), Point(0, 0, 1)};
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * pi * double(i) / double(n), height = random_fraction(random);
    soup.points.emplace_back(std::cos(angle), std::sin(angle), is_book ? 0.5 : height);
    if (is_book)
      soup.triangles.push_back({0, 1, i + 2});
    else if (n > 2 || i + 1 < n)
      soup.triangles.push_back({0, i + 2, (i + 1) % n + 2});
  }
  return soup;
}

// A tube with narrow and wide places, open or closed.
inline Soup random_tube(Random& random)
{
  std::vector<std::pair<double, double> > profile;
  const std::size_t n = random_number(random, 2, 14);
  for (std::size_t i = 0; i <= n; ++i)
    profile.emplace_back(double(i), 0.25 + 2 * random_fraction(random));
  if (one_in(random, 2))
    profile.front().second = profile.back().second = 0;
  return surface_of_revolution(profile, random_number(random, 3, 9));
}

inline Soup random_piece(Random& random)
{
  const std::size_t m = random_number(random, 3, 14), n = random_number(random, 3, 8);
  switch (random() % 11) {
  case 0: return random_triangles(random, 15, 40);
  case 1: return random_fan(random);
  case 2: return rounded(twisted_band(m, 1, 1));
  case 3: return plate(m - 2, n - 2);
  case 4: return rounded(torus(3, 1, m, n));
  case 5: return rounded(dumbbell(m, n));
  case 6: return rounded(sphere(random() % 3));
  case 7: return rounded(random_tube(random));
  case 8: return rounded(connected_sum(sphere(random() % 3), torus(3, 1, m, 5)));
  case 9: return rounded(loose_triangles(torus(3, 1, m, 3)));
  default: return random_cubes(random);
  }
}

// Moves each coordinate by up to `amount`.
inline void add_noise(Soup& soup, double amount, Random& random)
{
  const auto offset = [&] { return amount * (2 * random_fraction(random) - 1); };
  for (Point& p : soup.points) {
    const double x = offset(), y = offset(), z = offset();
    p = Point(p.x() + x, p.y() + y, p.z() + z);
  }
}

inline void remove_triangles(Soup& soup, std::size_t one_of_how_many, Random& random)
{
  std::vector<std::vector<std::size_t> > rest;
  for (const std::vector<std::size_t>& t : soup.triangles)
    if (random() % one_of_how_many != 0)
      rest.push_back(t);
  if (!rest.empty())
    soup.triangles = std::move(rest);
}

// Adds a triangle at a corner or an edge of another, or with the corners of another.
inline void add_triangle(Soup& soup, Random& random)
{
  std::vector<std::size_t> t = one_of(random, soup.triangles);
  std::rotate(t.begin(), t.begin() + std::ptrdiff_t(random() % 3), t.end());
  for (std::size_t number_of_new = random() % 3; number_of_new > 0; --number_of_new) {
    const Point p = soup.points[t[number_of_new]];
    const double x = random_fraction(random), y = random_fraction(random);
    t[number_of_new] = soup.points.size();
    soup.points.emplace_back(p.x() + x, p.y() + y, p.z() + 1);
  }
  if (one_in(random, 2))
    std::swap(t[0], t[1]);
  soup.triangles.push_back(t);
}

inline void turn_triangles(Soup& soup, Random& random)
{
  const unsigned n = 1 + random() % 10;
  for (std::vector<std::size_t>& t : soup.triangles)
    if (one_in(random, n))
      std::swap(t[0], t[2]);
}

// Gives some points the place of others, or brings faces to a line.
inline void degenerate(Soup& soup, Random& random)
{
  for (std::size_t n = random_number(random, 1, 5); n > 0; --n) {
    const std::vector<std::size_t> t = one_of(random, soup.triangles);
    Point& p = soup.points[t[0]];
    switch (random() % 3) {
    case 0: p = soup.points[t[1]]; break;
    case 1: p = CGAL::midpoint(soup.points[t[1]], soup.points[t[2]]); break;
    default: p = soup.points[random() % soup.points.size()];
    }
  }
}

// Replaces corners by other points: everywhere, or at one triangle only, by any point, or by a new
// point at the same place.
inline void replace_corner(Soup& soup, Random& random)
{
  const std::size_t f = random() % soup.triangles.size(), i = random() % 3;
  const std::size_t old_corner = soup.triangles[f][i];
  std::size_t new_corner = random() % soup.points.size();
  if (one_in(random, 2)) {
    new_corner = soup.points.size();
    soup.points.push_back(Point(soup.points[old_corner]));
    soup.triangles[f][i] = new_corner;
  }
  else if (one_in(random, 2))
    soup.triangles[f][i] = new_corner;
  else
    for (std::vector<std::size_t>& t : soup.triangles)
      std::replace(t.begin(), t.end(), old_corner, new_corner);
}

inline void move_point_far(Soup& soup, Random& random)
{
  const double factor = std::ldexp(1., one_of(random, std::vector<int>{3, 6, 10, 20, 40, 300}));
  Point& p = soup.points[random() % soup.points.size()];
  p = Point(factor * p.x() + factor, p.y(), factor * p.z());
}

// Scales all axes or one, which may become flat, or moves the whole.
inline void transform(Soup& soup, Random& random)
{
  const int exponent =
    one_of(random, std::vector<int>{-900, -300, -60, -20, -3, 2, 10, 50, 300, 480, 600, 900});
  const double factor = 3 * std::ldexp(1., exponent);
  switch (random() % 4) {
  case 0: soup = scaled(std::move(soup), factor); break;
  case 1: soup = moved(std::move(soup), std::ldexp(1., exponent % 40), 0, 1); break;
  case 2:
    for (Point& p : soup.points)
      p = Point(p.x(), p.y(), 0);
    break;
  default:
    for (Point& p : soup.points)
      p = Point(p.x(), p.y(), std::ldexp(p.z(), exponent % 32));
  }
}

inline void add_component(Soup& soup, Random& random)
{
  const Soup other = one_in(random, 3) ? soup : random_piece(random);
  const double x = one_of(random, std::vector<double>{0, 0, 1, 5, 20});
  const double scale = one_of(random, std::vector<double>{1, 1, 0.5, 0.0625, 8});
  if (soup.triangles.size() + other.triangles.size() < 500)
    soup = disjoint_union(std::move(soup), moved(scaled(other, scale), x, 0, 0));
}

inline void damage(Soup& soup, Random& random)
{
  switch (random() % 13) {
  case 0: remove_triangles(soup, random_number(random, 2, 40), random); break;
  case 1: remove_triangles(soup, soup.triangles.size(), random); break; // one or so
  case 2:
    for (std::size_t n = random_number(random, 1, 6); n > 0; --n)
      add_triangle(soup, random);
    break;
  case 3: turn_triangles(soup, random); break;
  case 4: degenerate(soup, random); break;
  case 5: replace_corner(soup, random); break;
  case 6: move_point_far(soup, random); break;
  case 7: transform(soup, random); break;
  case 8:
  case 9: add_component(soup, random); break;
  case 10:
    for (std::size_t i = soup.triangles.size(); i > 1; --i)
      std::swap(soup.triangles[i - 1], soup.triangles[random() % i]);
    break;
  case 11: // a point without triangles
    soup.points.emplace_back(std::numeric_limits<double>::infinity(), 0, 0);
    break;
  default: add_noise(soup, std::ldexp(1., -int(random() % 12)), random);
  }
}

inline Soup random_soup(Random& random)
{
  Soup soup = random_piece(random);
  if (soup.triangles.empty())
    return soup;
  if (one_in(random, 2))
    add_noise(soup, 0.0625, random); // without symmetries
  for (std::size_t n = random() % 4; n > 0; --n)
    damage(soup, random);
  return soup;
}

// Makes the triangles no valid input.
inline void spoil(Soup& soup, Random& random)
{
  std::vector<std::size_t>& t = soup.triangles[random() % soup.triangles.size()];
  switch (random() % 3) {
  case 0: t[random() % 3] = soup.points.size() + random() % 3; break;
  case 1: t.pop_back(); break;
  default:
    soup.points[t[random() % 3]] = Point(0, std::numeric_limits<double>::quiet_NaN(), 0);
  }
}

} // namespace random_runs

#endif // SPECTRAL_SEGMENTATION_TEST_FUZZ_RANDOM_MESHES_H
