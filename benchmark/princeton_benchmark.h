// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_PRINCETON_BENCHMARK_H
#define SEGMENTATION_BENCHMARK_PRINCETON_BENCHMARK_H

#include "segmentation_metrics.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Reading of the Princeton Segmentation Benchmark, a folder with off/N.off and, for each person,
// seg/Benchmark/N/N_k.seg.
namespace segmentation_benchmark {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

constexpr int meshes_per_category = 20;

constexpr std::array<const char*, 20> category_names = {
  "Human", "Cup", "Glasses", "Airplane", "Ant", "Chair", "Octopus", "Table", "Teddy", "Hand",
  "Plier", "Fish", "Bird", "Spring", "Armadillo", "Bust", "Mech", "Bearing", "Vase", "Fourleg"};

inline std::size_t category(int id)
{ return static_cast<std::size_t>(id - 1) / meshes_per_category; }

// Returns whether people have cut the mesh: springs are among the meshes, but nobody has cut them.
inline bool is_in_benchmark(int id)
{
  return id >= 1 && category(id) < category_names.size() &&
         category_names[category(id)] != std::string("Spring");
}

inline void add_id_range(const std::string& text, std::set<int>& ids)
{
  std::istringstream in(text);
  int first, last;
  char dash = '-';
  if (!(in >> first) || !(in.eof() || in >> dash) || dash != '-')
    throw std::invalid_argument("not a mesh or a range of meshes: '" + text + "'");
  if (in.eof())
    last = first;
  else if (!(in >> last) || !in.eof())
    throw std::invalid_argument("not a range of meshes: '" + text + "'");
  for (int id = first; id <= last; ++id)
    ids.insert(id);
}

// Returns ids in ascending order from "odd", "even", "all" or a list as "1-20,33".
inline std::vector<int> parse_ids(const std::string& text)
{
  std::set<int> ids;
  const int last = meshes_per_category * static_cast<int>(category_names.size());
  if (text == "all" || text == "odd" || text == "even") {
    for (int id = 1; id <= last; ++id)
      if (text == "all" || (id % 2 == 1) == (text == "odd"))
        ids.insert(id);
  }
  else {
    std::istringstream in(text);
    for (std::string item; std::getline(in, item, ',');)
      add_id_range(item, ids);
  }
  std::vector<int> result;
  std::copy_if(ids.begin(), ids.end(), std::back_inserter(result), is_in_benchmark);
  if (result.empty())
    throw std::invalid_argument("no mesh of the benchmark is in '" + text + "'");
  return result;
}

inline Mesh read_mesh(const std::filesystem::path& path)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(path.string(), mesh))
    throw std::runtime_error("cannot read " + path.string());
  return mesh;
}

inline Labels read_labels(const std::filesystem::path& path, std::size_t number_of_faces)
{
  std::ifstream in(path);
  Labels labels;
  for (std::size_t label; in >> label;)
    labels.push_back(label);
  if (labels.size() != number_of_faces)
    throw std::runtime_error(path.string() + " has not one label for each face");
  return contiguous(labels);
}

inline std::vector<Labels> read_people(const std::filesystem::path& folder,
                                       std::size_t number_of_faces)
{
  std::set<std::filesystem::path> files; // sorted: sums are the same on every machine
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".seg")
      files.insert(entry.path());
  if (files.empty())
    throw std::runtime_error(folder.string() + " has no .seg file");
  std::vector<Labels> people;
  for (const std::filesystem::path& file : files)
    people.push_back(read_labels(file, number_of_faces));
  return people;
}

struct Benchmark_mesh
{
  int id;
  Mesh mesh;
  std::vector<Labels> people;
};

inline Benchmark_mesh read_benchmark_mesh(const std::filesystem::path& folder, int id)
{
  const std::string name = std::to_string(id);
  Benchmark_mesh result{id, read_mesh(folder / "off" / (name + ".off")), {}};
  result.people =
    read_people(folder / "seg" / "Benchmark" / name, result.mesh.number_of_faces());
  return result;
}

// Returns the most frequent number of segments of people, the smallest of ties.
inline std::size_t usual_number_of_segments(const std::vector<Labels>& people)
{
  std::map<std::size_t, int> votes;
  for (const Labels& labels : people)
    ++votes[number_of_segments(labels)];
  return std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b)
                          { return a.second < b.second; })->first;
}

inline double mean_rand_error(const Labels& labels, const std::vector<Labels>& people)
{
  Mean mean;
  for (const Labels& person : people)
    mean.add(rand_error(labels, person));
  return mean();
}

// Returns the mean error over all pairs of people, in which the order of the two does not matter.
inline double mean_rand_error_of_people(const std::vector<Labels>& people)
{
  Mean mean;
  for (std::size_t i = 0; i < people.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      mean.add(rand_error(people[i], people[j]));
  return mean();
}

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_PRINCETON_BENCHMARK_H
