// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_SEGMENTATIONS_H
#define MANUAL_FIGURES_SEGMENTATIONS_H

#include "../../benchmark/run_engine.h"
#include "Picture_book.h"
#include "Row_colors.h"

#include <CGAL/mesh_segmentation.h>

#include <boost/property_map/vector_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace manual_figures {

using CGAL::Spectral_segmentation::Segmentation_hierarchy;
using segmentation_benchmark::Engine_options;
using segmentation_benchmark::Execution;
using segmentation_benchmark::labels_of_run;
using segmentation_benchmark::labels_of_tree;

inline std::size_t number_of_segments(const Labels& labels)
{ return 1 + *std::max_element(labels.begin(), labels.end()); }

inline std::string count(std::size_t n, const std::string& things)
{ return std::to_string(n) + " " + (n == 1 ? things.substr(0, things.size() - 1) : things); }

inline Segmentation_hierarchy hierarchy(const Mesh& mesh, const Engine_options& options)
{ return segmentation_benchmark::run_engine(mesh, options, Execution::PARALLEL); }

inline Labels segment(const Mesh& mesh, const Engine_options& options)
{ return labels_of_run(hierarchy(mesh, options)); }

// Segmentations by the shape diameter function, from values that are computed once.
class Sdf_segmentation
{
  Mesh mesh_;
  Mesh::Property_map<Mesh::Face_index, double> values_;

public:
  explicit Sdf_segmentation(const Mesh& mesh)
    : mesh_(mesh), values_(mesh_.add_property_map<Mesh::Face_index, double>("f:sdf").first)
  { CGAL::sdf_values(mesh_, values_); }

  // Returns the segments with all defaults of CGAL.
  Labels by_default() const
  {
    boost::vector_property_map<std::size_t> ids(mesh_.number_of_faces());
    CGAL::segmentation_from_sdf_values(mesh_, values_, ids);
    return labels(ids);
  }

  // Uses Boost's maximum flow, like CGAL_DO_NOT_USE_BOYKOV_KOLMOGOROV_MAXFLOW_SOFTWARE. The default
  // code adds the flow of each expansion to the flow of the next one and ends early.
  Labels by_flow_of_boost(std::size_t number_of_clusters) const
  {
    typedef boost::property_map<Mesh, CGAL::vertex_point_t>::const_type Points;
    CGAL::internal::Surface_mesh_segmentation<
      Mesh, Kernel, Points, true, CGAL::Alpha_expansion_boost_compressed_sparse_row_tag>
      algorithm(mesh_, Kernel(), get(CGAL::vertex_point, mesh_));
    boost::vector_property_map<std::size_t> ids(mesh_.number_of_faces());
    const double default_lambda = 0.26;
    algorithm.partition(number_of_clusters, default_lambda, values_, ids, true);
    return labels(ids);
  }

private:
  Labels labels(const boost::vector_property_map<std::size_t>& ids) const
  {
    Labels result;
    for (Mesh::Face_index f : mesh_.faces())
      result.push_back(ids[f]);
    return result;
  }
};

// Adds a picture of a segmentation, with the number of segments in its caption.
inline void add_segments(Picture_book& book, const std::string& figure, const Named_mesh& shape,
                         Row_colors& colors, const Labels& labels, const std::string& caption)
{
  book.add(figure, {shape, caption + ": " + count(number_of_segments(labels), "segments"),
                    colors(labels)});
}

} // namespace manual_figures

#endif // MANUAL_FIGURES_SEGMENTATIONS_H
