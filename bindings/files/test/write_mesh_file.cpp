// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../write_mesh_file.h"

#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

BOOST_AUTO_TEST_SUITE(write_mesh_file)

using mesh_file::Index;
using mesh_file::Number_type;
using mesh_file::Point;
using mesh_file::Polygon_soup;
using mesh_file::Rgb;
using mesh_file::Segment_extraction;
using mesh_file::Segmented_soup;

typedef std::vector<std::vector<Index> > Faces;

namespace {

Polygon_soup soup_of(const std::vector<Point>& points, const Faces& faces)
{
  Polygon_soup soup;
  soup.points = points;
  for (const std::vector<Index>& face : faces) {
    soup.corners.insert(soup.corners.end(), face.begin(), face.end());
    soup.end_polygon();
  }
  return soup;
}

// The first point is used by no polygon, the others are those of the unit cube in the order of x, y
// and z as binary digits. The top, which is the second polygon, is a segment of its own.
struct Cube
{
  Polygon_soup soup;
  std::vector<Index> segment{0, 1, 0, 0, 0, 0};
  std::vector<Rgb> colors{{255, 0, 10}, {128, 200, 0}};

  Cube()
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<Point> points{{nan, nan, nan}};
    for (int i = 0; i < 8; ++i)
      points.push_back({i & 1 ? 1. : 0., i & 2 ? 1. : 0., i & 4 ? 1. : 0.});
    soup = soup_of(points, {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3},
                            {2, 4, 8, 6}});
  }

  Segmented_soup mesh() const { return {soup, segment, colors}; }
};

// Returns the output of a function.
template <class Writer, class... Arguments>
std::string written(const Writer& write, const Arguments&... arguments)
{
  std::ostringstream out;
  write(out, arguments...);
  return out.str();
}

std::string written_as(const std::string& extension, const Segmented_soup& mesh,
                       const std::string& materials = "")
{ return written(mesh_file::write_mesh_file, extension, mesh, materials); }

// A segment as a mesh of its own.
std::string written_part(const std::string& extension, const Segmented_soup& mesh, Index segment)
{
  const Polygon_soup part = Segment_extraction(mesh)(segment);
  const std::vector<Index> segments(part.number_of_polygons(), segment);
  return written_as(extension, {part, segments, mesh.colors});
}

// Takes numbers, the lowest byte first.
class Bytes
{
  std::string bytes_;
  std::size_t position_ = 0;

public:
  explicit Bytes(const std::string& bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size() - position_; }

  std::string text(std::size_t size)
  {
    BOOST_REQUIRE(size <= left());
    position_ += size;
    return bytes_.substr(position_ - size, size);
  }

  template <class Number>
  Number take()
  {
    std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t> bits = 0;
    unsigned shift = 0;
    for (char c : text(sizeof(Number))) {
      bits |= static_cast<decltype(bits)>(static_cast<unsigned char>(c)) << shift;
      shift += 8;
    }
    if constexpr (std::is_integral_v<Number>)
      return static_cast<Number>(bits);
    else {
      Number result;
      std::memcpy(&result, &bits, sizeof result);
      return result;
    }
  }

  template <class Number>
  std::vector<double> take(std::size_t count)
  {
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i)
      result.push_back(static_cast<double>(take<Number>()));
    return result;
  }
};

typedef std::vector<double> Numbers;

// The header, and what follows it.
std::string ply_header(const std::string& ply)
{ return ply.substr(0, ply.find("end_header\n") + 11); }

Bytes ply_body(const std::string& ply) { return Bytes(ply.substr(ply_header(ply).size())); }

bool contains(const std::string& text, const std::string& part)
{ return text.find(part) != std::string::npos; }

struct Glb
{
  nlohmann::json json;
  std::string data;

  explicit Glb(const std::string& file)
  {
    Bytes bytes(file);
    BOOST_TEST(bytes.text(4) == "glTF");
    BOOST_TEST(bytes.take<std::uint32_t>() == 2u);
    BOOST_TEST(bytes.take<std::uint32_t>() == file.size());
    json = nlohmann::json::parse(chunk(bytes, "JSON"));
    if (bytes.left() > 0)
      data = chunk(bytes, std::string("BIN\0", 4));
    BOOST_TEST(bytes.left() == 0u);
  }

  static std::string chunk(Bytes& bytes, const std::string& type)
  {
    const std::uint32_t size = bytes.take<std::uint32_t>();
    BOOST_TEST(size % 4 == 0u);
    BOOST_TEST(bytes.text(4) == type);
    return bytes.text(size);
  }

  // The bytes of an accessor that has a view of its own.
  Bytes accessor(std::size_t i) const
  {
    const std::size_t number = json["accessors"][i]["bufferView"];
    const nlohmann::json& view = json["bufferViews"][number];
    BOOST_TEST(view["byteOffset"].get<int>() % 4 == 0);
    return Bytes(data.substr(view["byteOffset"], view["byteLength"]));
  }

  // Returns six times the volume of the tetrahedra between the triangles of a mesh and the origin.
  double six_volumes(std::size_t mesh) const
  {
    const nlohmann::json& primitive = json["meshes"][mesh]["primitives"][0];
    const std::size_t points = primitive["attributes"]["POSITION"], corners = primitive["indices"];
    const std::size_t number_of_points = json["accessors"][points]["count"];
    const Numbers p = accessor(points).take<float>(3 * number_of_points);
    const Numbers c = accessor(corners).take<std::uint32_t>(json["accessors"][corners]["count"]);
    double result = 0;
    for (std::size_t i = 0; i < c.size(); i += 3) {
      const double* v[3];
      for (std::size_t k = 0; k < 3; ++k)
        v[k] = &p.at(3 * static_cast<std::size_t>(c[i + k]));
      for (std::size_t k = 0; k < 3; ++k)
        result += v[0][k] * (v[1][(k + 1) % 3] * v[2][(k + 2) % 3] -
                             v[1][(k + 2) % 3] * v[2][(k + 1) % 3]);
    }
    return result;
  }
};

bool is_too_large(const std::runtime_error& e) { return contains(e.what(), "too large"); }

} // namespace

BOOST_AUTO_TEST_CASE(ply_has_points_split_at_seams)
{
  Cube cube;
  cube.soup.point_properties = {{"red", Number_type::UINT8, Numbers(9, 1)},
                                {"quality", Number_type::FLOAT32, {9, 0, 1, 2, 3, 4, 5, 6, 7.5}}};
  cube.soup.polygon_properties = {{"segment", Number_type::INT32, Numbers(6, 9)},
                                  {"weight", Number_type::INT16, {0, -1, 2, 3, 4, 5}}};
  const std::string ply = written_as(".ply", cube.mesh());
  BOOST_TEST(ply_header(ply) ==
    "ply\nformat binary_little_endian 1.0\nelement vertex 12\n"
    "property double x\nproperty double y\nproperty double z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\n"
    "element face 6\nproperty list uchar int vertex_indices\nproperty int segment\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty short weight\n"
    "end_header\n");

  Bytes body = ply_body(ply);
  for (int i = 0; i < 12; ++i) {
    const int v = i < 8 ? i : i - 4; // those of the top come again, for the sides
    BOOST_TEST(body.take<double>(3) == (Numbers{v & 1 ? 1. : 0., v & 2 ? 1. : 0., v & 4 ? 1. : 0.}),
               boost::test_tools::per_element());
    BOOST_TEST(body.take<std::uint8_t>(3) ==
               (i >= 4 && i < 8 ? Numbers{128, 200, 0} : Numbers{255, 0, 10}),
               boost::test_tools::per_element());
    BOOST_TEST(body.take<float>() == (v == 7 ? 7.5f : static_cast<float>(v)));
  }
  const std::vector<Numbers> faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 9, 8}, {2, 10, 11, 3},
                                   {0, 8, 10, 2}, {1, 3, 11, 9}};
  for (std::size_t i = 0; i < 6; ++i) {
    BOOST_TEST(body.take<std::uint8_t>() == 4);
    BOOST_TEST(body.take<std::int32_t>(4) == faces[i], boost::test_tools::per_element());
    BOOST_TEST(body.take<std::int32_t>() == (i == 1 ? 1 : 0));
    BOOST_TEST(body.take<std::uint8_t>(3) == (i == 1 ? Numbers{128, 200, 0} : Numbers{255, 0, 10}),
               boost::test_tools::per_element());
    BOOST_TEST(body.take<std::int16_t>() == (i == 1 ? -1 : static_cast<int>(i)));
  }
  BOOST_TEST(body.left() == 0u);
}

BOOST_AUTO_TEST_CASE(ply_has_the_types_of_the_input)
{
  Cube cube;
  cube.soup.coordinate_type = Number_type::FLOAT32;
  const std::string ply = written_as(".ply", cube.mesh());
  BOOST_TEST(contains(ply_header(ply), "property float x\nproperty float y\nproperty float z\n"));
  BOOST_TEST(ply.size() - ply_header(ply).size() == 12u * (3 * 4 + 3) + 6 * (1 + 4 * 4 + 4 + 3));
}

BOOST_AUTO_TEST_CASE(ply_with_large_and_empty_polygons)
{
  for (Index size : {255, 256}) {
    std::vector<Index> polygon;
    for (Index v = 0; v < size; ++v)
      polygon.push_back(v);
    const Polygon_soup soup = soup_of(std::vector<Point>(size, Point{1, 2, 3}), {{}, polygon});
    const std::vector<Index> segment{0, 0};
    const std::vector<Rgb> colors{{1, 2, 3}};
    const std::string ply = written_as(".ply", {soup, segment, colors});
    BOOST_TEST(contains(ply, size == 255 ? "list uchar int" : "list uint int"));
    Bytes body = ply_body(ply);
    body.text(size * (3 * 8 + 3));
    const auto take_size = [&]
    { return size == 255 ? body.take<std::uint8_t>() : body.take<std::uint32_t>(); };
    BOOST_TEST(take_size() == 0u);
    body.text(4 + 3);
    BOOST_TEST(take_size() == size);
    BOOST_TEST(body.take<std::int32_t>(size) == Numbers(polygon.begin(), polygon.end()),
               boost::test_tools::per_element());
    BOOST_TEST(body.left() == 4u + 3);
  }
}

BOOST_AUTO_TEST_CASE(part_has_the_numbers_of_its_polygons)
{
  Cube cube;
  cube.soup.polygon_properties = {{"face", Number_type::UINT8, Numbers(6, 77)}};
  const std::string ply = written_part(".ply", cube.mesh(), 1);
  BOOST_TEST(contains(ply, "element vertex 4\n"));
  BOOST_TEST(contains(ply, "element face 1\n"));
  BOOST_TEST(contains(ply, "property uchar blue\nproperty int face\nend_header\n"));
  Bytes body = ply_body(ply);
  body.text(4 * (3 * 8 + 3));
  BOOST_TEST(body.take<std::uint8_t>() == 4);
  BOOST_TEST(body.take<std::int32_t>(4) == (Numbers{0, 1, 2, 3}), boost::test_tools::per_element());
  BOOST_TEST(body.take<std::int32_t>() == 1); // its segment
  body.text(3);
  BOOST_TEST(body.take<std::int32_t>() == 1); // its number
  BOOST_TEST(body.left() == 0u);
}

BOOST_AUTO_TEST_CASE(obj_has_groups_and_materials)
{
  const Cube cube;
  BOOST_TEST(written_as(".obj", cube.mesh(), "a b.mtl") ==
    "mtllib a b.mtl\n"
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
    "g segment_000\nusemtl segment_000\n"
    "f 1 3 4 2\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
    "g segment_001\nusemtl segment_001\nf 5 6 8 7\n");
  BOOST_TEST(written(mesh_file::write_mtl, cube.mesh(), std::vector<std::string>()) ==
    "newmtl segment_000\nKd 1 0 0.039215688\nnewmtl segment_001\nKd 0.5019608 0.78431374 0\n");
}

BOOST_AUTO_TEST_CASE(obj_keeps_texture_coordinates_and_normals)
{
  const Index none = mesh_file::null_index;
  Polygon_soup soup = soup_of({{0.1f, 0, 0}, {1, 0, 0}, {0, -2.5, 0}, {1e300, 0, 0}},
                              {{0, 1, 2}, {2, 3, 1}, {0, 1}});
  soup.texture_coordinates = {{0.25, 1, 0, 0}, {0, 0.5, 0, 0}};
  soup.texture_of_corner = {0, none, 1, 1, none, 1, 0, 0};
  soup.normals = {{1, 0, 0}, {0, 0, 1}};
  soup.normal_of_corner = {0, 1, none, none, none, 1, 0, 0};
  const std::vector<Index> segment{1000, 2, 2};
  const std::vector<Rgb> colors(1001);
  const Segmented_soup mesh{soup, segment, colors};
  BOOST_TEST(written_as(".obj", mesh) ==
    "v 0.10000000149011612 0 0\nv 1 0 0\nv 0 -2.5 0\nv 1e+300 0 0\n"
    "vt 0.25 1\nvt 0 0.5\nvn 1 0 0\nvn 0 0 1\n"
    "g segment_002\nf 3/2 4 2/2/2\ng segment_1000\nf 1/1/1 2//2 3/2\n");
  soup.coordinate_type = Number_type::FLOAT32;
  BOOST_TEST(written_part(".obj", mesh, 1000) ==
    "v 0.1 0 0\nv 1 0 0\nv 0 -2.5 0\nvt 0.25 1\nvt 0 0.5\nvn 1 0 0\nvn 0 0 1\n"
    "g segment_1000\nf 1/1/1 2//2 3/2\n");
}

BOOST_AUTO_TEST_CASE(obj_keeps_materials)
{
  Cube cube;
  const auto bytes = std::make_shared<const std::string>("\x89PNG");
  cube.soup.images = {{"lost.tga", nullptr}, {"a.png", bytes}};
  const mesh_file::Material::Statement red{"Kd 1 0 0"};
  cube.soup.materials = {{"red", {red, {"map_Kd -s 2", 1}}, {}},
                         {"red", {{"map_Ka", 0}}, {}}, {"unused", {}, {}}};
  const Index none = mesh_file::null_index;
  cube.soup.material_of_polygon = {0, 0, none, 0, 1, 1};
  Segmented_soup mesh = cube.mesh();
  mesh.keeps_materials = true;
  BOOST_TEST(contains(written_as(".obj", mesh, "a.mtl"),
    "g segment_000\nusemtl red\nf 1 3 4 2\nusemtl plain\nf 1 2 6 5\nusemtl red\nf 3 7 8 4\n"
    "usemtl red_\nf 1 5 7 3\nf 2 4 8 6\ng segment_001\nusemtl red\nf 5 6 8 7\n"));
  const std::vector<std::string> files{"", "mesh_texture_001.png"};
  BOOST_TEST(written(mesh_file::write_mtl, mesh, files) ==
    "newmtl red\nKd 1 0 0\nmap_Kd -s 2 mesh_texture_001.png\nnewmtl red_\nmap_Ka lost.tga\n"
    "newmtl plain\nKd 0.8 0.8 0.8\n");

  const Polygon_soup part = Segment_extraction(mesh)(1);
  const std::vector<Index> segment{1};
  BOOST_TEST(written(mesh_file::write_mtl, Segmented_soup{part, segment, cube.colors, {}, {}, true},
                     files) == "newmtl red\nKd 1 0 0\nmap_Kd -s 2 mesh_texture_001.png\n");
  BOOST_TEST(mesh_file::names_for_mtl({{"", {}, {}}, {" a ", {}, {}}, {"x\ny", {}, {}}}) ==
               (std::vector<std::string>{"material_", "material a _", "x_y", "plain"}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(off_has_colors_of_faces)
{
  BOOST_TEST(written_as(".off", Cube().mesh()) ==
    "OFF\n8 6 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
    "4 0 2 3 1 255 0 10\n4 4 5 7 6 128 200 0\n4 0 1 5 4 255 0 10\n4 2 6 7 3 255 0 10\n"
    "4 0 4 6 2 255 0 10\n4 1 3 7 5 255 0 10\n");
}

BOOST_AUTO_TEST_CASE(files_of_many_blocks)
{
  std::vector<Point> points;
  Faces faces;
  for (Index i = 0; i < 100000; ++i) {
    points.push_back({i / 3., -i / 7., 1e-9 * i});
    faces.push_back({i, (i + 1) % 100000, i * 7 % 100000});
  }
  const Polygon_soup soup = soup_of(points, faces);
  const std::vector<Index> segment(faces.size(), 0);
  const std::vector<Rgb> colors{{1, 2, 3}};
  const std::string off = written_as(".off", {soup, segment, colors});
  std::istringstream in(off.substr(std::strlen("OFF\n100000 100000 0\n")));
  bool is_same = true;
  for (const Point& p : points)
    for (double c : p) {
      std::string word;
      is_same = in >> word && std::stod(word) == c && is_same;
    }
  for (const std::vector<Index>& face : faces)
    for (Index expected : {Index(3), face[0], face[1], face[2], Index(1), Index(2), Index(3)}) {
      Index i;
      is_same = in >> i && i == expected && is_same;
    }
  BOOST_TEST(is_same);
  std::string rest;
  BOOST_TEST(!(in >> rest));
}

BOOST_AUTO_TEST_CASE(stl_has_triangles_with_normals)
{
  const std::string stl = written_part(".stl", Cube().mesh(), 1);
  BOOST_TEST(stl.size() == 84u + 2 * 50);
  Bytes bytes(stl);
  BOOST_TEST(bytes.text(80).compare(0, 5, "solid") != 0);
  BOOST_TEST(bytes.take<std::uint32_t>() == 2u);
  for (int i = 0; i < 2; ++i) {
    BOOST_TEST(bytes.take<float>(3) == (Numbers{0, 0, 1}), boost::test_tools::per_element());
    const Numbers p = bytes.take<float>(9);
    BOOST_TEST((p[3] - p[0]) * (p[7] - p[1]) - (p[4] - p[1]) * (p[6] - p[0]) == 1);
    BOOST_TEST((Numbers{p[2], p[5], p[8]}) == Numbers(3, 1), boost::test_tools::per_element());
    BOOST_TEST(bytes.take<std::uint16_t>() == 0);
  }
  Polygon_soup flat = soup_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  const std::vector<Index> segment{0};
  const std::vector<Rgb> colors(1);
  Bytes no_area(written_as(".stl", {flat, segment, colors}).substr(84));
  BOOST_TEST(no_area.take<float>(3) == Numbers(3, 0), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(glb_has_a_mesh_for_each_segment)
{
  const Glb glb(written_as(".glb", Cube().mesh()));
  const nlohmann::json& json = glb.json;
  BOOST_TEST(json["asset"]["version"] == "2.0");
  BOOST_TEST(json["scenes"][0]["nodes"] == nlohmann::json::array({0}));
  BOOST_TEST(json["nodes"].size() == 3u);
  BOOST_TEST(json["nodes"][0]["children"] == nlohmann::json::array({1, 2}));
  BOOST_TEST(json["buffers"].size() == 1u);
  BOOST_TEST(json["buffers"][0]["byteLength"] == glb.data.size());
  BOOST_TEST(glb.data.size() == 12u * (8 + 4) + 4 * 3 * (10 + 2));
  for (std::size_t s = 0; s < 2; ++s) {
    const std::string name = s == 0 ? "segment_000" : "segment_001";
    BOOST_TEST(json["nodes"][1 + s]["name"] == name);
    BOOST_TEST(json["nodes"][1 + s]["mesh"] == s);
    BOOST_TEST(json["meshes"][s]["name"] == name);
    BOOST_TEST(json["materials"][s]["name"] == name);
    const nlohmann::json& primitive = json["meshes"][s]["primitives"].at(0);
    BOOST_TEST(primitive["material"] == s);
    BOOST_TEST(primitive["attributes"].size() == 1u);
    const std::size_t position = primitive["attributes"]["POSITION"];
    const nlohmann::json& points = json["accessors"][position];
    BOOST_TEST(points["componentType"] == 5126);
    BOOST_TEST(points["type"] == "VEC3");
    BOOST_TEST(points["count"] == (s == 0 ? 8 : 4));
    BOOST_TEST(points["min"] == nlohmann::json({0., 0., s == 0 ? 0. : 1.}));
    BOOST_TEST(points["max"] == nlohmann::json({1., 1., 1.}));
    const nlohmann::json& corners = json["accessors"][primitive["indices"].get<int>()];
    BOOST_TEST(corners["componentType"] == 5125);
    BOOST_TEST(corners["type"] == "SCALAR");
    BOOST_TEST(corners["count"] == (s == 0 ? 30 : 6));
  }
  // Only the pyramids of the three far sides, with their tip at the origin, have a volume.
  BOOST_TEST(glb.six_volumes(0) == 4);
  BOOST_TEST(glb.six_volumes(1) == 2);
}

BOOST_AUTO_TEST_CASE(glb_keeps_materials)
{
  Cube cube;
  const auto bytes = std::make_shared<const std::string>("\xFF\xD8\xFF of five");
  cube.soup.images = {{"lost.tga", nullptr}, {"a.jpg", bytes}};
  cube.soup.materials = {
    {"two", {}, R"({"normalTexture":{"index":0},"pbrMetallicRoughness":{"baseColorTexture":)"
                R"({"index":1,"sampler":{"wrapS":33071},"texCoord":1}},"extensions":{"B":{}}})"},
    {"unused", {}, "{}"}, {"broken", {}, "{"}};
  const Index none = mesh_file::null_index;
  cube.soup.material_of_polygon = {0, 2, none, 0, 0, 0};
  // The first polygon has two points with the same, and one without texture coordinates.
  cube.soup.texture_coordinates = {{0.25, 1, 0.5, 0.75}, {NAN, 1e300, 0, 0}};
  cube.soup.texture_of_corner.assign(24, 0);
  cube.soup.texture_of_corner[2] = 1;
  cube.soup.texture_of_corner[3] = none;
  cube.soup.normals = {{0, 0, -2}, {0, 0, 0}};
  cube.soup.normal_of_corner.assign(24, 0);
  cube.soup.normal_of_corner[8] = none; // in the polygon without material
  cube.soup.normal_of_corner[4] = 1;    // in the one with a broken material
  Segmented_soup mesh = cube.mesh();
  mesh.keeps_materials = true;
  const Glb glb(written_as(".glb", mesh));
  const nlohmann::json& json = glb.json;

  BOOST_TEST(json["materials"].size() == 3u);
  BOOST_TEST(json["materials"][1]["name"] == "plain");
  BOOST_TEST(json["materials"][2] == nlohmann::json({{"name", "broken"}}));
  BOOST_TEST(json["extensionsUsed"] == nlohmann::json::array({"B"}));
  const nlohmann::json& two = json["materials"][0];
  const std::size_t color = two["pbrMetallicRoughness"]["baseColorTexture"]["index"];
  const std::size_t normal = two["normalTexture"]["index"];
  BOOST_TEST(!two["pbrMetallicRoughness"]["baseColorTexture"].contains("sampler"));
  const std::size_t sampler = json["textures"][color]["sampler"];
  BOOST_TEST(json["samplers"][sampler] == nlohmann::json({{"wrapS", 33071}}));
  BOOST_TEST(!json["textures"][normal].contains("sampler"));
  BOOST_TEST(json["images"][json["textures"][normal]["source"].get<int>()] ==
             nlohmann::json({{"name", "lost.tga"}, {"uri", "lost.tga"}}));
  const nlohmann::json& image = json["images"][json["textures"][color]["source"].get<int>()];
  BOOST_TEST(image["mimeType"] == "image/jpeg");
  const nlohmann::json& view = json["bufferViews"][image["bufferView"].get<int>()];
  BOOST_TEST(glb.data.substr(view["byteOffset"], view["byteLength"]) == *bytes);

  const nlohmann::json& primitives = json["meshes"][0]["primitives"];
  BOOST_REQUIRE(primitives.size() == 2u); // the material, and the polygon without one
  const auto& attributes = primitives[0]["attributes"];
  const auto values = [&](const char* name, std::size_t size) {
    const std::size_t accessor = attributes[name];
    const std::size_t count = json["accessors"][accessor]["count"];
    return glb.accessor(accessor).take<float>(size * count);
  };
  // The point 4 has different texture coordinates in two polygons, and so has 2.
  BOOST_TEST(values("POSITION", 3).size() == 3u * 10);
  const Numbers first = values("TEXCOORD_0", 2), second = values("TEXCOORD_1", 2);
  BOOST_TEST((first[0] == 0.25 && first[1] == 0 && second[0] == 0.5 && second[1] == 0.25));
  for (std::size_t i = 0; i < first.size(); i += 2) // nothing but the two, and none
    BOOST_TEST(((first[i] == 0.25 && first[i + 1] == 0) || first[i] == 0));
  const Numbers normals = values("NORMAL", 3);
  BOOST_TEST(normals.size() == 3u * 10);
  BOOST_TEST(normals[2] == -1);
  BOOST_TEST(primitives[1]["attributes"].contains("TEXCOORD_0"));
  BOOST_TEST(!primitives[1]["attributes"].contains("TEXCOORD_1"));
  BOOST_TEST(!primitives[1]["attributes"].contains("NORMAL"));
  BOOST_TEST(!json["meshes"][1]["primitives"][0]["attributes"].contains("NORMAL"));

  mesh.keeps_materials = false;
  const Glb colored(written_as(".glb", mesh));
  BOOST_TEST(colored.json["materials"][0]["name"] == "segment_000");
  BOOST_TEST(!colored.json.contains("images"));
}

BOOST_AUTO_TEST_CASE(glb_has_the_tree_of_parts)
{
  // The segments 1 and 3 have no polygons, and so there is no part 4.
  Cube cube;
  const mesh_file::Index none = mesh_file::null_index;
  cube.segment = {2, 0, 2, 2, 4, 2};
  cube.colors.resize(5);
  Segmented_soup mesh = cube.mesh();
  mesh.parts = {{none, none, 0}, {0, none, 2}, {1, 4, 5}, {1, 2, 6}, {0, none, 1}, {4, none, 4},
                {5, 3, 8}, {5, 1, 9}, {4, 0, 3}};
  const nlohmann::json nodes = Glb(written_as(".glb", mesh)).json["nodes"];
  const auto node = [](const char* name, const std::vector<int>& children, int mesh_number = -1) {
    nlohmann::json result{{"name", name}};
    if (!children.empty())
      result["children"] = children;
    if (mesh_number >= 0)
      result["mesh"] = mesh_number;
    return result;
  };
  const nlohmann::json expected{node("segments", {1}), node("part_000", {2, 5}),
                                node("part_002", {3, 4}), node("segment_004", {}, 0),
                                node("segment_002", {}, 1), node("part_001", {6}),
                                node("segment_000", {}, 2)};
  BOOST_TEST(nodes == expected);
}

BOOST_AUTO_TEST_CASE(glb_has_linear_colors)
{
  const Glb glb(written_as(".glb", Cube().mesh()));
  const std::vector<Numbers> colors{{1, 0, 0.00303527, 1}, {0.21586050, 0.57758044, 0, 1}};
  for (std::size_t s = 0; s < 2; ++s) {
    const Numbers color =
      glb.json["materials"][s]["pbrMetallicRoughness"]["baseColorFactor"].get<Numbers>();
    BOOST_REQUIRE(color.size() == 4u);
    for (std::size_t k = 0; k < 4; ++k)
      BOOST_TEST(std::abs(color[k] - colors[s][k]) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(glb_without_triangles)
{
  const Polygon_soup soup = soup_of({{0, 0, 0}, {1, 0, 0}}, {{0, 1}});
  const std::vector<Index> segment{0};
  const std::vector<Rgb> colors(1);
  const Glb glb(written_as(".glb", {soup, segment, colors}));
  BOOST_TEST(glb.data.empty());
  BOOST_TEST(glb.json["nodes"].size() == 2u);
  for (const char* name : {"meshes", "accessors", "bufferViews", "buffers", "materials"})
    BOOST_TEST(glb.json.count(name) == 0u); // none of them may be empty
}

BOOST_AUTO_TEST_CASE(too_large_for_the_format)
{
  const double largest = (std::numeric_limits<float>::max)();
  for (const char* extension : {".stl", ".glb"})
    for (double sign : {1., -1.}) {
      Cube cube;
      cube.soup.points[8][1] = sign * largest;
      BOOST_CHECK_NO_THROW(written_as(extension, cube.mesh()));
      cube.soup.points[8][1] = sign * 1.001 * largest;
      BOOST_CHECK_EXCEPTION(written_as(extension, cube.mesh()), std::runtime_error, is_too_large);
    }
  BOOST_CHECK_NO_THROW(mesh_file::check_size_of_glb(0xffffffffu));
  BOOST_CHECK_EXCEPTION(mesh_file::check_size_of_glb(std::uint64_t(1) << 32), std::runtime_error,
                        is_too_large);
}

BOOST_AUTO_TEST_CASE(names_determine_the_format)
{
  using mesh_file::check_output_format;
  for (const char* name : {"a.ply", "dir.stl/a.OBJ", "a.b.Off", "a.glb"})
    for (bool is_part : {false, true})
      BOOST_CHECK_NO_THROW(check_output_format(name, is_part));
  BOOST_CHECK_NO_THROW(check_output_format("a.STL", true));
  const auto message = [](const char* name, bool is_part) -> std::string {
    try {
      check_output_format(name, is_part);
      return "";
    }
    catch (const std::runtime_error& e) {
      return e.what();
    }
  };
  for (const std::string name : {"a.xyz", "ply", "a.ply/b", "a.stl", ""})
    BOOST_TEST(message(name.c_str(), false) ==
               "cannot write " + name + ": the name must end in .ply, .obj, .off or .glb");
  BOOST_TEST(message("a.xyz", true) ==
             "cannot write a.xyz: the name must end in .ply, .obj, .off, .glb or .stl");
  BOOST_CHECK_NO_THROW(check_output_format("a.xyz", true, ".xyz"));
  BOOST_CHECK_EXCEPTION(check_output_format("a.stl", false, ".xyz"), std::runtime_error,
                        [](const std::runtime_error& e) {
                          return std::string(e.what()) == "cannot write a.stl: the name must end "
                                                          "in .ply, .obj, .off, .glb or .xyz";
                        });
  BOOST_TEST(mesh_file::output_extension("dir.stl/a.b.Off") == ".off");
  BOOST_TEST(mesh_file::name_of_materials("dir/a.b.obj").filename().string() == "a.b.mtl");
}

BOOST_AUTO_TEST_SUITE_END()
