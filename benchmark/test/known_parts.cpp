// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../score_known_parts.h"
#include "test_meshes.h"

#include <CGAL/boost/graph/copy_face_graph.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(known_parts)

using namespace segmentation_benchmark;
using test_meshes::disjoint_union;
using test_meshes::plate;

namespace tt = boost::test_tools;

namespace {

Triangle_soup soup_of(const test_meshes::Soup& soup)
{
  Triangle_soup result;
  for (const test_meshes::Point& p : soup.points)
    result.points.emplace_back(p.x(), p.y(), p.z());
  result.triangles = soup.triangles;
  return result;
}

// Plates with 190, 4, 5 and 1 of 200 squares. The third one has two parts, with 3 and 2 squares; in
// the last one each triangle is a part, of 0.25 % of the area.
Known_parts four_plates()
{
  Known_parts result;
  result.name = "plates";
  result.soup = soup_of(disjoint_union(disjoint_union(plate(19, 10), plate(2, 2)),
                                       disjoint_union(plate(5, 1), plate(1, 1))));
  result.truth.assign(2 * 190, 0);
  for (std::size_t squares : {4, 3, 2})
    result.truth.insert(result.truth.end(), 2 * squares, number_of_segments(result.truth));
  result.truth.insert(result.truth.end(), {4, 5});
  return result;
}

// A new directory, which is removed after a test.
class Directory
{
  std::filesystem::path path_;

public:
  Directory()
  {
    std::string name = (std::filesystem::temp_directory_path() / "known_parts.XXXXXX").string();
    BOOST_REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }

  ~Directory() { std::filesystem::remove_all(path_); }

  const std::filesystem::path& path() const { return path_; }

  void make(const std::string& name, const std::string& content) const
  { std::ofstream(path_ / name) << content; }
};

const std::vector<Row> only_references = rows_of_known_parts({});

} // namespace

// The components, taken as segments, find the second plate and, with 3 squares of 5, one of the two
// parts of the third; the other has 2 squares of 5. They join 2 * 3 * 2 ordered pairs of squares
// wrongly on the third plate, and 2 * 1/2 * 1/2 on the last one.
BOOST_AUTO_TEST_CASE(scores_of_references_by_hand)
{
  const Known_parts input = four_plates();
  BOOST_TEST_REQUIRE(input.truth.size() == input.soup.triangles.size());
  const Scored_known_parts scored = Known_parts_scorer(input)(only_references);
  BOOST_TEST(scored.name == "plates");
  BOOST_TEST(scored.parts == 4u);       // without those of the last plate
  BOOST_TEST(scored.small_parts == 3u); // and without the first plate
  BOOST_TEST_REQUIRE(scored.scores.size() == 2u);

  const Known_parts_score& one = scored.scores[0];
  BOOST_TEST(one.segments == 1u);
  BOOST_TEST(one.found == 0u);
  BOOST_TEST(one.by_area == 1 - (190 * 190 + 16 + 9 + 4 + 2 * 0.25) / 40000.,
             tt::tolerance(1e-12));
  BOOST_TEST(one.panoptic_quality == 0.95 * 2 / (1 + 6), tt::tolerance(1e-12));

  const Known_parts_score& components = scored.scores[1];
  BOOST_TEST(components.segments == 4u);
  BOOST_TEST(components.found == 2u);
  BOOST_TEST(components.by_area == (2 * 3 * 2 + 2 * 0.5 * 0.5) / 40000., tt::tolerance(1e-9));
  BOOST_TEST(components.panoptic_quality == (1 + 1 + 3 / 5.) * 2 / (4 + 6), tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(fraction_found_is_of_all_parts)
{
  std::vector<Scored_known_parts> meshes(2);
  meshes[0].scores.resize(1);
  meshes[1].scores.resize(1);
  BOOST_TEST(std::isnan(fraction_found(meshes, 0)));
  meshes[0].small_parts = 1;
  meshes[0].scores[0].found = 1;
  meshes[1].small_parts = 4;
  BOOST_TEST(fraction_found(meshes, 0) == 1 / 5., tt::tolerance(1e-12));
}

// Three triangles at the edge of the points 0 and 1, two at the edge 4 5, and one that has but the
// point 0 in common with others.
BOOST_AUTO_TEST_CASE(components_are_connected_by_edges)
{
  Triangle_soup soup;
  for (int i = 0; i < 10; ++i)
    soup.points.emplace_back(i, i * i, i * i * i);
  soup.triangles = {{0, 1, 2}, {5, 4, 6}, {1, 0, 3}, {0, 8, 9}, {0, 1, 4}, {4, 5, 7}};
  BOOST_TEST(components(soup) == (Labels{0, 1, 0, 2, 0, 1}), tt::per_element());
}

BOOST_AUTO_TEST_CASE(areas_of_triangles)
{
  BOOST_TEST(triangle_areas(soup_of(plate(2, 1))) == std::vector<double>(4, 0.5),
             tt::per_element());
}

BOOST_AUTO_TEST_CASE(files_with_their_parts)
{
  const Directory directory;
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -1\n";
  directory.make("b.off", "OFF\n5 3 0\n" + points + "3 0 1 2\n3 0 1 3\n3 0 1 4\n");
  directory.make("b.truth", "7\n2\n7\n");
  directory.make("a.off", "OFF\n5 1 0\n" + points + "3 0 1 2\n");
  directory.make("quad.off", "OFF\n5 1 0\n" + points + "4 0 1 2 3\n");
  directory.make("quad.truth", "0\n");

  const std::vector<std::filesystem::path> files = off_files(directory.path());
  BOOST_TEST_REQUIRE(files.size() == 3u);
  const Known_parts input = read_known_parts(files[1]);
  BOOST_TEST(input.name == "b");
  BOOST_TEST(input.soup.points.size() == 5u);
  BOOST_TEST(input.soup.triangles[2] == (std::vector<std::size_t>{0, 1, 4}), tt::per_element());
  BOOST_TEST(input.truth == (Labels{0, 1, 0}), tt::per_element());

  BOOST_CHECK_THROW(read_known_parts(files[0]), std::runtime_error); // has no parts
  BOOST_CHECK_THROW(read_known_parts(files[2]), std::runtime_error);
  BOOST_CHECK_THROW(off_files(std::filesystem::current_path() / "no such folder"),
                    std::runtime_error);
}

BOOST_AUTO_TEST_CASE(soups_have_the_trees_of_their_meshes)
{
  Mesh mesh;
  CGAL::copy_face_graph(test_meshes::mesh_of(test_meshes::torus(1, 0.3, 24, 12)), mesh);
  const Triangle_soup soup = soup_of(test_meshes::torus(1, 0.3, 24, 12));
  for (const Tree_method& method : tree_methods()) {
    const Segmentation_hierarchy of_mesh = method.segment(mesh, any_salience, 5),
                                 of_soup = method.segment_soup(soup, any_salience, 5);
    BOOST_TEST(of_mesh.number_of_segments() >= 5u);
    BOOST_TEST(labels_of_tree(of_soup, any_salience, 5) ==
                 labels_of_tree(of_mesh, any_salience, 5),
               tt::per_element());
  }
}

BOOST_AUTO_TEST_CASE(rows_that_need_no_people)
{
  const std::vector<Row> rows = {{people_method, Protocol::OTHERS},
                                 {"calibrated", Protocol::K},
                                 {"calibrated", Protocol::AUTO, "decimated"},
                                 {"sdf", Protocol::AUTO},
                                 {"one", Protocol::AUTO}};
  std::vector<std::string> titles;
  for (const Row& row : rows_of_known_parts(rows))
    titles.push_back(title(row));
  BOOST_TEST(titles == (std::vector<std::string>{"calibrated k", "one auto", "components auto"}),
             tt::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
