// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>

#include "mesh_models.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <boost/mpl/list.hpp>

#include <cstddef>
#include <stdexcept>

using namespace test_meshes;

namespace {

struct Double_traits : OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
  typedef OpenMesh::Vec3d Normal;
};

// The first two hold coordinates in single precision.
typedef boost::mpl::list<
  OpenMesh::PolyMesh_ArrayKernelT<>, OpenMesh::TriMesh_ArrayKernelT<>,
  OpenMesh::PolyMesh_ArrayKernelT<Double_traits>, OpenMesh::TriMesh_ArrayKernelT<Double_traits> >
  Models;

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(arrays_equal_the_arrays_of_a_surface_mesh, Graph, Models)
{ check_arrays_of_model<Graph>(); }

BOOST_AUTO_TEST_CASE(labels_equal_the_labels_of_a_surface_mesh)
{ check_labels_of_model<OpenMesh::PolyMesh_ArrayKernelT<> >(); }

BOOST_AUTO_TEST_CASE_TEMPLATE(deleted_faces_are_left_out, Graph, Models)
{
  const Soup whole = rounded(doll());
  Soup rest = whole;
  rest.triangles.clear();
  Graph graph;
  graph.request_face_status();
  graph.request_edge_status();
  graph.request_halfedge_status();
  graph.request_vertex_status();
  fill(graph, whole);
  for (std::size_t f = 0; f < whole.triangles.size(); ++f)
    if (f % 50 == 0)
      graph.delete_face(graph.face_handle(unsigned(f)), false);
    else
      rest.triangles.push_back(whole.triangles[f]);
  check_arrays(graph, mesh_of(rest));
}

BOOST_AUTO_TEST_CASE(a_face_that_is_not_a_triangle_is_refused)
{
  OpenMesh::PolyMesh_ArrayKernelT<> square;
  fill(square, {{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}, {{0, 1, 2, 3}}});
  BOOST_CHECK_THROW(labels_of_graph(square), std::invalid_argument);
}
