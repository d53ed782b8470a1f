// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/// \file
/// Computes the pictures of the manual; draw_figures.py then draws them.

#include "Picture_book.h"
#include "experiment_figures.h"
#include "feature_figures.h"
#include "level_figures.h"
#include "method_figures.h"
#include "parameter_figures.h"

#include <CGAL/Surface_mesh/IO/OFF.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>

using namespace manual_figures;

// Reads each mesh once.
class Meshes
{
  std::filesystem::path folder_;
  std::map<std::string, Named_mesh> meshes_;

public:
  explicit Meshes(const std::filesystem::path& folder) : folder_(folder) {}

  const Named_mesh& operator[](const std::string& name)
  {
    const auto [position, is_new] = meshes_.insert({name, {name, Mesh()}});
    const std::string file = (folder_ / (name + ".off")).string();
    if (is_new && !CGAL::IO::read_OFF(file, position->second.mesh))
      throw std::runtime_error("cannot read " + file);
    return position->second;
  }
};

void draw_gallery(Picture_book& book, Meshes& meshes)
{
  for (const char* name :
       {"camel", "bear", "triceratops", "elk", "diplodocus", "homer", "bones", "man"}) {
    Row_colors colors;
    add_segments(book, "gallery", meshes[name], colors,
                 segment(meshes[name].mesh, Engine_options()), name);
  }
}

void draw_paper_gallery(Picture_book& book, Meshes& meshes)
{
  for (const char* name : {"blobby", "cow", "triceratops", "dino", "diplodocus", "mushroom",
                           "fandisk_large", "camel", "bunny00", "armadillo"}) {
    Row_colors colors;
    add_segments(book, "paper_gallery", meshes[name], colors,
                 segment(meshes[name].mesh, Engine_options::zhang_liu_2005()), name);
  }
}

void draw_all(Picture_book& book, Meshes& meshes)
{
  draw_gallery(book, meshes);
  draw_paper_gallery(book, meshes);
  draw_dual_graph(book, meshes["eight"]);
  draw_contexts(book, meshes["homer"]);
  draw_embedding(book, meshes["elephant"]);
  const Kernel::Point_3 right(-0.2, -0.1, 0.33), left(0.2, -0.1, 0.33); // on the belly
  draw_samples_and_line(book, meshes["bear"], {right, left});
  draw_tree(book, meshes["triceratops"]);
  draw_levels(book, meshes["elephant"]);
  draw_parameters(book, meshes["triceratops"], meshes["elephant"], meshes["camel"]);
  draw_components(book, meshes["bones"]);
  draw_equipment(book, meshes["camel"], meshes["bear"]);
  draw_seeds(book, meshes["camel"]);
  draw_features(book, meshes["elephant"]);
  draw_methods(book, {&meshes["elephant"], &meshes["camel"], &meshes["homer"], &meshes["femur"]});
  draw_sdf_comparison(book, {&meshes["elephant"], &meshes["triceratops"], &meshes["camel"],
                             &meshes["homer"]});
  draw_samplings(book, meshes["bear"]);
  draw_clusterings(book, meshes["bear"], 6);
  draw_clusterings(book, meshes["hand"], 6);
}

int main(int argc, char** argv)
{
  if (argc != 3) {
    std::cerr << "usage: manual_figures FOLDER_OF_MESHES OUTPUT_FOLDER\n";
    return EXIT_FAILURE;
  }
  try {
    Meshes meshes(argv[1]);
    Picture_book book(argv[2]);
    draw_all(book, meshes);
    book.write_list();
  }
  catch (const std::exception& e) {
    std::cerr << "manual_figures: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
