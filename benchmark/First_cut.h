// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENTATION_BENCHMARK_FIRST_CUT_H
#define SEGMENTATION_BENCHMARK_FIRST_CUT_H

#include "princeton_benchmark.h"

#include <CGAL/segment_spectral_recursive.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

namespace segmentation_benchmark {

namespace internal = CGAL::Spectral_segmentation::internal;
using CGAL::Spectral_segmentation::Method;

// The stages of the first cut of a mesh, which is one part then. Each goes on from what the stages
// before it have left, and can be run again and again.
class First_cut
{
  const Mesh& mesh_;
  Method method_;
  internal::Options options_;
  internal::Part part_;
  internal::Judged_mesh judged_mesh_;
  std::vector<internal::Index> references_;
  internal::Sample_faces samples_;
  std::vector<internal::Line> lines_;
  std::optional<internal::Judge_of_part> judge_;
  std::vector<internal::Cut> cuts_;

public:
  First_cut(const Mesh& mesh, Method method)
    : mesh_(mesh), method_(method),
      options_(method == Method::CALIBRATED ? internal::calibrated_options() : internal::Options())
  {
    const CGAL::Sequential_tag tag;
    initialize(tag);
    std::size_t number_of_components;
    internal::connected_components(graph(), number_of_components);
    if (number_of_components != 1)
      throw std::invalid_argument("the mesh is not connected");
    part_.faces.resize(graph().number_of_faces());
    std::iota(part_.faces.begin(), part_.faces.end(), internal::Index(0));
    judged_mesh_ = internal::judged_mesh(graph(), options_);
    sample(tag);
    order(tag);
    search_lines(tag);
  }

  Method method() const { return method_; }
  const internal::Face_dual_graph& graph() const { return part_.graph; }

  template <class ConcurrencyTag>
  void initialize(ConcurrencyTag)
  {
    part_.graph = internal::initialize<ConcurrencyTag>(
      mesh_, std::vector<Mesh::Face_index>(mesh_.faces().begin(), mesh_.faces().end()),
      mesh_.points(), CGAL::Exact_predicates_inexact_constructions_kernel(), options_,
      [] { return true; });
  }

  template <class ConcurrencyTag>
  void sample(ConcurrencyTag)
  {
    internal::Shape_contexts contexts = internal::shape_contexts<ConcurrencyTag>(
      graph(), internal::farthest_face_from_center(graph()), options_.number_of_reference_faces,
      [] {});
    samples_ = internal::sample_faces(contexts);
    references_.swap(contexts.references);
  }

  template <class ConcurrencyTag>
  void order(ConcurrencyTag)
  { lines_ = internal::orderings<ConcurrencyTag>(graph(), references_, samples_, options_); }

  template <class ConcurrencyTag>
  void search_lines(ConcurrencyTag)
  {
    judge_.emplace(part_, judged_mesh_, options_);
    cuts_ = internal::cuts_along<ConcurrencyTag>(
      graph(), lines_, options_.minimum_segment_size * judged_mesh_.area, options_, *judge_);
  }

  template <class ConcurrencyTag>
  void refine(ConcurrencyTag) const
  {
    std::vector<internal::Cut> cuts = cuts_;
    internal::refine<ConcurrencyTag>(graph(), options_.number_of_refined_candidates, *judge_, cuts);
  }
};

} // namespace segmentation_benchmark

#endif // SEGMENTATION_BENCHMARK_FIRST_CUT_H
