// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_PICTURE_BOOK_H
#define MANUAL_FIGURES_PICTURE_BOOK_H

#include "../../benchmark/princeton_benchmark.h"
#include "files/segment_colors.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Writes the pictures of the manual as colored meshes and a list of them, which draw_figures.py
// draws.
namespace manual_figures {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
using segmentation_benchmark::Mesh;
typedef nlohmann::json Json;
using segment_mesh::Rgb;

inline Json json_of(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

// A mesh, by the name of its file without the ending; cameras are found by this name.
struct Named_mesh
{
  std::string name;
  Mesh mesh;
};

// A mesh with one color per face, and balls and tubes on it.
struct Picture
{
  const Named_mesh& shape;
  std::string caption;
  std::vector<Rgb> colors;
  Json extras = Json::object();

  void add_ball(const Kernel::Point_3& center, const Rgb& color)
  { extras["balls"].push_back({{"center", json_of(center)}, {"color", color}}); }

  // Adds a tube of `width` times the usual radius.
  void add_tube(const Kernel::Point_3& from, const Kernel::Point_3& to, const Rgb& color,
                double width)
  {
    extras["tubes"].push_back(
      {{"from", json_of(from)}, {"to", json_of(to)}, {"color", color}, {"width", width}});
  }
};

class Picture_book
{
  std::filesystem::path folder_;
  Json figures_ = Json::object();
  Json charts_ = Json::object();

public:
  explicit Picture_book(std::filesystem::path folder) : folder_(std::move(folder))
  { std::filesystem::create_directories(folder_); }

  // Adds a picture to a figure.
  void add(const std::string& figure, const Picture& picture)
  {
    Mesh mesh = picture.shape.mesh;
    const auto color = mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
    for (Mesh::Face_index f : mesh.faces()) {
      const Rgb& c = picture.colors[f];
      color[f] = CGAL::IO::Color(c[0], c[1], c[2]);
    }
    const std::string name = figure + "_" + std::to_string(figures_[figure].size());
    std::ofstream out(folder_ / (name + ".ply"), std::ios::binary);
    CGAL::IO::set_binary_mode(out);
    if (!CGAL::IO::write_PLY(out, mesh))
      throw std::runtime_error("cannot write " + name);
    Json entry = picture.extras;
    entry["name"] = name;
    entry["mesh"] = picture.shape.name;
    entry["caption"] = picture.caption;
    figures_[figure].push_back(std::move(entry));
  }

  void add_chart(const std::string& name, Json data) { charts_[name] = std::move(data); }

  void write_list() const
  {
    std::ofstream out(folder_ / "figures.json");
    out << Json{{"figures", figures_}, {"charts", charts_}};
    if (!out.flush())
      throw std::runtime_error("cannot write figures.json");
  }
};

} // namespace manual_figures

#endif // MANUAL_FIGURES_PICTURE_BOOK_H
