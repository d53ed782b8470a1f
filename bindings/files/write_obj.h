// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_WRITE_OBJ_H
#define SEGMENT_MESH_MESH_FILE_WRITE_OBJ_H

#include "Segmented_soup.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace mesh_file {

// Returns the names of the materials, and at the end one for polygons without a material. They are
// different, and have no blank at an end.
inline std::vector<std::string> names_for_mtl(const std::vector<Material>& materials)
{
  std::vector<std::string> result;
  std::set<std::string> used;
  for (std::size_t i = 0; i <= materials.size(); ++i) {
    std::string name = i < materials.size() ? materials[i].name : "plain";
    std::replace_if(name.begin(), name.end(), [](char c) { return c >= 0 && c < ' '; }, '_');
    if (name.empty() || name.front() == ' ' || name.back() == ' ')
      name = "material" + name + '_';
    while (!used.insert(name).second)
      name += '_';
    result.push_back(name);
  }
  return result;
}

inline void write_kept_materials(Block_output& block, const Polygon_soup& soup,
                                 const std::vector<std::string>& image_files)
{
  const std::vector<std::string> names = names_for_mtl(soup.materials);
  for (Index m : used_materials(soup)) {
    block.text("newmtl " + names[m] + "\n");
    if (m == soup.materials.size()) {
      block.text("Kd 0.8 0.8 0.8\n");
      continue;
    }
    for (const Material::Statement& s : soup.materials[m].statements) {
      block.text(s.text);
      if (s.image != Material::no_image)
        block.text(" " + (image_files.at(s.image).empty() ? soup.images[s.image].name
                                                          : image_files[s.image]));
      block.text("\n");
    }
  }
}

// Writes the materials for `write_obj()`: those of the soup with the files of its images, or one
// for each segment that has polygons. An image without a file keeps its name.
inline void write_mtl(std::ostream& out, const Segmented_soup& mesh,
                      const std::vector<std::string>& image_files = {})
{
  Block_output block(out);
  if (mesh.has_materials()) {
    write_kept_materials(block, mesh.soup, image_files);
    return block.flush();
  }
  for (Index s : present_segments(mesh)) {
    block.text("newmtl " + segment_name(s) + "\nKd");
    for (std::uint8_t c : mesh.colors[s]) {
      block.text(" ");
      block.decimal(static_cast<float>(c) / 255);
    }
    block.text("\n");
  }
  block.flush();
}

class Obj_writer
{
  const Segmented_soup& mesh_;
  Block_output out_;
  const Used_points used_;

  static Index of_corner(const std::vector<Index>& numbers, std::size_t corner)
  { return numbers.empty() ? null_index : numbers[corner]; }

  void put_points()
  {
    const Polygon_soup& soup = mesh_.soup;
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      if (used_.number[v] != null_index) {
        out_.text("v ");
        out_.decimal(soup.points[v], soup.coordinate_type);
        out_.text("\n");
      }
    for (const Texture_point& t : soup.texture_coordinates) {
      out_.text("vt ");
      out_.decimal(t[0]);
      out_.text(" ");
      out_.decimal(t[1]);
      out_.text("\n");
    }
    for (const Point& normal : soup.normals) {
      out_.text("vn ");
      out_.decimal(normal, Number_type::FLOAT64);
      out_.text("\n");
    }
  }

  // Writes a corner: point, point/texture, point//normal or point/texture/normal, counted from 1.
  void put_corner(std::size_t corner)
  {
    const Index texture = of_corner(mesh_.soup.texture_of_corner, corner);
    const Index normal = of_corner(mesh_.soup.normal_of_corner, corner);
    out_.text(" ");
    out_.decimal(used_.number[mesh_.soup.corners[corner]] + 1);
    if (texture != null_index || normal != null_index)
      out_.text("/");
    if (texture != null_index)
      out_.decimal(texture + 1);
    if (normal != null_index) {
      out_.text("/");
      out_.decimal(normal + 1);
    }
  }

public:
  Obj_writer(std::ostream& out, const Segmented_soup& mesh)
    : mesh_(mesh), out_(out), used_(mesh.soup) {}

  void operator()(const std::string& materials)
  {
    const Polygon_soup& soup = mesh_.soup;
    if (!materials.empty())
      out_.text("mtllib " + materials + "\n");
    put_points();
    const std::vector<std::string> names = names_for_mtl(soup.materials);
    Index segment = null_index, material = null_index;
    for (Index i : polygons_sorted_by_segment(mesh_)) {
      if (soup.polygon(i).size() < 3)
        continue;
      if (segment != mesh_.segment[i]) {
        segment = mesh_.segment[i];
        const std::string name = segment_name(segment);
        out_.text("g " + name + "\n");
        if (!materials.empty() && !mesh_.has_materials())
          out_.text("usemtl " + name + "\n");
      }
      if (!materials.empty() && mesh_.has_materials() && material != material_of(soup, i)) {
        material = material_of(soup, i);
        out_.text("usemtl " + names[material] + "\n");
      }
      out_.text("f");
      for (std::size_t c = soup.first_corner[i]; c < soup.first_corner[i + 1]; ++c)
        put_corner(c);
      out_.text("\n");
    }
    out_.flush();
  }
};

// Writes a mesh in OBJ, the polygons of each segment as a group. Only names the file of their
// materials, if there is one. Leaves out polygons with fewer than three corners.
inline void write_obj(std::ostream& out, const Segmented_soup& mesh, const std::string& materials)
{ Obj_writer(out, mesh)(materials); }

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_WRITE_OBJ_H
