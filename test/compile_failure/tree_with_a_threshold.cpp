// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Expected: the labels of a Segmentation_hierarchy depend on no named parameter but face_index_map

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Face_index, int> Segment_ids;
namespace params = CGAL::Spectral_segmentation::parameters;

std::size_t run(const Mesh& mesh, Segment_ids ids,
                const CGAL::Spectral_segmentation::Segmentation_hierarchy& tree)
{ return tree.segment_by_number(mesh, ids, 3, params::salience_threshold(0.9)); }
