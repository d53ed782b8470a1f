// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_READ_SCENE_IN_CHILD_H
#define SEGMENT_MESH_READ_SCENE_IN_CHILD_H

#include "Scene.h"
#include "read_in_child_process.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace segment_mesh {

// The polygons of one mesh at one node; they come after those of the instance before.
struct Mesh_instance
{
  mesh_file::Index node, mesh, end_of_polygons;
};

// The data of a scene that the child process sends.
struct Flat_scene
{
  mesh_file::Polygon_soup soup;
  std::vector<Mesh_instance> instances;
  std::vector<char> node_names, mesh_names; // each ends with a zero
  // The names and descriptions of the materials of the soup, and the bytes of the images in the
  // file, one after the other
  std::vector<char> material_names, materials, images;
  std::vector<std::size_t> ends_of_images;

  static void append_name(std::string_view name, std::vector<char>& names)
  {
    names.insert(names.end(), name.begin(), name.end());
    names.push_back('\0');
  }
};

inline void send_error(const std::string& sentence, Child_output output)
{ output.send(std::vector<char>(sentence.begin(), sentence.end())); }

inline void send_scene(const Flat_scene& scene, Child_output output)
{
  send_error("", output);
  output.send(std::vector<mesh_file::Number_type>{scene.soup.coordinate_type});
  output.send(scene.soup.points);
  output.send(scene.soup.corners);
  output.send(scene.soup.first_corner);
  output.send(scene.instances);
  output.send(scene.node_names);
  output.send(scene.mesh_names);
  output.send(scene.soup.texture_coordinates);
  output.send(scene.soup.texture_of_corner);
  output.send(scene.soup.normals);
  output.send(scene.soup.normal_of_corner);
  output.send(scene.material_names);
  output.send(scene.materials);
  output.send(scene.soup.material_of_polygon);
  output.send(scene.images);
  output.send(scene.ends_of_images);
}

inline bool is_clear_sentence(std::string_view text)
{
  return !text.empty() && text.size() < 300 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

// Takes the scene from the child process, and believes nothing.
class Scene_receiver
{
  typedef mesh_file::Index Index;

  Child_process& child_;

  static void check(bool condition)
  {
    if (!condition)
      throw std::runtime_error("the reader of this format crashed");
  }

  std::vector<std::string> receive_names()
  {
    std::vector<std::string> result;
    const std::vector<char> names = child_.receive<char>();
    for (auto i = names.begin(); i != names.end();) {
      const auto end = std::find(i, names.end(), '\0');
      check(end != names.end());
      result.emplace_back(i, end);
      std::replace_if(result.back().begin(), result.back().end(),
                      [](char c) { return (c >= 0 && c < ' ') || c == 127; }, '?');
      i = end + 1;
    }
    return result;
  }

  mesh_file::Polygon_soup receive_soup()
  {
    mesh_file::Polygon_soup soup;
    const std::vector<mesh_file::Number_type> type = child_.receive<mesh_file::Number_type>();
    check(type.size() == 1);
    soup.coordinate_type = type[0] == mesh_file::Number_type::FLOAT32
      ? mesh_file::Number_type::FLOAT32 : mesh_file::Number_type::FLOAT64;
    soup.points = child_.receive<mesh_file::Point>();
    soup.corners = child_.receive<Index>();
    check(std::all_of(soup.corners.begin(), soup.corners.end(),
                      [&](Index v) { return v < soup.points.size(); }));
    soup.first_corner = child_.receive<Index>();
    check(!soup.first_corner.empty() && soup.first_corner.front() == 0 &&
          soup.first_corner.back() == soup.corners.size() &&
          std::is_sorted(soup.first_corner.begin(), soup.first_corner.end()));
    return soup;
  }

  // Returns a list that is empty or has an index below a bound, or null_index, for each element.
  std::vector<Index> receive_numbers(std::size_t number_of_elements, std::size_t bound)
  {
    std::vector<Index> result = child_.receive<Index>();
    check(result.empty() || result.size() == number_of_elements);
    check(std::all_of(result.begin(), result.end(), [&](Index i)
                      { return i < bound || i == mesh_file::null_index; }));
    return result;
  }

  // Receives the materials, and the images in the file, which get the names *0, *1 ...
  void receive_appearance(mesh_file::Polygon_soup& soup)
  {
    soup.texture_coordinates = child_.receive<mesh_file::Texture_point>();
    soup.texture_of_corner = receive_numbers(soup.corners.size(), soup.texture_coordinates.size());
    soup.normals = child_.receive<mesh_file::Point>();
    soup.normal_of_corner = receive_numbers(soup.corners.size(), soup.normals.size());
    const std::vector<std::string> names = receive_names(), materials = receive_names();
    check(names.size() == materials.size());
    for (std::size_t i = 0; i < names.size(); ++i)
      soup.materials.push_back({names[i], {}, materials[i]});
    soup.material_of_polygon = receive_numbers(soup.number_of_polygons(), names.size());
    check(soup.material_of_polygon.size() ==
          (soup.materials.empty() ? 0 : soup.number_of_polygons()));
    const std::vector<char> images = child_.receive<char>();
    std::size_t begin = 0;
    for (std::size_t end : child_.receive<std::size_t>()) {
      check(begin <= end && end <= images.size());
      soup.images.push_back({"*" + std::to_string(soup.images.size()),
                             begin == end ? nullptr : std::make_shared<const std::string>(
                               images.data() + begin, end - begin)});
      begin = end;
    }
  }

  static void add_properties(const std::vector<Mesh_instance>& instances, Scene& scene)
  {
    std::vector<double> nodes, meshes;
    nodes.reserve(scene.soup.number_of_polygons());
    meshes.reserve(scene.soup.number_of_polygons());
    for (const Mesh_instance& i : instances) {
      check(i.node < scene.node_names.size() && i.mesh < scene.mesh_names.size() &&
            nodes.size() <= i.end_of_polygons &&
            i.end_of_polygons <= scene.soup.number_of_polygons());
      nodes.resize(i.end_of_polygons, i.node);
      meshes.resize(i.end_of_polygons, i.mesh);
    }
    check(nodes.size() == scene.soup.number_of_polygons());
    scene.soup.group_of_polygon.assign(nodes.begin(), nodes.end());
    scene.soup.polygon_properties = {{"node", mesh_file::Number_type::INT32, std::move(nodes)},
                                     {"mesh", mesh_file::Number_type::INT32, std::move(meshes)}};
  }

public:
  explicit Scene_receiver(Child_process& child) : child_(child) {}

  Scene operator()()
  {
    const std::vector<char> bytes = child_.receive<char>();
    const std::string error(bytes.begin(), bytes.end());
    if (!error.empty()) {
      check(is_clear_sentence(error));
      throw std::runtime_error(error);
    }
    Scene scene;
    scene.soup = receive_soup();
    const std::vector<Mesh_instance> instances = child_.receive<Mesh_instance>();
    scene.node_names = receive_names();
    scene.mesh_names = receive_names();
    add_properties(instances, scene);
    receive_appearance(scene.soup);
    remove_infinite_corners(scene.soup); // a transformation may make them
    return scene;
  }
};

// Returns the limits for a file of this size. A file may name others, which also need memory.
inline Child_limits child_limits(double size_of_file, const Reading_limits& limits)
{
  const double physical_memory =
    static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  const double memory = (std::min)(
    4e9 + 64 * size_of_file, physical_memory / static_cast<double>(limits.number_of_jobs));
  return {static_cast<std::size_t>(memory), (std::min)(60 + size_of_file / 1e6, limits.seconds)};
}

// Reads a file by a function of a library, which may crash on damaged files, in a child process.
// The function takes a `Child_output`, and sends a scene or an error. Throws `std::runtime_error`.
template <class Send>
Scene read_scene_in_child(const std::string& name, const Reading_limits& limits, const Send& send)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(name, error);
  Child_process child(child_limits(error ? 0 : static_cast<double>(size), limits), send);
  return Scene_receiver(child)();
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_READ_SCENE_IN_CHILD_H
