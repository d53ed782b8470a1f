<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<!-- The names of CGAL that the manual links to, below https://doc.cgal.org/latest/ -->
<tagfile>
  <compound kind="class"><name>FaceListGraph</name><filename>BGL/classFaceListGraph.html</filename></compound>
  <compound kind="class"><name>VertexListGraph</name><filename>BGL/classVertexListGraph.html</filename></compound>
  <compound kind="class"><name>Kernel</name><filename>Kernel_23/classKernel.html</filename></compound>
  <compound kind="struct"><name>CGAL::Sequential_tag</name><filename>STL_Extension/structCGAL_1_1Sequential__tag.html</filename></compound>
  <compound kind="struct"><name>CGAL::Parallel_tag</name><filename>STL_Extension/structCGAL_1_1Parallel__tag.html</filename></compound>
  <compound kind="struct"><name>CGAL::Parallel_if_available_tag</name><filename>STL_Extension/structCGAL_1_1Parallel__if__available__tag.html</filename></compound>
  <compound kind="class"><name>CGAL::Surface_mesh</name><filename>Surface_mesh/classCGAL_1_1Surface__mesh.html</filename></compound>
  <compound kind="class"><name>CGAL::Polyhedron_3</name><filename>Polyhedron/classCGAL_1_1Polyhedron__3.html</filename></compound>
  <compound kind="struct"><name>CGAL::Face_filtered_graph</name><filename>BGL/structCGAL_1_1Face__filtered__graph.html</filename></compound>
  <compound kind="page"><name>packages</name><title>Package Overview</title><filename>Manual/packages.html</filename>
    <docanchor file="Manual/packages.html">PkgAABBTree</docanchor>
    <docanchor file="Manual/packages.html">PkgBGL</docanchor>
    <docanchor file="Manual/packages.html">PkgBoxIntersectionD</docanchor>
    <docanchor file="Manual/packages.html">PkgPolygonMeshProcessing</docanchor>
    <docanchor file="Manual/packages.html">PkgTriangulation2</docanchor>
  </compound>
</tagfile>
