// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/segment_spectral_recursive.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Face_index Face;
typedef Mesh::Property_map<Face, int> Labels;
namespace params = CGAL::parameters;

// Reads a label for each face, one per line.
bool read_labels(const std::string& filename, const Mesh& mesh, Labels labels)
{
  std::ifstream in(filename);
  for (Face f : faces(mesh))
    in >> labels[f];
  return bool(in);
}

// Writes labels of which about a fifth is wrong: patches of the segments of the mesh get the label
// of another segment.
void write_noisy_labels(const std::string& filename, Mesh& mesh)
{
  Labels labels = mesh.add_property_map<Face, int>("f:right").first;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, labels);
  std::mt19937 random;
  for (std::size_t wrong = 0; wrong < mesh.number_of_faces() / 5;) {
    std::vector<Face> patch(1, Face(Mesh::size_type(random() % mesh.number_of_faces())));
    const int label = int(random() % n);
    for (std::size_t i = 0; i < patch.size() && i < mesh.number_of_faces() / 100; ++i, ++wrong) {
      labels[patch[i]] = label;
      for (Face g : CGAL::faces_around_face(mesh.halfedge(patch[i]), mesh))
        if (g != Mesh::null_face() && std::find(patch.begin(), patch.end(), g) == patch.end())
          patch.push_back(g);
    }
  }
  std::ofstream out(filename);
  for (Face f : faces(mesh))
    out << labels[f] << '\n';
  mesh.remove_property_map(labels);
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const std::string label_file = argc > 2 ? argv[2] : "noisy_labels.txt";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  if (argc <= 2)
    write_noisy_labels(label_file, mesh);
  Labels given = mesh.add_property_map<Face, int>("f:given").first;
  if (!read_labels(label_file, mesh, given)) {
    std::cerr << label_file << " has not a label for each face" << std::endl;
    return EXIT_FAILURE;
  }

  // Labels are features: they count as far as they agree with the shape and among each other.
  Labels segment_ids = mesh.add_property_map<Face, int>("f:segment").first;
  const std::size_t n = CGAL::segment_spectral_recursive(mesh, segment_ids,
                                                         params::face_feature_map(given));

  // A segment gets the label of most of its area.
  std::vector<std::map<int, double> > area_of_label(n);
  for (Face f : faces(mesh))
    area_of_label[segment_ids[f]][given[f]] += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  std::vector<int> label_of_segment;
  for (const auto& areas : area_of_label)
    label_of_segment.push_back(
      std::max_element(areas.begin(), areas.end(), [](const auto& a, const auto& b)
        { return a.second < b.second; })->first);

  std::size_t number_of_changes = 0;
  std::ofstream out("labels.txt");
  for (Face f : faces(mesh)) {
    const int label = label_of_segment[segment_ids[f]];
    number_of_changes += label != given[f];
    out << label << '\n';
  }
  std::cout << n << " segments; the labels of " << number_of_changes << " of "
            << mesh.number_of_faces() << " faces are changed" << std::endl;
  return out.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
