// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Expected: the values of the segment id map must be of an integer type

#include <CGAL/segment_spectral_recursive.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Face_index, double> Segment_ids;

std::size_t run(const Mesh& mesh, Segment_ids ids)
{ return CGAL::segment_spectral_recursive(mesh, ids); }
