// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/draw_surface_mesh.h>
#include <CGAL/segment_spectral_recursive.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Face_index Face;
typedef Mesh::Property_map<Face, CGAL::IO::Color> Color_map;

#if CGAL_VERSION_NR < CGAL_VERSION_NUMBER(6, 0, 0)
// Shows a mesh in these colors. CGAL::draw() of CGAL 5 gives colors of its own to the faces.
void show(const Mesh& mesh, Color_map color)
{
  if (qEnvironmentVariableIsSet("CGAL_TEST_SUITE"))
    return;
  CGAL::Qt::init_ogl_context(4, 3);
  int argc = 1;
  const char* argv[] = {"draw_segments", nullptr};
  QApplication application(argc, const_cast<char**>(argv));
  CGAL::SimpleFaceGraphViewerQt viewer(application.activeWindow(), mesh, "Segments", false,
                                       [&](const Mesh&, Face f) { return color[f]; });
  viewer.set_use_mono_color(false);
  viewer.show();
  application.exec();
}
#else
void show(const Mesh& mesh, Color_map)
{ CGAL::draw(mesh, "Segments"); }
#endif

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto segment_ids = mesh.add_property_map<Face, std::size_t>("f:segment").first;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids);
  std::cout << n << " segments" << std::endl;

  // Hues differ by the golden angle. Files and viewers know the property of this name.
  Color_map color = mesh.add_property_map<Face, CGAL::IO::Color>("f:color").first;
  for (Face f : faces(mesh))
    color[f].set_hsv(std::fmod(137.508 * segment_ids[f], 360), 60, 95);
  if (!CGAL::IO::write_polygon_mesh("segments.ply", mesh))
    return EXIT_FAILURE;
  show(mesh, color);
  return EXIT_SUCCESS;
}
