// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PRIMITIVE_UNIONS_H
#define SEGMENTATION_BENCHMARK_PRIMITIVE_UNIONS_H

#include "Uniform_random.h"
#include "known_parts.h"
#include "primitives.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Mechanical parts whose segmentation is known: unions of primitives, as plates with bosses, pins
// and ribs, and shafts with flanges. All are made by a seed.
namespace segmentation_benchmark {

// A place on a primitive where another one can stand. Its frame has the origin on the surface and z
// outwards.
struct Seat
{
  Eigen::Isometry3d frame;
  double half_width, half_depth; // along x and y
  double least_sink, most_sink;  // so that what stands there overlaps the primitive, and shows
  double shaft_radius = 0;       // radius of a cylinder along z whose end this is
  double shaft_length = 0;
};

struct Primitive
{
  Mesh mesh; // in its final place
  std::vector<Seat> seats;
};

inline Eigen::Isometry3d translation(double x, double y, double z)
{ return Eigen::Isometry3d(Eigen::Translation3d(x, y, z)); }

inline Eigen::Isometry3d rotation(double angle, const Eigen::Vector3d& axis)
{ return Eigen::Isometry3d(Eigen::AngleAxisd(angle, axis)); }

// All coordinates are multiples of a power of two. This takes away what the libraries of machines
// differ by in sines and roots.
inline double on_grid(double x)
{ return std::ldexp(std::nearbyint(std::ldexp(x, 24)), -24); }

inline Mesh placed(Mesh mesh, const Eigen::Isometry3d& frame)
{
  for (Mesh::Vertex_index v : mesh.vertices()) {
    const Mesh::Point& p = mesh.point(v);
    const Eigen::Vector3d q = frame * Eigen::Vector3d(p.x(), p.y(), p.z());
    mesh.point(v) = Mesh::Point(on_grid(q.x()), on_grid(q.y()), on_grid(q.z()));
  }
  return mesh;
}

enum Kind { BOSS, PIN, CONE, PRISM, KNOB, RING, RIB, BLOCK, NUMBER_OF_KINDS };

// A primitive that is to stand on a seat.
struct Standing
{
  Kind kind;
  double radius;                 // radius of the circle that it covers; ribs are longer
  double length;                 // the length of a rib
  double sink;                   // how deep it begins
  double height, ratio;          // 0 to 1, of what is usual for its kind
  std::size_t sides, tube_sides; // the sides of its polygons
};

// Makes primitives, each on one that it has made before. Random numbers are taken one a statement,
// or in braces: compilers differ in the order in which they evaluate arguments.
class Primitive_composer
{
  Uniform_random& random_;
  std::vector<Primitive> primitives_;

  std::size_t number_of_sides() { return 4 * (3 + random_.below(8)); } // 12 to 40
  std::size_t number_of_tube_sides() { return 8 + 2 * random_.below(5); }

  // A seat on each side.
  void add_box(const Eigen::Isometry3d& frame, const Eigen::Vector3d& size)
  {
    Primitive result{placed(box(size.x(), size.y(), size.z()), frame), {}};
    for (int axis = 0; axis < 3; ++axis)
      for (double sign : {-1., 1.}) {
        Eigen::Matrix3d turn;
        turn.col(2) = sign * Eigen::Vector3d::Unit(axis);
        turn.col(0) = Eigen::Vector3d::Unit((axis + 1) % 3);
        turn.col(1) = turn.col(2).cross(turn.col(0));
        Eigen::Isometry3d side = Eigen::Isometry3d::Identity();
        side.linear() = turn;
        side.translation() = size[axis] / 2 * turn.col(2);
        result.seats.push_back({frame * side, size[(axis + 1) % 3] / 2, size[(axis + 2) % 3] / 2,
                                0.1 * size[axis], 0.6 * size[axis]});
      }
    primitives_.push_back(std::move(result));
  }

  // A seat on each flat end, and one on the side. The ends know the shaft, if it is one.
  void add_frustum(const Eigen::Isometry3d& frame, double r0, double r1, double z0, double z1,
                   std::size_t n)
  {
    Primitive result{placed(frustum(r0, r1, z0, z1, n), frame), {}};
    const double height = z1 - z0, shaft_radius = r0 == r1 && n > 8 ? r0 : 0;
    const auto add_end = [&](double radius, const Eigen::Isometry3d& end) {
      if (radius > 0)
        result.seats.push_back({frame * end, 0.7 * radius, 0.7 * radius, 0.1 * height,
                                0.6 * height, shaft_radius, height});
    };
    add_end(r1, translation(0, 0, z1));
    add_end(r0, translation(0, 0, z0) * rotation(CGAL_PI, Eigen::Vector3d::UnitX()));
    if (r0 == r1) {
      const Eigen::Isometry3d side =
        rotation(random_(0, 2 * CGAL_PI), Eigen::Vector3d::UnitZ()) *
        translation(r0, 0, (z0 + z1) / 2) * rotation(CGAL_PI / 2, Eigen::Vector3d::UnitY());
      result.seats.push_back({frame * side, height / 2, 0.6 * r0, 0.4 * r0, 0.8 * r0});
    }
    primitives_.push_back(std::move(result));
  }

  void add_sphere(const Eigen::Isometry3d& frame, double radius, std::size_t n)
  {
    Primitive result{placed(uv_sphere(radius, n), frame), {}};
    const Eigen::Isometry3d side =
      rotation(random_(0, CGAL_PI / 2), Eigen::Vector3d::UnitX()) * translation(0, 0, radius);
    result.seats.push_back({frame * side, 0.5 * radius, 0.5 * radius, 0.3 * radius, radius});
    primitives_.push_back(std::move(result));
  }

  void add_torus(const Eigen::Isometry3d& frame, double radius, double tube_radius, std::size_t n,
                 std::size_t m)
  { primitives_.push_back({placed(torus(radius, tube_radius, n, m), frame), {}}); }

  // A ring or a flange around a shaft.
  void add_around(const Seat& seat)
  {
    const Eigen::Isometry3d frame =
      seat.frame * translation(0, 0, -random_(0.1, 0.9) * seat.shaft_length);
    const std::size_t sides = number_of_sides();
    if (random_() < 0.4) {
      const double radius = seat.shaft_radius * random_(0.95, 1.1);
      const double tube_radius = seat.shaft_radius * random_(0.2, 0.4);
      add_torus(frame, radius, tube_radius, sides, number_of_tube_sides());
    }
    else {
      const double radius = seat.shaft_radius * random_(1.3, 2.5);
      const double half_height =
        random_(0.05, 0.25) * (std::min)(seat.shaft_length, 3 * seat.shaft_radius);
      add_frustum(frame, radius, radius, -half_height, half_height, sides);
    }
  }

  void add_standing(const Eigen::Isometry3d& frame, const Standing& s)
  {
    const auto add_round = [&](double r0, double r1, double height, std::size_t sides)
    { add_frustum(frame, r0, r1, -s.sink, height, sides); };
    const auto add_cuboid = [&](double width, double depth, double height) {
      add_box(frame * translation(0, 0, (height - s.sink) / 2), {width, depth, height + s.sink});
    };
    const double r = s.radius;
    switch (s.kind) {
    case BOSS:
      return add_round(r, r, r * (0.5 + 2 * s.height), s.sides);
    case PIN:
      return add_round(r / 2, r / 2, r * (2 + 2 * s.height), s.sides);
    case CONE: // a third of them have a tip
      return add_round(r, s.ratio < 0.3 ? 0 : 0.7 * r * s.ratio, r * (1 + 2 * s.height), s.sides);
    case PRISM:
      return add_round(r, r, r * (0.4 + 1.2 * s.height), 3 + s.sides / 4 % 4);
    case KNOB:
      return add_sphere(frame * translation(0, 0, 0.7 * r * s.height), r, s.sides);
    case RING:
      return add_torus(frame * translation(0, 0, r * (0.2 * s.height - 0.1)), 0.7 * r,
                       r * (0.2 + 0.15 * s.ratio), s.sides, s.tube_sides);
    case RIB:
      return add_cuboid(s.length, r * (0.2 + 0.2 * s.ratio), r * (0.6 + 1.2 * s.height));
    default:
      return add_cuboid(1.4 * r, r * (0.7 + 0.7 * s.ratio), r * (0.5 + 2 * s.height));
    }
  }

  // One, or twins on both sides of the middle.
  void add_on(const Seat& seat, bool may_have_twins)
  {
    Standing s;
    s.kind = static_cast<Kind>(random_.below(NUMBER_OF_KINDS));
    const bool has_twins = may_have_twins && random_() < 0.4;
    s.radius = (std::min)(seat.half_width, seat.half_depth) *
               (has_twins ? random_(0.2, 0.4) : random_(0.25, 0.85));
    s.length = 2 * (has_twins ? s.radius
                              : random_(s.radius, (std::max)(s.radius, 0.9 * seat.half_width)));
    s.sink = random_(seat.least_sink, seat.most_sink);
    s.height = random_();
    s.ratio = random_();
    s.sides = number_of_sides();
    s.tube_sides = number_of_tube_sides();

    const bool is_rib = s.kind == RIB;
    const double x_room = seat.half_width - (is_rib ? s.length / 2 : s.radius);
    const double y_room = seat.half_depth - s.radius;
    const double x = random_(has_twins ? 1.2 * s.radius : -x_room, x_room);
    const double y = random_(-y_room, y_room);
    const double any_turn = random_(0, 2 * CGAL_PI);
    const double turn = !is_rib ? any_turn : has_twins ? CGAL_PI / 2 : 0;
    const double tilt = random_() < 0.2 ? random_(0.1, 0.4) : 0;
    const auto add_at = [&](double x_of_one) {
      add_standing(seat.frame * translation(x_of_one, y, 0) *
                     rotation(turn, Eigen::Vector3d::UnitZ()) *
                     rotation(tilt, Eigen::Vector3d::UnitX()), s);
    };
    add_at(x);
    if (has_twins)
      add_at(-x);
  }

  Eigen::Isometry3d random_pose()
  {
    const Eigen::Vector3d axis{random_(-1, 1), random_(-1, 1), random_(-1, 1)};
    return rotation(random_(0, 2 * CGAL_PI), axis.normalized());
  }

  // A plate, a block, a shaft or a disk.
  void add_first()
  {
    const Eigen::Isometry3d pose = random_pose();
    const std::size_t kind = random_.below(5), sides = number_of_sides();
    if (kind < 2)
      add_box(pose, {random_(1.2, 2), random_(0.8, 1.2), random_(0.12, 0.3)});
    else if (kind == 2)
      add_box(pose, {random_(0.8, 1.5), random_(0.7, 1), random_(0.5, 0.9)});
    else {
      const bool is_shaft = kind == 3;
      const double radius = is_shaft ? random_(0.15, 0.35) : random_(0.6, 1);
      const double height = is_shaft ? 2 : random_(0.15, 0.5);
      add_frustum(pose, radius, radius, 0, height, sides);
    }
  }

public:
  explicit Primitive_composer(Uniform_random& random) : random_(random) {}

  std::vector<Primitive> operator()(std::size_t number)
  {
    primitives_.clear();
    add_first();
    while (primitives_.size() < number) {
      // Mostly on the first one.
      std::size_t below = random_() < 0.65 ? 0 : random_.below(primitives_.size());
      if (primitives_[below].seats.empty())
        below = 0;
      const std::vector<Seat>& seats = primitives_[below].seats;
      const Seat seat = seats[random_.below(seats.size())];
      if (seat.shaft_radius > 0 && random_() < 0.4)
        add_around(seat);
      else
        add_on(seat, number - primitives_.size() > 1);
    }
    return std::move(primitives_);
  }
};

typedef Mesh::Property_map<Mesh::Face_index, std::size_t> Face_origins;

inline Face_origins face_origins(Mesh& mesh, std::size_t origin)
{ return mesh.add_property_map<Mesh::Face_index, std::size_t>("f:origin", origin).first; }

// Hands on from which primitive a face stems. CGAL makes copies of a visitor.
class Origin_visitor : public CGAL::Polygon_mesh_processing::Corefinement::Default_visitor<Mesh>
{
  const Mesh* first_;
  Face_origins of_first_, of_second_;
  std::size_t of_split_face_ = 0;

  Face_origins& origins(const Mesh& mesh) { return &mesh == first_ ? of_first_ : of_second_; }

public:
  // Any other mesh is the second one.
  Origin_visitor(const Mesh& first, const Face_origins& of_first, const Face_origins& of_second)
    : first_(&first), of_first_(of_first), of_second_(of_second) {}

  void before_subface_creations(Mesh::Face_index f, const Mesh& mesh)
  { of_split_face_ = origins(mesh)[f]; }

  void after_subface_created(Mesh::Face_index f, const Mesh& mesh)
  { origins(mesh)[f] = of_split_face_; }

  void after_face_copy(Mesh::Face_index from, const Mesh& mesh, Mesh::Face_index to,
                       const Mesh& other)
  { origins(other)[to] = origins(mesh)[from]; }
};

// The same mesh with its vertices and faces in the order of their coordinates: in CGAL's result the
// order depends on addresses.
inline Mesh in_order(const Mesh& mesh, const Face_origins& origins)
{
  std::vector<Mesh::Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::sort(vertices.begin(), vertices.end(), [&](Mesh::Vertex_index a, Mesh::Vertex_index b)
            { return mesh.point(a) < mesh.point(b); });
  Mesh result;
  std::vector<Mesh::Vertex_index> new_vertex(mesh.num_vertices()); // also of those removed
  for (Mesh::Vertex_index v : vertices)
    new_vertex[v] = result.add_vertex(mesh.point(v));

  std::vector<std::pair<std::array<Mesh::Vertex_index, 3>, std::size_t> > faces;
  for (Mesh::Face_index f : mesh.faces()) {
    std::array<Mesh::Vertex_index, 3> corners;
    auto corner = corners.begin();
    for (Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      *corner++ = new_vertex[v];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    faces.emplace_back(corners, origins[f]);
  }
  std::sort(faces.begin(), faces.end());
  const Face_origins of_result = face_origins(result, 0);
  for (const auto& [corners, origin] : faces)
    of_result[result.add_face(corners[0], corners[1], corners[2])] = origin;
  return result;
}

// Nothing if CGAL finds none, which rounded points of intersection can cause.
inline std::optional<Mesh> united(const std::vector<Primitive>& primitives)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh result = primitives.front().mesh;
  face_origins(result, 0);
  for (std::size_t i = 1; i < primitives.size(); ++i) {
    Mesh next = primitives[i].mesh;
    const Face_origins origins = face_origins(result, 0); // those that it has
    const Origin_visitor visitor(result, origins, face_origins(next, i));
    try {
      if (!PMP::corefine_and_compute_union(
            result, next, result,
            CGAL::parameters::visitor(visitor).throw_on_self_intersection(true)))
        return std::nullopt;
    }
    catch (const std::exception&) {
      return std::nullopt;
    }
    result = in_order(result, origins);
  }
  return result;
}

// One piece, closed, without self-intersections.
inline bool is_solid(const Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  if (!CGAL::is_valid_polygon_mesh(mesh) || !CGAL::is_closed(mesh) ||
      PMP::does_self_intersect(mesh))
    return false;
  std::vector<std::size_t> components(mesh.number_of_faces());
  return PMP::connected_components(
    mesh, CGAL::make_property_map(components)) == 1;
}

inline Labels connected_pieces(Mesh& mesh)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const Face_origins origins = face_origins(mesh, 0); // those that the mesh has
  auto is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_seam", false).first;
  for (Mesh::Edge_index e : mesh.edges()) {
    const Mesh::Halfedge_index h = mesh.halfedge(e);
    is_seam[e] = origins[mesh.face(h)] != origins[mesh.face(mesh.opposite(h))];
  }
  Labels labels(mesh.number_of_faces());
  PMP::connected_components(mesh, CGAL::make_property_map(labels),
                            CGAL::parameters::edge_is_constrained_map(is_seam));
  return labels;
}

// Each primitive shows, and no piece is so small that it is not seen.
inline bool is_plain_to_see(const Mesh& mesh, const Face_origins& origins, const Labels& pieces,
                            std::size_t number_of_primitives)
{
  std::vector<bool> shows(number_of_primitives, false);
  std::vector<double> areas(number_of_segments(pieces), 0.);
  for (Mesh::Face_index f : mesh.faces()) {
    shows[origins[f]] = true;
    areas[pieces[f]] += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  }
  const double area = CGAL::Polygon_mesh_processing::area(mesh);
  return std::count(shows.begin(), shows.end(), false) == 0 &&
         *std::min_element(areas.begin(), areas.end()) >= least_share_of_area * area;
}

// Makes a union of three to eight primitives. Its parts are the connected pieces of the surface of
// one primitive. A union that CGAL fails to make, or that is no good
// part, is thrown away, and the next numbers of the seed make another one.
inline Known_parts primitive_union(std::uint64_t seed)
{
  Uniform_random random(seed);
  const std::size_t number = 3 + random.below(6);
  for (int attempt = 0; attempt < 1000; ++attempt) {
    std::optional<Mesh> mesh = united(Primitive_composer(random)(number));
    if (!mesh || !is_solid(*mesh))
      continue;
    Labels pieces = connected_pieces(*mesh);
    if (is_plain_to_see(*mesh, face_origins(*mesh, 0), pieces, number))
      return parts_of_mesh(std::to_string(seed), std::move(*mesh), std::move(pieces));
  }
  throw std::runtime_error("seed " + std::to_string(seed) + " makes no union of primitives");
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PRIMITIVE_UNIONS_H
