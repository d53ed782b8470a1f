// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../read_materials.h"
#include "../read_mesh_file.h"
#ifdef __unix__
#include "../read_scene_in_child.h"
#endif

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(read_mesh_file)

using mesh_file::Format;
using mesh_file::Index;
using mesh_file::null_index;
using mesh_file::Number_type;
using mesh_file::Point;
using mesh_file::Polygon;
using mesh_file::Polygon_soup;

typedef std::vector<Point> Points;
typedef std::vector<std::vector<Index> > Polygons;

namespace {

const Points corner_points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const Points square_points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};

void check(const Polygon_soup& soup, const Points& points, const Polygons& polygons)
{
  BOOST_TEST((soup.points == points));
  Polygons read;
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i) {
    const Polygon polygon = soup.polygon(i);
    read.emplace_back(polygon.begin(), polygon.end());
  }
  BOOST_TEST((read == polygons));
}

// With and without further properties.
void check(Format format, const std::string& file, const Points& points, const Polygons& polygons)
{
  BOOST_TEST_INFO_SCOPE(file.substr(0, 300));
  for (bool keeps_properties : {false, true})
    check(mesh_file::read_mesh_file(file, format, keeps_properties), points, polygons);
}

void check_failure(Format format, const std::string& file, const std::string& message)
{
  BOOST_TEST_INFO_SCOPE(file.substr(0, 300));
  for (bool keeps_properties : {false, true})
    BOOST_CHECK_EXCEPTION(mesh_file::read_mesh_file(file, format, keeps_properties),
                          std::runtime_error, [&](const std::runtime_error& e) {
                            BOOST_TEST(e.what() == message);
                            return true;
                          });
}

// With warnings in this order.
void check_warnings(Format format, const std::string& file, const Points& points,
                    const Polygons& polygons, const std::vector<std::string>& warnings)
{
  check(format, file, points, polygons);
  BOOST_TEST_INFO_SCOPE(file.substr(0, 300));
  BOOST_TEST(mesh_file::read_mesh_file(file, format, true).warnings == warnings,
             boost::test_tools::per_element());
}

// Characters that fill up the end of a text.
const std::string paddings[] = {std::string(2, '\0'), std::string(4000, '\0'), "\x1A",
                                std::string("\0\r\n\0\n", 5), std::string(" \0 \x1A\n", 5)};

std::string with_line_ends(const std::string& text, const std::string& line_end)
{
  std::string result;
  for (char c : text)
    result += c == '\n' ? line_end : std::string(1, c);
  return result;
}

// Numbers in either order of bytes.
class Bytes
{
  std::string bytes_;
  bool is_big_endian_;

public:
  explicit Bytes(bool is_big_endian, const std::string& begin = "")
    : bytes_(begin), is_big_endian_(is_big_endian) {}

  template <class Number>
  Bytes& put(const std::vector<Number>& numbers)
  {
    for (Number number : numbers) {
      char bytes[sizeof(Number)];
      std::memcpy(bytes, &number, sizeof number);
      const std::uint16_t one = 1;
      const bool is_this_big_endian = *reinterpret_cast<const unsigned char*>(&one) == 0;
      const std::string in_order(bytes, sizeof bytes);
      bytes_ += is_this_big_endian == is_big_endian_
                  ? in_order : std::string(in_order.rbegin(), in_order.rend());
    }
    return *this;
  }

  Bytes& floats(const std::vector<float>& numbers) { return put(numbers); }
  Bytes& ints(const std::vector<std::int32_t>& numbers) { return put(numbers); }
  Bytes& uchars(const std::vector<std::uint8_t>& numbers) { return put(numbers); }

  const std::string& operator()() const { return bytes_; }
};

const std::vector<float> corner_floats{0, 0, 0, 1, 0, 0, 0, 1, 0};

std::string ply_header(const std::string& format, const std::string& lines)
{ return "ply\nformat " + format + " 1.0\n" + lines + "end_header\n"; }

const std::string ply_points = "element vertex 3\nproperty float x\nproperty float y\n"
                               "property float z\n";
const std::string ply_faces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string ply_body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string stl_facet(const std::string& normal, const std::string& third = "0 1 0")
{
  return "facet normal " + normal + "\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex " +
         third + "\n endloop\nendfacet\n";
}

const Points stl_points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

std::string binary_stl(std::string header)
{
  header.resize(80, header.find('\0') == std::string::npos ? ' ' : '\0');
  Bytes bytes(false, header);
  bytes.put<std::uint32_t>({2});
  for (float z : {0.f, 1.f})
    bytes.floats({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 - z, z}).uchars({0, 0});
  return bytes();
}

} // namespace

// OFF

BOOST_AUTO_TEST_CASE(off)
{
  const std::string text = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n4 0 1 3 2\n";
  const Polygons polygons{{0, 1, 2}, {0, 1, 3, 2}};
  for (const char* line_end : {"\n", "\r\n", "\r", " \t\n", "\n\n", " # a comment 1 2\n"})
    check(Format::OFF, with_line_ends(text, line_end), square_points, polygons);
  check(Format::OFF, text.substr(4), square_points, polygons); // without keyword
  check(Format::OFF, "\xEF\xBB\xBF# first\n" + text, square_points, polygons);
  check(Format::OFF, text.substr(0, text.size() - 1), square_points, polygons);
  for (const std::string& padding : paddings)
    check(Format::OFF, text.substr(0, text.size() - 1) + padding, square_points, polygons);
  BOOST_TEST((mesh_file::read_off(text, false).coordinate_type == Number_type::FLOAT64));
}

BOOST_AUTO_TEST_CASE(off_counts)
{
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* header : {"OFF 3 1 0\n", "OFF 3 1\n", "OFF\n3 1\n", "OFF\n3 1 # no edges\n",
                             "OFF\n3\n1\n0\n", "OFF\n3 1 -1\n", "nOFF\n3\n3 1 0\n",
                             "nOFF 3 3 1 0\n"})
    check(Format::OFF, header + body, corner_points, {{0, 1, 2}});
  check(Format::OFF, "OFF\n0 0 0\n", {}, {});
  check(Format::OFF, "OFF\n1 2 0\n0 0 0\n0\n1 0\n", {{0, 0, 0}}, {{}, {0}});
}

BOOST_AUTO_TEST_CASE(off_numbers)
{
  check(Format::OFF, "OFF 2 0 0\n+1.5 -2e3 .5\n1e-400 7 -0.25E+1\n",
        {{1.5, -2000, 0.5}, {0, 7, -2.5}}, {});
}

BOOST_AUTO_TEST_CASE(off_with_colors_normals_and_texture)
{
  check(Format::OFF, "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 1 0 1\n0 1 0 7\n3 0 1 2 0.5 0.5 1\n",
        corner_points, {{0, 1, 2}});
  check(Format::OFF, "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2 # red\n",
        corner_points, {{0, 1, 2}});
  check(Format::OFF, "STOFF\n3 1 0\n0 0 0 .5 .5\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2 9\n", corner_points,
        {{0, 1, 2}});
  check(Format::OFF, "STCNOFF\n1 1 0\n0 0 0 1 0 0 1 0 0 1 5 5\n1 0\n", {{0, 0, 0}}, {{0}});
  // An index of a color, out of any range
  check(Format::OFF, "COFF\n3 1 0\n0 0 0 -70000000\n1 0 0 -70000000\n0 1 0 -70000000\n3 0 1 2\n",
        corner_points, {{0, 1, 2}});
}

BOOST_AUTO_TEST_CASE(off_binary)
{
  Bytes plain(true, "OFF BINARY\n");
  plain.ints({3, 2, 0}).floats(corner_floats).ints({3, 0, 1, 2, 0, 2, 2, 1, 3}).floats({1, 0, 0});
  check(Format::OFF, plain(), corner_points, {{0, 1, 2}, {2, 1}});
  BOOST_TEST((mesh_file::read_off(plain(), false).coordinate_type == Number_type::FLOAT32));
  for (std::size_t size = 11; size < plain().size(); ++size)
    BOOST_CHECK_THROW(mesh_file::read_off(plain().substr(0, size), false), std::runtime_error);

  Bytes further(true, "STCNOFF BINARY\n");
  further.ints({2, 1, 0});
  for (float x : {0.f, 1.f})
    further.floats({x, 2, 3}).floats({0, 0, 1}).floats({1, 0, 0, 1}).floats({0.5, 0.5});
  further.ints({2, 1, 0, 0});
  check(Format::OFF, further(), {{0, 2, 3}, {1, 2, 3}}, {{1, 0}});

  Bytes dimension(true, "nOFF BINARY\n");
  dimension.ints({3, 1, 0, 0}).floats({4, 5, 6});
  check(Format::OFF, dimension(), {{4, 5, 6}}, {});
}

BOOST_AUTO_TEST_CASE(off_contradictions)
{
  const std::string points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  const auto fails = [](const std::string& file, const std::string& message)
  { check_failure(Format::OFF, file, message); };
  fails("", "line 1: the file ends where a number of points should be");
  fails("OOF\n3 1 0\n", "line 1: 'OOF' is not OFF");
  fails("OFF\n-3 1 0\n", "line 2: '-3' is not a number of points");
  fails("OFF\n3 1.5 0\n", "line 2: '1.5' is not a number of faces");
  fails("OFF\n3 1 0 7\n", "line 2: '7' is not the end of the line");
  fails("OFF\n3 99999999999 0\n", "line 2: '99999999999' is not a number of faces");
  fails("OFF\n4000000000 1 0\n0 0 0\n",
        "line 2: the file is too short for 4000000000 points and 1 faces");
  fails("4OFF\n3 1 0\n", "line 1: the points do not have three coordinates");
  fails("nOFF\n4\n3 1 0\n", "line 2: the points do not have three coordinates");
  fails("STCN4nOFF\n11 7 0 255 0 0\n-1.0 -1.0 1.0 255 0 0\n",
        "line 2: the points do not have three coordinates");
  fails("OFF\n2 0 0\n0 0 0\n0 x 0\n", "line 4: 'x' is not a number");
  fails("OFF\n2 0 0\n0 0 0\n0 1e 0\n", "line 4: '1e' is not a number");
  fails("OFF\n2 0 0\n0 0 0\n0 +-1 0\n", "line 4: '+-1' is not a number");
  fails("OFF\n2 0 0\n0 0 0\n0 0x10 0\n", "line 4: '0x10' is not a number");
  fails("OFF\n2 0 0\n0 0 0\n0", "line 4: the file ends where a number should be");
  fails(points + "-3 0 1 2\n", "line 6: '-3' is not a number of corners");
  fails(points + "400000000 0 1 2\n",
        "line 6: '400000000' is not a number of corners that the file has room for");
  fails(points + "3 0 1 3\n", "line 6: '3' is not the number of a point");
  fails(points + "3 0 1 -1\n", "line 6: '-1' is not the number of a point");
  fails(points + "3 0 1   \n", "line 7: the file ends where the number of a point should be");
  fails(points + "3 0 1 2 red\n", "line 6: 'red' is not a number");
  fails(points + "3 0 1 2\n3 0 1 2\n", "line 7: there is more after the last face");
  fails(with_line_ends(points, "\r\n") + "3 0 1 \x01\x80\r\n",
        "line 6: '?\?' is not the number of a point");
  fails(points + "3 0 1 a-word-that-is-longer-than-a-sentence-should-be\n",
        "line 6: 'a-word-that-is-longer-th...' is not the number of a point");
}

BOOST_AUTO_TEST_CASE(off_binary_contradictions)
{
  const auto fails = [](const std::vector<std::int32_t>& faces, const std::string& message) {
    Bytes bytes(true, "OFF BINARY\n");
    bytes.ints({3, 1, 0}).floats(corner_floats).ints(faces);
    check_failure(Format::OFF, bytes(), message); // the faces begin at byte 59
  };
  fails({3, 0, 1, 3, 0}, "byte 71: 3 is not the number of a point");
  fails({3, 0, -1, 2, 0}, "byte 67: -1 is not the number of a point");
  fails({-3, 0, 1, 2, 0}, "byte 59: -3 is not a number of corners");
  fails({400000000, 0, 1, 2, 0}, "byte 79: the file ends where the corners of a face should be");
  fails({3, 0, 1, 2, 5}, "byte 75: 5 is not a number of color components");
  fails({3, 0, 1, 2, 1}, "byte 79: the file ends where a color should be");
  fails({3, 0, 1, 2, 0, 65}, "byte 82: there is more after the last face");
  check_failure(Format::OFF, Bytes(true, "OFF BINARY\n").ints({-1, 0, 0})(),
                "byte 11: -1 is not a number of points");
  check_failure(Format::OFF, Bytes(true, "OFF BINARY\n").ints({2000000000, 0, 0})(),
                "line 2: the file is too short for 2000000000 points and 0 faces");
}

// OBJ

BOOST_AUTO_TEST_CASE(obj)
{
  const std::string text = "# a comment\nv 0 0 0\nv 1 0 0 1.0\nv 0 1 0 1 0 0\nv 1 1 0\n\nf 1 2 3\n"
                           "f\t1\t2  4 3\n";
  const Polygons polygons{{0, 1, 2}, {0, 1, 3, 2}};
  for (const char* line_end : {"\n", "\r\n", "\r", " \t\n", " # more\n", "\n\n"})
    check(Format::OBJ, with_line_ends(text, line_end), square_points, polygons);
  check(Format::OBJ, "\xEF\xBB\xBF" + text.substr(12), square_points, polygons);
  check(Format::OBJ, "", {}, {});
}

BOOST_AUTO_TEST_CASE(obj_corners)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string more = "vt 0\nvt 0.5 1 0\nvn 0 0 1\n";
  for (const char* face : {"f 1 2 3", "f 1/1 2/2 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/2/1",
                           "f -3 -2 -1", "f -3/-2/-1 -2/-1/-1 -1/-1/-1", "fo 1 2 3", "f +1 2 3#",
                           "f 1 \\\n 2 \\\r\n 3", "f 1 2\\\n 3", "f 1/7/9 2/7/9 3/7/9"})
    check(Format::OBJ, points + more + face + "\n", corner_points, {{0, 1, 2}});
  check(Format::OBJ, "f 1 2 3\n" + points, corner_points, {{0, 1, 2}});
  check(Format::OBJ, points + "f -1 -2 -3\nv 5 5 5\nf -1 -2 -3\n",
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{2, 1, 0}, {3, 2, 1}});
  check(Format::OBJ, points + "f\nf 2\nf 1 3\n", corner_points, {{}, {1}, {0, 2}});
}

BOOST_AUTO_TEST_CASE(obj_further_statements)
{
  check(Format::OBJ, "csh -e rm x\nmtllib a b.mtl\no name\ng a b\ns off\nv 0 0 0\nvp 1 2\n"
                     "v 1 0 0\nv 0 1 0\nusemtl a/b \\\n c\np 1 2\nl 1/1 2/2\ncstype bezier\n"
                     "f 1 2 3\ng\n",
        corner_points, {{0, 1, 2}});
}

BOOST_AUTO_TEST_CASE(obj_texture_and_normals)
{
  const Polygon_soup soup = mesh_file::read_obj(
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25\nvt 0.5 1 9\nvn 0 0 1\nvn 1 0 0\n"
    "f 1/2/1 2/1/2 3/-1/-1\nf 1//2 2/1 3\nf 1/3/3 2/0/0 3\n", true);
  const std::vector<mesh_file::Texture_point> coordinates{{0.25, 0, 0, 0}, {0.5, 1, 0, 0}};
  const Points normals{{0, 0, 1}, {1, 0, 0}};
  const Index no = null_index;
  const std::vector<Index> textures{1, 0, 1, no, 0, no, no, no, no};
  const std::vector<Index> normal_of_corner{0, 1, 1, 1, no, no, no, no, no};
  BOOST_TEST((soup.texture_coordinates == coordinates));
  BOOST_TEST((soup.texture_of_corner == textures));
  BOOST_TEST((soup.normals == normals));
  BOOST_TEST((soup.normal_of_corner == normal_of_corner));

  const Polygon_soup unused = mesh_file::read_obj("v 0 0 0\nvt 0 0\nvn 0 0 1\nf 1 1 1\n", true);
  BOOST_TEST(unused.texture_of_corner.empty());
  BOOST_TEST(unused.normal_of_corner.empty());
}

BOOST_AUTO_TEST_CASE(obj_names_materials)
{
  const std::string file =
    "mtllib a b.mtl \nmtllib c.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl  red, or #2\n"
    "f 1 2 3\nusemtl\nf 1 2 3\nusemtl red, or #2\nf 1 2 3\n";
  const Polygon_soup soup = mesh_file::read_obj(file, true);
  BOOST_TEST(soup.material_files == (std::vector<std::string>{"a b.mtl", "c.mtl"}),
             boost::test_tools::per_element());
  BOOST_REQUIRE(soup.materials.size() == 2u);
  BOOST_TEST(soup.materials[0].name == "red, or #2");
  BOOST_TEST(soup.materials[1].name == "");
  BOOST_TEST((soup.material_of_polygon == std::vector<Index>{null_index, 0, 1, 0}));
  BOOST_TEST(mesh_file::read_obj(file, false).material_of_polygon.empty());
  BOOST_TEST(mesh_file::read_obj("v 0 0 0\nf 1 1 1\n", true).material_of_polygon.empty());
}

BOOST_AUTO_TEST_CASE(materials_of_mtl)
{
  const segment_mesh::Input_folder nowhere("", true);
  Polygon_soup soup;
  soup.materials = {{"a b", {}, {}}, {"c", {}, {}}};
  segment_mesh::Material_reader reader(nowhere, soup);
  std::map<std::string, mesh_file::Material*, std::less<> > materials;
  for (mesh_file::Material& m : soup.materials)
    materials.emplace(m.name, &m);
  reader.read_mtl("Kd 9 9 9\n# no\n newmtl a b \r\n\tKd 1 0  0\r\n"
                  "map_Kd -s 2 2 -bm 1 -o 1 x y.png\nnewmtl unused\nmap_Kd z.png\n"
                  "newmtl c\nmap_kd x y.png\nbump -mm 0 1 2.png\nmap_Ks -clamp\nnorm\n"
                  "newmtl a b\nKd 8 8 8", materials);
  const auto check_statement = [&](std::size_t material, std::size_t i, const std::string& text,
                                   std::size_t image) {
    BOOST_REQUIRE(i < soup.materials[material].statements.size());
    BOOST_TEST(soup.materials[material].statements[i].text == text);
    BOOST_TEST(soup.materials[material].statements[i].image == image);
  };
  const std::size_t none = mesh_file::Material::no_image;
  BOOST_TEST(soup.materials[0].statements.size() == 2u);
  check_statement(0, 0, "Kd 1 0  0", none);
  check_statement(0, 1, "map_Kd -s 2 2 -bm 1 -o 1", 0);
  BOOST_TEST(soup.materials[1].statements.size() == 4u);
  check_statement(1, 0, "map_kd", 0);
  check_statement(1, 1, "bump -mm 0 1", 1);
  check_statement(1, 2, "map_Ks", 2); // the name of a file
  check_statement(1, 3, "norm", none);
  const std::vector<std::string> missing{"x y.png", "2.png", "-clamp"};
  BOOST_TEST(reader.missing_files() == missing, boost::test_tools::per_element());
  for (std::size_t i = 0; i < 3; ++i)
    BOOST_TEST(soup.images[i].name == missing[i]);
}

BOOST_AUTO_TEST_CASE(gltf_of_mtl)
{
  const auto converted = [](const mesh_file::Material& material)
  { return nlohmann::json::parse(mesh_file::gltf_of_mtl(material)); };
  const nlohmann::json plain = converted({});
  BOOST_TEST(plain["pbrMetallicRoughness"]["metallicFactor"] == 0);
  BOOST_TEST(plain["pbrMetallicRoughness"]["roughnessFactor"] == 1);
  BOOST_TEST(plain["doubleSided"] == true);
  BOOST_TEST(!plain.contains("alphaMode"));

  const nlohmann::json json = converted({"", {{"Kd 9 9 9"}, {"Kd 0.5 nan -1"}, {"Ks 0.1"}, {"Ns 6"},
                                              {"D 0.25"}, {"Ke 1 0 7"}, {"Pm 0.5"}, {"Kx # ?"},
                                              {"map_kd -s 2", 3}, {"map_Pr", 1}, {"map_Pm", 1},
                                              {"norm", 2}, {"bump", 4}}, ""});
  const nlohmann::json& surface = json["pbrMetallicRoughness"];
  const std::vector<double> color = surface["baseColorFactor"];
  BOOST_TEST(color[0] == 0.21404, boost::test_tools::tolerance(1e-5)); // as tables of sRGB say
  BOOST_TEST((color[1] == 0 && color[2] == 0 && color[3] == 0.25));
  BOOST_TEST(json["alphaMode"] == "BLEND");
  BOOST_TEST(json["emissiveFactor"] == nlohmann::json({1, 0, 1}));
  BOOST_TEST(surface["metallicFactor"] == 0.5);
  BOOST_TEST(surface["roughnessFactor"] == 1); // the map has all of it
  BOOST_TEST(surface["baseColorTexture"]["index"] == 3);
  BOOST_TEST(surface["metallicRoughnessTexture"]["index"] == 1);
  BOOST_TEST(json["normalTexture"]["index"] == 2);
  BOOST_TEST(converted({"", {{"Ks 1 1 1"}, {"Ns 6"}}, ""})["pbrMetallicRoughness"]
               ["roughnessFactor"] == 0.5);
  BOOST_TEST(converted({"", {{"Kd spectral a.rfl"}, {"Tr 1"}}, ""})["pbrMetallicRoughness"]
               ["baseColorFactor"][3] == 0);
}

BOOST_AUTO_TEST_CASE(descriptions_of_a_broken_child)
{
  const segment_mesh::Input_folder nowhere("", true);
  for (const char* description : {"", "{", "[]", "7", R"({"mtl":7})", R"({"mtl":[[]]})",
                                  R"({"mtl":[7]})", R"({"mtl":[["map_Kd",7]]})",
                                  R"({"normalTexture":{"index":-1}})",
                                  R"({"pbrMetallicRoughness":{"baseColorFactor":[1]}})",
                                  R"({"normalTexture":{"index":"a","extensions":)"
                                  R"({"KHR_texture_transform":{}}}})"}) {
    Polygon_soup soup;
    soup.materials = {{"a", {}, description}};
    segment_mesh::Material_reader(nowhere, soup).read_descriptions();
    BOOST_TEST(soup.materials[0].gltf == "", description);
  }
  Polygon_soup soup;
  soup.materials = {{"a", {}, R"({"mtl":["Kd 1\nnewmtl b",["map_Kd","x\ny"]]})"}};
  segment_mesh::Material_reader(nowhere, soup).read_descriptions();
  BOOST_TEST(soup.materials[0].statements[0].text == "Kd 1?newmtl b");
  BOOST_TEST(soup.images[0].name == "x?y");
}

BOOST_AUTO_TEST_CASE(obj_contradictions)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  const auto fails = [](const std::string& file, const std::string& message)
  { check_failure(Format::OBJ, file, message); };
  fails(points + "f 1 2 3\nf 3 2 x4\n", "line 6: 'x4' is not the corner of a face");
  fails(points + "f 1 2 99999999999\n", "line 5: '99999999999' is not the corner of a face");
  fails(points + "f 1 2 3.5\n", "line 5: '3.5' is not the corner of a face");
  fails(points + "f 1 2 0\n", "line 5: '0' is not the corner of a face");
  fails(points + "f 1 2 -5\n", "line 5: '-5' is not the corner of a face");
  fails(points + "f 1/a 2 3\n", "line 5: 'a' is not the corner of a face");
  fails(points + "f 1/1/1/1 2 3\n", "line 5: '1/1/1/1' is not the corner of a face");
  fails("f 1 2\nf 1 5 \\\n 7 2\n" + points, "line 3: '7' is not a corner: there are 4 points");
  fails("v 0 0 0\nv 1 0\nv 0 1 0\n", "line 2: the line ends where a number should be");
  fails("v 0 0 0\nv 1 0", "line 2: the file ends where a number should be");
  fails("v 0 0,5 0\n", "line 1: '0,5' is not a number");
  fails("v 0 0 0 red\n", "line 1: 'red' is not a number");
  fails("face 1 1 1\nedge 1 1\n", "line 1: 'face' is not a statement of OBJ");
  fails(std::string("\0\1\2", 3), "line 1: '?\?' is not a statement of OBJ");
}

BOOST_AUTO_TEST_CASE(obj_with_unknown_statements)
{
  const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto warns = [](const std::string& file, const std::vector<std::string>& warnings)
  { check_warnings(Format::OBJ, file, corner_points, {{0, 1, 2}}, warnings); };
  warns(mesh + "vw 0 0 1.0\nvw 1 0 1\n\nt crease 2/1/0 0 1 2.0\nvw\n",
        {"line 5: 'vw' is not a statement of OBJ", "line 8: 't' is not a statement of OBJ"});
  std::vector<std::string> warnings;
  std::string many = mesh;
  for (int i = 1; i <= 20; ++i) {
    const std::string name = "u" + std::to_string(i);
    many += name + "\n";
    if (i <= 8)
      warnings.push_back("line " + std::to_string(4 + i) + ": '" + name +
                         "' is not a statement of OBJ");
  }
  warns(many, warnings);
  warns(mesh + std::string(70, '\0'), {});
  warns(mesh + "\x1A", {});
  warns(std::string(9, '\0') + mesh, {});
  warns(mesh + "\r\n\x1A\r\n", {});
  for (const std::string& padding : paddings)
    warns(mesh.substr(0, mesh.size() - 1) + padding, {});

  warns("vn -1.#IND -1.#IND -1.#IND\nvt 1.#QNAN\nvt 1 2 3 x\n" + mesh, {});
  warns("vt\nvn 0 0\r\nvn x y 1,0\n" + mesh,
        {"line 1: the line ends where a number should be, in a normal or texture"});
  const Polygon_soup soup =
    mesh_file::read_obj("vn 0 x 1\nvn 1 0 0\n" + mesh + "f 1//2 2//2 3//1\n", true);
  BOOST_TEST(soup.normals.size() == 2u);
  BOOST_TEST((std::isnan(soup.normals[0][1]) && soup.normals[0][2] == 1));
  BOOST_TEST((soup.normals[1] == Point{1, 0, 0}));
}

// PLY

BOOST_AUTO_TEST_CASE(ply_text)
{
  const std::string text = ply_header("ascii", "comment any # words\nobj_info more\n" + ply_points +
                                                 ply_faces) + ply_body;
  for (const char* line_end : {"\n", "\r\n", "\r"})
    check(Format::PLY, with_line_ends(text, line_end), corner_points, {{0, 1, 2}});
  check(Format::PLY, text.substr(0, text.size() - 1), corner_points, {{0, 1, 2}});
  for (const std::string& padding : paddings)
    check(Format::PLY, text.substr(0, text.size() - 1) + padding, corner_points, {{0, 1, 2}});
  check(Format::PLY, ply_header("ascii", ply_faces + ply_points) + "3 2 1 0 0 0 0 1 0 0 0 1 0\n",
        corner_points, {{2, 1, 0}}); // faces first, all on one line
  check(Format::PLY, ply_header("ascii", ""), {}, {});
}

BOOST_AUTO_TEST_CASE(ply_coordinates_of_all_types)
{
  const auto header = [](const std::string& type) {
    std::string lines = "element vertex 3\n";
    for (const char* c : {"x", "y", "z"})
      lines += "property " + type + " " + c + "\n";
    return lines + ply_faces;
  };
  for (const char* type : {"char", "uchar", "short", "ushort", "int", "uint", "float", "double",
                           "int8", "uint8", "int16", "uint16", "int32", "uint32", "float32",
                           "float64"}) {
    BOOST_TEST_CONTEXT(type) {
      const std::string file = ply_header("ascii", header(type)) + ply_body;
      check(Format::PLY, file, corner_points, {{0, 1, 2}});
      const bool is_float = std::string(type).substr(0, 5) == "float" && type[5] != '6';
      BOOST_TEST((mesh_file::read_ply(file, false).coordinate_type ==
                  (is_float ? Number_type::FLOAT32 : Number_type::FLOAT64)));
    }
  }
  check(Format::PLY, ply_header("ascii", "element vertex 1\nproperty double z\nproperty float x\n"
                                         "property int y\n") + "1 2 3\n", {{2, 3, 1}}, {});
}

BOOST_AUTO_TEST_CASE(ply_with_other_names_of_the_corners)
{
  const auto file = [](const std::string& properties, const std::string& face) {
    return ply_header("ascii", ply_points + "element face 1\n" + properties) +
           "0 0 0\n1 0 0\n0 1 0\n" + face + "\n";
  };
  const auto list = [](const std::string& name, const std::string& type = "int")
  { return "property list uchar " + type + " " + name + "\n"; };
  const auto reads = [&](const std::string& properties, const std::string& face)
  { check(Format::PLY, file(properties, face), corner_points, {{0, 1, 2}}); };
  for (const char* name : {"indices", "vertices", "vertex-indices"}) {
    reads(list(name), "3 0 1 2");
    reads(list(name, "uchar"), "3 0 1 2");
    reads(list("texcoord") + "property int red\n" + list(name), "3 2 1 0 7 3 0 1 2");
    reads(list("weights", "float") + list(name) + list("corner_colors", "uchar"),
          "3 2 1 0 3 0 1 2 3 2 1 0");
    reads(list(name) + list("vertex_index"), "3 2 1 0 3 0 1 2");
  }
  const std::string more = "property int red\n"; // so that the body begins in line 11
  for (const std::string& properties :
       {list("texcoord") + more, list("indices", "float") + more, list("indices") + list("more")})
    check_failure(Format::PLY, file(properties, "3 0 1 2 0"),
                  "line 13: the elements 'face' have no list 'vertex_indices'");
  check_failure(Format::PLY, ply_header("ascii", ply_points + "element tristrips 1\n" +
                                                   list("indices")) + ply_body,
                "line 12: the elements 'tristrips' have no list 'vertex_indices'");
}

// All number types, before and after the properties that are read.
BOOST_AUTO_TEST_CASE(ply_binary)
{
  for (bool is_big_endian : {false, true}) {
    Bytes bytes(is_big_endian, ply_header(
      is_big_endian ? "binary_big_endian" : "binary_little_endian",
      "element first 2\nproperty list ushort double values\nproperty short s\n"
      "element vertex 3\nproperty char a\nproperty float x\nproperty uchar b\nproperty float y\n"
      "property ushort c\nproperty float z\nproperty double d\nproperty list uint short e\n"
      "element face 2\nproperty int f\nproperty list uint ushort vertex_index\nproperty uint g\n"
      "element last 1\nproperty list char char h\n"));
    bytes.put<std::uint16_t>({2}).put<double>({1.5, 2.5}).put<std::int16_t>({-7})
      .put<std::uint16_t>({0}).put<std::int16_t>({300});
    for (int i = 0; i < 3; ++i)
      bytes.put<std::int8_t>({static_cast<std::int8_t>(-1 - i)}).floats({i == 1 ? 1.f : 0.f})
        .uchars({static_cast<std::uint8_t>(200 + i)}).floats({i == 2 ? 1.f : 0.f})
        .put<std::uint16_t>({static_cast<std::uint16_t>(60000 + i)}).floats({0})
        .put<double>({0.1 * i}).put<std::uint32_t>({1}).put<std::int16_t>({5});
    bytes.ints({-70000}).put<std::uint32_t>({3}).put<std::uint16_t>({0, 1, 2})
      .put<std::uint32_t>({4000000000u});
    bytes.ints({70000}).put<std::uint32_t>({2}).put<std::uint16_t>({2, 0}).put<std::uint32_t>({1});
    bytes.uchars({2, 9, 9});
    check(Format::PLY, bytes(), corner_points, {{0, 1, 2}, {2, 0}});

    const Polygon_soup soup = mesh_file::read_ply(bytes(), true);
    BOOST_TEST((soup.coordinate_type == Number_type::FLOAT32));
    const std::vector<double> expected[] = {{-1, -2, -3}, {200, 201, 202}, {60000, 60001, 60002},
                                            {0.1 * 0, 0.1 * 1, 0.1 * 2}};
    BOOST_REQUIRE(soup.point_properties.size() == 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      BOOST_TEST(soup.point_properties[i].name == std::string(1, "abcd"[i]));
      BOOST_TEST((soup.point_properties[i].values == expected[i]));
    }
    BOOST_REQUIRE(soup.polygon_properties.size() == 2u);
    BOOST_TEST(soup.polygon_properties[0].name == "f");
    BOOST_TEST((soup.polygon_properties[0].type == Number_type::INT32));
    BOOST_TEST((soup.polygon_properties[0].values == std::vector<double>{-70000, 70000}));
    BOOST_TEST((soup.polygon_properties[1].values == std::vector<double>{4000000000., 1}));

    const std::size_t size_of_body = bytes().size() - (bytes().find("end_header\n") + 11);
    for (std::size_t less = 1; less <= size_of_body; ++less)
      BOOST_CHECK_THROW(mesh_file::read_ply(bytes().substr(0, bytes().size() - less), false),
                        std::runtime_error);
  }
}

BOOST_AUTO_TEST_CASE(ply_further_properties_and_elements)
{
  const std::string file =
    ply_header("ascii", "element nothing 9000000000000000000\n" + ply_points +
                          "property float quality\nproperty list uchar int owners\n" + ply_faces +
                          "property uchar red\nelement edge 2\nproperty int vertex1\n") +
    "0 0 0 nan 0\n1 0 0 -inf 2 7 8\n0 1 0 0.5 1 7\n3 0 1 2 255\n0\n1\n";
  check(Format::PLY, file, corner_points, {{0, 1, 2}});
  const Polygon_soup soup = mesh_file::read_ply(file, true);
  BOOST_REQUIRE(soup.point_properties.size() == 1u);
  BOOST_TEST(std::isnan(soup.point_properties[0].values[0]));
  BOOST_TEST(std::isinf(soup.point_properties[0].values[1]));
  BOOST_TEST(soup.point_properties[0].values[2] == 0.5);
  BOOST_REQUIRE(soup.polygon_properties.size() == 1u); // edges are no polygons
  BOOST_TEST(soup.polygon_properties[0].name == "red");
  BOOST_TEST((soup.polygon_properties[0].type == Number_type::UINT8));
  BOOST_TEST((soup.polygon_properties[0].values == std::vector<double>{255}));
  const Polygon_soup bare = mesh_file::read_ply(file, false);
  BOOST_TEST(bare.point_properties.empty());
  BOOST_TEST(bare.polygon_properties.empty());
}

BOOST_AUTO_TEST_CASE(ply_strips_of_triangles)
{
  const std::string points = "element vertex 4\nproperty float x\nproperty float y\n"
                             "property float z\n";
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  const Polygons triangles{{0, 1, 2}, {2, 1, 3}, {3, 2, 1}};
  check(Format::PLY, ply_header("ascii", points + strips) + body + "8 0 1 2 3 -1 3 2 1\n",
        square_points, triangles);
  // Properties of faces are no properties of these triangles.
  const std::string with_faces = ply_header("ascii", points + ply_faces + "property uchar red\n" +
                                                       strips) + body + "3 0 1 2 7\n3 1 2 3\n";
  check(Format::PLY, with_faces, square_points, {{0, 1, 2}, {1, 2, 3}});
  BOOST_TEST(mesh_file::read_ply(with_faces, true).polygon_properties.empty());
}

BOOST_AUTO_TEST_CASE(ply_with_more_than_the_header_declares)
{
  const std::string header = ply_header("ascii", ply_points + ply_faces);
  const auto warns = [](const std::string& file, const std::vector<std::string>& warnings)
  { check_warnings(Format::PLY, file, corner_points, {{0, 1, 2}}, warnings); };
  const std::vector<std::string> warning{"line 11: '255' is not a number that the header declares"};
  const std::string body = "0 0 0\n1 0 0 255 9\n\n0 1 0 # a comment\n3 0 1 2";
  for (const char* line_end : {"\n", "\r\n", "\r"})
    warns(with_line_ends(header + body + "\n", line_end), warning);
  warns(header + "\n" + body + " red 7\n\n", {"line 12: '255' is not a number that the header "
                                             "declares"});
  warns(header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 7\n",
        {"line 13: '7' is not a number that the header declares"});
  check_failure(Format::PLY, header + "0 0 0 1\n1 0\n0 0 1 0\n3 0 1 2\n",
                "line 13: there is more after the last element");
  warns("PLY\n" + header.substr(4) + ply_body, {});
  std::string unknown = header;
  unknown.insert(4, "made by hand\nmade again\n");
  warns(unknown + ply_body, {"line 2: 'made' is not a line of a PLY header"});
  warns(unknown + body, {"line 2: 'made' is not a line of a PLY header",
                         "line 13: '255' is not a number that the header declares"});
}

BOOST_AUTO_TEST_CASE(ply_header_contradictions)
{
  const auto fails = [](const std::string& file, const std::string& message)
  { check_failure(Format::PLY, file, message); };
  fails("", "line 1: the file ends where 'ply' should be");
  fails("plx\n", "line 1: 'plx' is not 'ply'");
  fails("ply\nformat ascii 1.0\nproperty float x\n",
        "line 3: a property comes before the first element");
  fails("ply\nformat acsii 1.0\n", "line 2: 'acsii' is not a format of PLY");
  fails("ply\nformat\n", "line 2: the line ends where a format should be");
  fails("ply\nelement vertex 3\nend_header\n", "line 4: the header does not name its format");
  fails("ply\nformat ascii 1.0\nelement vertex -3\n", "line 3: '-3' is not a number of elements");
  fails("ply\nformat ascii 1.0\nelement vertex 3 4\n", "line 3: '4' is not the end of the line");
  fails("ply\nformat ascii 1.0\nelement a 1\nelement a 1\n",
        "line 4: there is an element 'a' already");
  fails("ply\nformat ascii 1.0\nelement a 1\nproperty half x\n",
        "line 4: 'half' is not a number type of PLY");
  fails("ply\nformat ascii 1.0\nelement a 1\nproperty int x\nproperty int x\n",
        "line 5: there is a property 'x' already");
  fails("ply\nformat ascii 1.0\nelement a 1\nproperty list int x\n",
        "line 4: 'x' is not a number type of PLY");
  fails("ply\nformat ascii 1.0\nlement a 1\n",
        "line 4: the file ends where a line of a PLY header should be");
  fails("ply\nformat ascii 1.0\n", "line 3: the file ends where a line of a PLY header should be");
  fails(ply_header("ascii", "element vertex 1\nproperty float x\nproperty float y\n") + "0 0\n",
        "line 7: the points have no properties x, y and z");
  fails(ply_header("ascii", ply_points + "element face 1\nproperty int a\n") + ply_body,
        "line 12: the elements 'face' have no list 'vertex_indices'");
  fails(ply_header("ascii", ply_points + "element face 1\nproperty list uchar int vertex_index\n"
                                         "property list uchar int vertex_indices\n") + ply_body,
        "line 13: the elements 'face' have two lists of corners");
}

BOOST_AUTO_TEST_CASE(ply_body_contradictions)
{
  const std::string header = ply_header("ascii", ply_points + ply_faces);
  const auto fails = [&](const std::string& body, const std::string& message)
  { check_failure(Format::PLY, header + body, message); }; // the body begins in line 10
  fails("0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", "line 11: 'x' is not a number");
  fails("0 0 0\n1 1e39 0\n0 1 0\n3 0 1 2\n",
        "line 11: '1e39' is not a number of the type of its property");
  fails("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "line 13: '3' is not the number of a point");
  fails("0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "line 13: '-1' is not the number of a point");
  fails("0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n",
        "line 13: '1.5' is not a number of the type of its property");
  fails("0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n",
        "line 13: '-3' is not a number of the type of its property");
  fails("0 0 0\n1 0 0\n0 1 0\n3 0 1", "line 13: the file ends where a number should be");
  fails("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n7\n", "line 14: there is more after the last element");
  check_failure(Format::PLY, ply_header("ascii", ply_points + "element face 1\n"
                                        "property list int int vertex_indices\n") +
                               "0 0 0\n1 0 0\n0 1 0\n400000000 0 1 2\n",
                "line 13: '400000000' is not the size of a list that the file has room for");
  check_failure(Format::PLY, ply_header("ascii", "element vertex 3000000000\nproperty float x\n"
                                        "property float y\nproperty float z\n") + "0 0 0\n",
                "line 8: the file is too short for 3000000000 elements 'vertex'");
  check_failure(Format::PLY, ply_header("ascii", "element other 3000000000\nproperty float x\n"),
                "line 6: the file is too short for 3000000000 elements 'other'");
}

BOOST_AUTO_TEST_CASE(ply_binary_contradictions)
{
  const std::string header = ply_header("binary_little_endian", ply_points + "element face 1\n"
                                        "property list int int vertex_indices\n");
  const std::size_t faces = header.size() + 36;
  const auto fails = [&](const std::vector<float>& points, const std::vector<std::int32_t>& face,
                         std::size_t byte, const std::string& message) {
    check_failure(Format::PLY, Bytes(false, header).floats(points).ints(face)(),
                  "byte " + std::to_string(byte) + ": " + message);
  };
  fails(corner_floats, {3, 0, 1, 3}, faces + 12, "the number here is not the number of a point");
  fails(corner_floats, {3, 0, -1, 2}, faces + 8, "the number here is not the number of a point");
  fails(corner_floats, {4, 0, 1, 2}, faces + 16, "the file ends where a number should be");
  fails(corner_floats, {400000000, 0, 1, 2}, faces,
        "the number here is not the size of a list that the file has room for");
  fails(corner_floats, {-3, 0, 1, 2}, faces,
        "the number here is not the size of a list that the file has room for");
  fails(corner_floats, {3, 0, 1, 2, 8}, faces + 16, "there is more after the last element");
  fails(corner_floats, {}, faces, "the file is too short for 1 elements 'face'");
}

// STL

BOOST_AUTO_TEST_CASE(stl_text)
{
  const std::string facets = stl_facet("0 0 1") + stl_facet("0 -1 0", "0 0 1");
  const Polygons triangles{{0, 1, 2}, {0, 1, 3}};
  for (const char* name : {"", " a", "\ta", " a b", " solid", " facet normal 0", "  "}) {
    const std::string text = std::string("solid") + name + "\n" + facets + "endsolid" + name + "\n";
    for (const char* line_end : {"\n", "\r\n", "\r"})
      check(Format::STL, with_line_ends(text, line_end), stl_points, triangles);
    check(Format::STL, "\xEF\xBB\xBF" + text, stl_points, triangles);
    check(Format::STL, "\n " + text + "\n", stl_points, triangles);
    check(Format::STL, text.substr(0, text.size() - 1), stl_points, triangles);
    for (const std::string& padding : paddings)
      check_warnings(Format::STL, text.substr(0, text.size() - 1) + padding, stl_points, triangles,
                     {});
  }
  for (const char* solid : {"SOLID m", "Solid m"})
    check(Format::STL, solid + ("\n" + facets) + "endsolid m\n", stl_points, triangles);
  std::string upper_case;
  for (char c : "solid\n" + facets + "endsolid\n")
    upper_case += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  check(Format::STL, upper_case, stl_points, triangles);
  check(Format::STL, "solid\nendsolid\n", {}, {});
  BOOST_TEST((mesh_file::read_stl("solid\nendsolid\n").coordinate_type == Number_type::FLOAT64));
}

// Such a text is shorter than a binary file with a face.
BOOST_AUTO_TEST_CASE(stl_text_of_one_face)
{
  std::string text = "solid\n" + stl_facet("0 0 1") + "endsolid";
  text.erase(std::unique(text.begin(), text.end(),
                         [](char a, char b) { return a == ' ' && b == ' '; }), text.end());
  BOOST_TEST(text.size() < 134);
  for (const std::string& padding : paddings)
    check_warnings(Format::STL, text + padding, corner_points, {{0, 1, 2}}, {});
}

BOOST_AUTO_TEST_CASE(stl_text_of_two_solids)
{
  check(Format::STL, "solid a\n" + stl_facet("0 0 1") + "endsolid a\n\nsolid b\n" +
                       stl_facet("0 0 1", "0 0 1") + "endsolid b\n", stl_points,
        {{0, 1, 2}, {0, 1, 3}});
}

BOOST_AUTO_TEST_CASE(stl_text_with_more_or_less)
{
  const std::string first = "solid a\n" + stl_facet("0 0 1"), second = stl_facet("0 0 1", "0 0 1");
  const auto warns = [&](const std::string& middle, const std::string& end,
                         const std::vector<std::string>& warnings) {
    const std::string text = first + middle + second + end;
    check_warnings(Format::STL, text, stl_points, {{0, 1, 2}, {0, 1, 3}}, warnings);
  };
  warns("color 0.5 0 0\n", "color 1 0 0\nendsolid\n",
        {"line 9: 'color' is not 'facet' or 'endsolid'"});
  warns("color 1 0 0 ", "endsolid\nmore\n", {"line 9: 'color' is not 'facet' or 'endsolid'"});
  warns("", "endsolid\nmore words\n", {"line 17: 'more' is not 'facet' or 'endsolid'"});
  warns("", std::string(9, '\0'), {"line 16: the file ends where 'endsolid' should be"});
  warns("", "", {"line 16: the file ends where 'endsolid' should be"});
  warns("solid b\n", "endsolid b\n", {});
  warns("endsolid\n", "endsolid\n" + std::string(9, '\0'), {});
  const std::string text = first.substr(0, first.size() - 1) + " extra words\n" + second;
  check_warnings(Format::STL, text + "endsolid\n", stl_points, {{0, 1, 2}, {0, 1, 3}},
                 {"line 8: 'extra' is not 'facet' or 'endsolid'"});
}

BOOST_AUTO_TEST_CASE(stl_text_with_a_solid_behind_a_name)
{
  std::string second = "solid b " + stl_facet("0 0 1") + "endsolid b\n";
  std::replace(second.begin(), second.end() - 1, '\n', ' ');
  const std::string first = "solid a\n" + stl_facet("0 0 1") + "endsolid a ";
  BOOST_CHECK_THROW(mesh_file::read_stl(first + second), std::runtime_error);
}

BOOST_AUTO_TEST_CASE(stl_text_with_other_normals_and_polygons)
{
  for (const char* normal : {"nan nan nan", "-nan(ind) 0 0", "-1.#IND -1.#IND -1.#IND", ""})
    check(Format::STL, "solid\n" + stl_facet(normal) + "endsolid\n", corner_points, {{0, 1, 2}});
  check(Format::STL, "solid\n" + stl_facet("0 0 1", "0 -0 -0.0\n vertex 0 1 0") + "endsolid\n",
        corner_points, {{0, 1, 0, 2}}); // both zeros are one place
}

BOOST_AUTO_TEST_CASE(stl_binary)
{
  const Polygons triangles{{0, 1, 2}, {0, 1, 3}};
  for (const std::string& header : {std::string("solid a"), std::string("solid a\n facet normal"),
                                    std::string(80, ' '), std::string(80, '\0'),
                                    std::string("\xEF\xBB\xBFsolid")}) {
    const std::string file = binary_stl(header);
    check(Format::STL, file, stl_points, triangles);
    check(Format::STL, file + std::string(7, '\0'), stl_points, triangles);
  }
  BOOST_TEST((mesh_file::read_stl(binary_stl("a")).coordinate_type == Number_type::FLOAT32));
}

BOOST_AUTO_TEST_CASE(stl_contradictions)
{
  const auto fails = [](const std::string& file, const std::string& message)
  { check_failure(Format::STL, file, message); };
  const std::string facet = stl_facet("0 0 1");
  const auto changed = [&](const std::string& word, const std::string& by)
  {
    std::string text = "solid\n" + facet + "endsolid\n";
    return text.replace(text.find(facet) + facet.find(word), word.size(), by);
  };
  fails("sold\n", "line 1: 'sold' is not 'solid'");
  fails(changed("facet", "facit"), "line 2: 'normal' is not 'facet' or 'endsolid'");
  fails(changed("normal", "normel"), "line 2: 'normel' is not 'normal'");
  fails(changed("0 0 1", "0 0 1 2"), "line 2: '2' is not 'outer'");
  fails(changed("outer", "oter"), "line 3: 'oter' is not 'outer'");
  fails(changed("loop", "lop"), "line 3: 'lop' is not 'loop'");
  fails(changed("  vertex 0 0 0\n", ""), "line 6: 'endloop' is not 'vertex'");
  fails(changed("vertex 1", "vortex 1"), "line 5: 'vortex' is not 'vertex'");
  fails(changed("1 0 0", "1 0"), "line 6: 'vertex' is not a number");
  fails(changed("1 0 0", "1 0 0 0"), "line 5: '0' is not 'vertex'");
  fails(changed("endloop", "endlop"), "line 7: 'endlop' is not 'endloop'");
  fails(changed("endfacet", "end"), "line 8: 'end' is not 'endfacet'");
  fails("solid\n", "line 2: the file ends where 'endsolid' should be");
  fails("solid\n0 1 2\nendsolid", "line 2: '0' is not 'facet' or 'endsolid'");
  fails("solid " + with_line_ends(facet, " ") + "endsolid\n",
        "line 1: faces follow the name of the solid on its line");

  const std::string binary = binary_stl("a");
  check_failure(Format::STL, binary_stl(std::string(80, '\0')).substr(0, 183),
                "byte 80: its size fits 1 faces, but its header says 2");
  fails(binary + "more", "byte 184: there is more after the last face");
  fails(binary + std::string(50, 'm'), "byte 184: there is more after the last face: its size fits "
                                       "3 faces, but its header says 2");
  std::string wrong_number = binary;
  wrong_number.replace(80, 4, "\xFF\xFF\xFF\xFF");
  fails(wrong_number, "byte 80: its size fits 2 faces, but its header says 4294967295");
}

// The format

BOOST_AUTO_TEST_CASE(formats)
{
  using mesh_file::format_of_extension;
  BOOST_TEST((format_of_extension(".off") == Format::OFF));
  BOOST_TEST((format_of_extension(".OBJ") == Format::OBJ));
  BOOST_TEST((format_of_extension(".Ply") == Format::PLY));
  BOOST_TEST((format_of_extension(".stl") == Format::STL));
  BOOST_TEST((format_of_extension(".stp") == Format::UNKNOWN));
  BOOST_TEST((format_of_extension("") == Format::UNKNOWN));
  check_failure(Format::UNKNOWN, "", "the format is unknown");

  using mesh_file::format_of_contents;
  BOOST_TEST((format_of_contents("# a comment\nOFF\n") == Format::OFF));
  BOOST_TEST((format_of_contents("\xEF\xBB\xBF" "STCN4nOFF BINARY\n") == Format::OFF));
  BOOST_TEST((format_of_contents("ply\r\n") == Format::PLY));
  BOOST_TEST((format_of_contents("PLY\n") == Format::PLY));
  BOOST_TEST((format_of_contents("SOLID\ta\n") == Format::STL));
  BOOST_TEST((format_of_contents(binary_stl("x")) == Format::STL));
  BOOST_TEST((format_of_contents("# a comment\nv 0 0 0\n") == Format::OBJ));
}

BOOST_AUTO_TEST_CASE(further_numbers_need_not_be_finite)
{
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn nan -nan(ind) inf\nvt nan\nf 1//1 2 3\n";
  BOOST_TEST(mesh_file::read_mesh_file(obj, Format::OBJ, false).number_of_polygons() == 1u);
  const std::string off = "OFF\n3 1 0\n0 0 0 nan\n1 0 0\n0 1 0\n3 0 1 2 inf\n";
  BOOST_TEST(mesh_file::read_mesh_file(off, Format::OFF, false).number_of_polygons() == 1u);
}

BOOST_AUTO_TEST_CASE(points_need_not_be_finite)
{
  const std::string numbers[] = {"nan 0 0", "0 -inf 0", "0 0 1e400", "-1.#IND 1.#INF 1.#QNAN"};
  const float nan = std::nanf("");
  std::vector<std::pair<Format, std::string> > unused, used; // by a polygon
  for (const std::string& point : numbers) {
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n" + point + "\n";
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv " + point + "\n";
    const std::string ply = ply_header("ascii", "element vertex 5\nproperty double x\n"
                                                "property double y\nproperty double z\n"
                                                "element face 3\n"
                                                "property list uchar int vertex_indices\n");
    unused.emplace_back(Format::OFF, "OFF\n5 2 0\n" + points + "3 0 1 2\n3 2 1 3\n");
    unused.emplace_back(Format::OBJ, obj + "f 1 2 3\nf 3 2 4\n");
    used.emplace_back(Format::OFF, "OFF\n5 3 0\n" + points + "3 0 1 2\n4 0 1 3 4\n3 4 2 1\n");
    used.emplace_back(Format::OBJ, obj + "f 1 2 3\nf 1 2 4 5\nf 5 3 2\n");
    used.emplace_back(Format::PLY, ply + points + "3 0 1 2\n4 0 1 3 4\n3 4 2 1\n");
  }
  Bytes off(true, "OFF BINARY\n");
  off.ints({5, 3, 0}).floats(corner_floats).floats({1, 1, 0, 0, nan, 0});
  used.emplace_back(Format::OFF, off.ints({3, 0, 1, 2, 0, 4, 0, 1, 3, 4, 0, 3, 4, 2, 1, 0})());
  const auto read = [](const std::pair<Format, std::string>& file) {
    Polygon_soup soup = mesh_file::read_mesh_file(file.second, file.first, true);
    BOOST_TEST(!mesh_file::is_finite(soup.points[4]));
    soup.points.resize(4);
    return soup;
  };
  for (const auto& file : unused) {
    const Polygon_soup soup = read(file);
    check(soup, square_points, {{0, 1, 2}, {2, 1, 3}});
    BOOST_TEST(soup.warnings.empty());
  }
  for (const auto& file : used) {
    const Polygon_soup soup = read(file);
    check(soup, square_points, {{0, 1, 2}, {0, 1, 3}, {2, 1}});
    BOOST_REQUIRE(soup.warnings.size() == 1u);
    BOOST_TEST(soup.warnings[0] == "face 1 uses a point that is not finite; corners left out: 2");
  }
}

BOOST_AUTO_TEST_CASE(corners_that_are_not_finite_have_one_place)
{
  const std::string facet = stl_facet("0 0 1");
  const Polygon_soup soup = mesh_file::read_mesh_file(
    "solid\n" + stl_facet("0 0 1", "nan 0 0") + facet + stl_facet("0 0 1", "0 0 -inf") +
      "endsolid\n", Format::STL, false);
  BOOST_TEST(soup.points.size() == 4u);
  BOOST_TEST(soup.number_of_polygons() == 3u);
  BOOST_TEST(soup.corners.size() == 7u);
  const Polygon_soup mapped = mesh_file::read_mesh_file(
    "v nan 0 0\nv 0 0 0\nv 1 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n", Format::OBJ, true);
  BOOST_TEST((mapped.texture_of_corner == std::vector<Index>{1, 2}));
  BOOST_TEST(mapped.warnings[0] == "face 0 uses a point that is not finite; corners left out: 1");
}

#ifdef __unix__
BOOST_AUTO_TEST_CASE(jobs_divide_the_memory)
{
  const auto memory = [](std::size_t number_of_jobs) {
    segment_mesh::Reading_limits limits;
    limits.number_of_jobs = number_of_jobs;
    return segment_mesh::child_limits(0, limits).memory;
  };
  BOOST_TEST(memory(1) <= 4000000000u);
  BOOST_TEST(memory(1000) <= memory(500) / 2 + 1);
}
#endif

BOOST_AUTO_TEST_CASE(contents_determine_the_format)
{
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string ply = ply_header("ascii", ply_points + ply_faces) + ply_body;
  const std::string stl = "solid\n" + stl_facet("0 0 1") + "endsolid\n";
  for (Format format : {Format::OFF, Format::OBJ, Format::PLY, Format::STL, Format::UNKNOWN})
    for (const std::string& file : {off, obj, ply, stl, "\xEF\xBB\xBF" + obj})
      check(format, file, corner_points, {{0, 1, 2}});
  // The size identifies binary STL, whatever its first word is.
  check(Format::STL, binary_stl("OFF"), stl_points, {{0, 1, 2}, {0, 1, 3}});
  check(Format::OBJ, binary_stl("v"), stl_points, {{0, 1, 2}, {0, 1, 3}});
  // Files without a mark have the format of their names.
  check(Format::OFF, off.substr(4), corner_points, {{0, 1, 2}});
  check(Format::OBJ, "f 1 2 3\n" + obj.substr(0, 24), corner_points, {{0, 1, 2}});
}

BOOST_AUTO_TEST_CASE(contents_that_are_no_mesh)
{
  const std::string iges = std::string(72, ' ') + "S      1\n";
  const std::string zip("PK\3\4\0\0", 6);
  const std::vector<std::pair<std::string, std::string> > cases = {
    {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n",
     "it is a Git LFS pointer; git lfs pull fetches the file"},
    {"\x1F\x8B\x08", "it is compressed by gzip; unpack it"},
    {zip + "a.off", "it is a ZIP archive; unpack it"},
    {"\n<!DOCTYPE HTML>\n", "it is an HTML page; download the mesh itself"},
    {"ISO-10303-21;\n", "it is CAD in STEP; export a mesh, such as STL"},
    {iges, "it is CAD in IGES; export a mesh, such as STL"},
    {"MeshVersionFormatted 1\n",
     "it is Medit; the command meshio convert IN.mesh OUT.ply makes PLY of it"},
    {"# vtk DataFile Version 3.0\n",
     "it is VTK; ParaView, or the command pyvista convert IN.vtp OUT.ply, makes PLY of it"},
    {"<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">",
     "it is VTK; ParaView, or the command pyvista convert IN.vtp OUT.ply, makes PLY of it"},
    {"#VRML V2.0 utf8\n", "it is VRML; MeshLab makes PLY of it"},
    {std::string("\xFF\xFEv\0 \0", 6), "it is UTF-16; save it as UTF-8"},
    {zip + "3D/3dmodel.model",
     "it is 3MF, which is read only from a file with the ending .3mf"},
    {"glTF\2", "it is binary glTF, which is read only from a file with the ending .glb"}};
  for (const auto& [file, message] : cases)
    for (Format format : {Format::OFF, Format::OBJ, Format::PLY, Format::STL, Format::UNKNOWN})
      check_failure(format, file, message);
  // If a library refuses a file, the message does not say that a library is needed.
  BOOST_TEST(mesh_file::other_contents("glTF\2", false) == "");
}

BOOST_AUTO_TEST_CASE(off_with_a_number_joined_to_the_keyword)
{
  const std::string rest = "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const char* keyword : {"OFF", "4OFF", "COFF"}) {
    BOOST_TEST((mesh_file::format_of_contents(keyword + rest) == Format::OFF));
    if (keyword[0] != '4')
      check(Format::OFF, keyword + rest, corner_points, {{0, 1, 2}});
  }
  check_failure(Format::OFF, "OFFx" + rest, "line 1: 'OFFx3' is not OFF");
}

BOOST_AUTO_TEST_SUITE_END()
