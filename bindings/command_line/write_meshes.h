// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_WRITE_MESHES_H
#define SEGMENT_MESH_WRITE_MESHES_H

#include "../meshes/Failure.h"
#include "Output_files.h"
#include "../files/Segmented_soup.h"
#include "../files/convex_hull.h"
#include "../files/limited_hull.h"
#include "../files/write_mesh_file.h"
#include "../meshes/segment_neighbors.h"
#include "../files/segment_colors.h"
#include "../files/write_by_lib3mf.h"

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace segment_mesh {

// Throws `Failure` if a file of this name would be of no format, or of one that this
// build does not write.
inline void check_output_format(const std::filesystem::path& name, bool is_part)
{
  if (!has_lib3mf && is_3mf(mesh_file::output_extension(name)))
    throw Failure(Status::USAGE, "cannot write " + name.string() + ": this build has no 3MF, which "
                                 "needs lib3mf at build time");
  const std::string file = name.filename().string();
  if (mesh_file::output_extension(name) == ".obj" && file.find_first_of("\r\n") != file.npos)
    throw Failure(Status::USAGE, "the name of an OBJ file has a line break, but the file has to "
                                 "name its materials in one line");
  try {
    mesh_file::check_output_format(name, is_part, has_lib3mf ? ".3mf" : "");
  }
  catch (const std::runtime_error& e) {
    const std::string pictures = " .png .jpg .jpeg .gif .svg .pdf .bmp .tif .tiff .webp ";
    const std::string ending = ' ' + mesh_file::output_extension(name) + ' ';
    throw Failure(Status::USAGE, std::string(e.what()) + (
      ending == " .stl " ? "; STL has no colors, but is a --split-format" :
      pictures.find(ending) == pictures.npos ? "" :
      "; for a picture, --html FILE shows the segments and saves PNG, and scripts/render.py draws "
      "a .ply"));
  }
}

// Returns the factor to the unit of a format, if it has one: 3MF has millimeters, and glTF meters.
// The unit of a mesh is given in millimeters, or 0 if it is unknown.
inline double factor_of_format(const std::string& extension, double unit)
{ return unit == 0 ? 1 : is_3mf(extension) ? unit : extension == ".glb" ? unit / 1000 : 1; }

inline void write_mesh(std::ostream& out, const std::string& extension,
                       const mesh_file::Segmented_soup& mesh, double unit,
                       const std::string& materials = "")
{
  const double factor = factor_of_format(extension, unit);
  if (factor != 1) {
    Polygon_soup scaled = mesh.soup;
    mesh_file::scale(scaled, factor);
    return write_mesh(out, extension, {scaled, mesh.segment, mesh.colors, mesh.parts, mesh.faces,
                                       mesh.keeps_materials}, 0, materials);
  }
  try {
    if (is_3mf(extension))
      write_3mf(out, mesh);
    else
      mesh_file::write_mesh_file(out, extension, mesh, materials);
  }
  catch (const std::runtime_error& e) { // for example, a coordinate is too large for the format
    throw Failure(Status::OUTPUT, e.what());
  }
}

// Writes images by a function that takes names of files and writers. Returns the names, which are
// empty for missing images.
template <class Write>
std::vector<std::string> write_images(const std::vector<mesh_file::Image>& images,
                                      const std::string& start, const Write& write)
{
  std::vector<std::string> names;
  for (std::size_t i = 0; i < images.size(); ++i) {
    names.emplace_back();
    if (!images[i].bytes)
      continue;
    names[i] = start + mesh_file::three_digits(i) + "." + mesh_file::type_of(images[i]);
    write(names[i], [&](std::ostream& out) { out << *images[i].bytes; });
  }
  return names;
}

// Writes a mesh in the format of the ending of the name. OBJ has its materials and their images in
// files beside it.
inline void write_mesh(Output_files& files, const std::filesystem::path& name,
                       const mesh_file::Segmented_soup& mesh, double unit)
{
  const std::string extension = mesh_file::output_extension(name);
  const std::filesystem::path materials = mesh_file::name_of_materials(name);
  files.write(name, [&](std::ostream& out)
              { write_mesh(out, extension, mesh, unit, materials.filename().string()); });
  if (extension != ".obj")
    return;
  std::vector<std::string> images;
  if (mesh.has_materials())
    images = write_images(mesh.soup.images, name.stem().string() + "_texture_",
                          [&](const std::string& image, const auto& writer)
                          { files.write(name.parent_path() / image, writer); });
  files.write(materials, [&](std::ostream& out) { mesh_file::write_mtl(out, mesh, images); });
}

// Writes a mesh for each segment, in the files segment_000, segment_001 ... with the extension, and
// what holds for the closed segments. The meshes have the materials of the whole, if there are any.
inline void write_segments(Output_files& files, const std::filesystem::path& directory,
                           const std::string& extension, const mesh_file::Segmented_soup& mesh,
                           double unit, const nlohmann::ordered_json& closed_segments)
{
  files.start_segments(directory, closed_segments);
  mesh_file::Segment_extraction extract(mesh);
  const bool has_mtl = extension == ".obj" && !mesh.soup.materials.empty();
  std::vector<std::string> images;
  if (has_mtl)
    images = write_images(mesh.soup.images, "texture_",
                          [&](const std::string& name, const auto& writer)
                          { files.write_segment(name, writer); });
  for (std::size_t s = 0; s < extract.number_of_segments(); ++s) {
    const Polygon_soup part = extract(s);
    if (part.number_of_polygons() == 0) // it is missing in a mesh that got its labels
      continue;
    const std::vector<Index> segment(part.number_of_polygons(), static_cast<Index>(s));
    const mesh_file::Segmented_soup written{part, segment, mesh.colors, {}, {}, true};
    const std::string name = mesh_file::segment_name(s);
    files.write_segment(name + extension, [&](std::ostream& out)
                        { write_mesh(out, extension, written, unit, has_mtl ? name + ".mtl" : "");
                        });
    if (has_mtl)
      files.write_segment(name + ".mtl", [&](std::ostream& out)
                          { mesh_file::write_mtl(out, written, images); });
  }
}

// Returns the convex hull of each segment; it is empty if the segment is missing.
inline std::vector<mesh_file::Convex_hull> segment_hulls(const mesh_file::Segmented_soup& mesh,
                                                         std::size_t maximum_number_of_vertices)
{
  std::vector<Point> corners;
  for (Index v : mesh.soup.corners)
    corners.push_back(mesh.soup.points[v]);
  const double extent = mesh_file::extent_of(corners);
  mesh_file::Segment_extraction extract(mesh);
  std::vector<mesh_file::Convex_hull> result;
  for (std::size_t s = 0; s < extract.number_of_segments(); ++s)
    result.push_back(mesh_file::limited_hull(mesh_file::convex_hull(extract(s).points, extent),
                                             maximum_number_of_vertices));
  return result;
}

// Writes the hull of each segment, in files as those of segments. Returns their properties, and
// adds a warning if some have a thickness. The volumes of solid segments are given, otherwise NaN.
inline nlohmann::ordered_json
write_hulls(Output_files& files, const std::filesystem::path& directory,
            const std::string& extension, const std::vector<mesh_file::Convex_hull>& hulls,
            const std::vector<Rgb>& colors, double unit, const std::vector<double>& volumes,
            std::vector<std::string>& warnings)
{
  auto report = nlohmann::ordered_json::array();
  std::ostringstream warning;
  files.start_segments(directory);
  for (std::size_t s = 0; s < hulls.size(); ++s) {
    const mesh_file::Convex_hull& hull = hulls[s];
    if (hull.points.empty())
      continue;
    Polygon_soup soup;
    soup.points = hull.points;
    for (const Triangle& t : hull.triangles) {
      soup.corners.insert(soup.corners.end(), t.begin(), t.end());
      soup.end_polygon();
    }
    const std::vector<Index> segment(hull.triangles.size(), static_cast<Index>(s));
    files.write_segment(mesh_file::segment_name(s) + extension, [&](std::ostream& out)
                        { write_mesh(out, extension, {soup, segment, colors}, unit); });
    const double volume = mesh_file::volume(hull);
    report.push_back({{"label", s}, {"vertices", hull.points.size()}, {"faces", segment.size()},
                      {"thickness", hull.thickness}, {"volume", volume},
                      {"volume_ratio", volume / volumes[s]}});
    if (hull.thickness > 0)
      warning << (warning.tellp() > 0 ? ", " : "flat segments got a hull of the thickness " +
                                                 nlohmann::json(hull.thickness).dump() + ": ") << s;
  }
  if (warning.tellp() > 0)
    warnings.push_back(warning.str());
  return report;
}

// Writes the labels, one per line.
inline void write_labels(std::ostream& out, const std::vector<Index>& labels)
{
  std::string lines;
  for (Index label : labels) {
    lines += std::to_string(label);
    lines += '\n';
  }
  out << lines;
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_WRITE_MESHES_H
