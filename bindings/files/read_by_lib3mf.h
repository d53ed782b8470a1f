// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_READ_BY_LIB3MF_H
#define SEGMENT_MESH_READ_BY_LIB3MF_H

#include "Scene.h"

#include <stdexcept>
#include <string>

#if defined(SEGMENT_MESH_WITH_LIB3MF) && (defined(__unix__) || defined(__APPLE__))
#define SEGMENT_MESH_READS_BY_LIB3MF
#include "Lib3mf.h"
#include "read_scene_in_child.h"

#include <vector>
#endif

namespace segment_mesh {

#ifdef SEGMENT_MESH_READS_BY_LIB3MF

constexpr bool reads_by_lib3mf = true;

// Adds the triangles of an object to a scene, as a node without a name.
inline void append_object(const Lib3mf& object, Flat_scene& scene)
{
  typedef mesh_file::Index Index;
  DWORD number_of_points, number_of_triangles;
  object.call(NMR::lib3mf_meshobject_getvertexcount, &number_of_points);
  object.call(NMR::lib3mf_meshobject_gettrianglecount, &number_of_triangles);
  std::vector<NMR::MODELMESHVERTEX> points(number_of_points);
  std::vector<NMR::MODELMESHTRIANGLE> triangles(number_of_triangles);
  if (number_of_points > 0)
    object.call(NMR::lib3mf_meshobject_getvertices, points.data(), number_of_points, nullptr);
  if (number_of_triangles > 0)
    object.call(NMR::lib3mf_meshobject_gettriangleindices, triangles.data(), number_of_triangles,
                nullptr);
  const Index first = static_cast<Index>(scene.soup.points.size());
  for (const NMR::MODELMESHVERTEX& p : points)
    scene.soup.points.push_back({p.m_fPosition[0], p.m_fPosition[1], p.m_fPosition[2]});
  for (const NMR::MODELMESHTRIANGLE& t : triangles) {
    for (DWORD v : t.m_nIndices) {
      if (v >= number_of_points)
        throw std::runtime_error("a face has a corner that is no point");
      scene.soup.corners.push_back(first + v);
    }
    scene.soup.end_polygon();
  }
  const Index number = scene.instances.empty() ? 0 : scene.instances.back().node + 1;
  scene.instances.push_back(
    {number, number, static_cast<Index>(scene.soup.number_of_polygons())});
  Flat_scene::append_name("", scene.node_names);
  Flat_scene::append_name("", scene.mesh_names);
}

// Sends the objects that the build items show, or an error message. Runs in the child process.
inline void send_by_lib3mf(const std::string& name, Child_output output)
{
  try {
    const Lib3mf model = Lib3mf::model();
    model.made(NMR::lib3mf_model_queryreader, "3mf")
      .call(NMR::lib3mf_reader_readfromfileutf8, name.c_str());
    const Lib3mf merged = model.made(NMR::lib3mf_model_mergetomodel);
    const Lib3mf objects = merged.made(NMR::lib3mf_model_getmeshobjects);
    Flat_scene scene;
    scene.soup.coordinate_type = mesh_file::Number_type::FLOAT32;
    for (BOOL has_next; objects.call(NMR::lib3mf_resourceiterator_movenext, &has_next), has_next;)
      append_object(objects.made(NMR::lib3mf_resourceiterator_getcurrent), scene);
    send_scene(scene, output);
  }
  catch (const std::runtime_error& e) {
    send_error(is_clear_sentence(e.what()) ? e.what() : "it is not a valid file of its format",
               output);
  }
}

// Reads 3MF. Throws `std::runtime_error`.
inline Scene read_by_lib3mf(const std::string& name, const Reading_limits& limits = {})
{
  return read_scene_in_child(name, limits,
                             [&](Child_output output) { send_by_lib3mf(name, output); });
}

#else

constexpr bool reads_by_lib3mf = false;

inline Scene read_by_lib3mf(const std::string&, const Reading_limits& = {})
{ throw std::runtime_error("this build is without lib3mf"); }

#endif

} // namespace segment_mesh

#endif // SEGMENT_MESH_READ_BY_LIB3MF_H
