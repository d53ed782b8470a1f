// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MANUAL_FIGURES_ROW_COLORS_H
#define MANUAL_FIGURES_ROW_COLORS_H

#include "files/segment_colors.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace manual_figures {

typedef std::vector<std::size_t> Labels; // the segment of each face

// Colors for a row of segmentations of one mesh: a segment keeps the color of the segment of the
// previous picture with which it has the most faces in common. Colors within a picture differ.
class Row_colors
{
  segment_mesh::Color_sequence sequence_;
  std::vector<segment_mesh::Rgb> palette_;
  Labels before_; // one palette index per face

  std::map<std::size_t, std::size_t> color_of_segments(const Labels& labels) const
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> common; // segment, color: faces
    for (std::size_t f = 0; f < before_.size(); ++f)
      ++common[{labels[f], before_[f]}];
    std::vector<std::pair<std::size_t, std::pair<std::size_t, std::size_t> > > largest;
    for (const auto& c : common)
      largest.push_back({c.second, c.first});
    std::stable_sort(largest.begin(), largest.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::map<std::size_t, std::size_t> color;
    std::set<std::size_t> used;
    for (const auto& [faces, pair] : largest)
      if (color.count(pair.first) == 0 && used.insert(pair.second).second)
        color[pair.first] = pair.second;
    std::size_t next = 0;
    for (std::size_t segment : std::set<std::size_t>(labels.begin(), labels.end()))
      if (color.count(segment) == 0) {
        while (used.count(next) != 0)
          ++next;
        color[segment] = next;
        used.insert(next);
      }
    return color;
  }

public:
  // Returns the color of each face.
  std::vector<segment_mesh::Rgb> operator()(const Labels& labels)
  {
    const std::map<std::size_t, std::size_t> color = color_of_segments(labels);
    Labels now;
    std::vector<segment_mesh::Rgb> result;
    for (std::size_t label : labels) {
      now.push_back(color.at(label));
      while (palette_.size() <= now.back())
        palette_.push_back(sequence_().rgb);
      result.push_back(palette_[now.back()]);
    }
    before_ = std::move(now);
    return result;
  }
};

} // namespace manual_figures

#endif // MANUAL_FIGURES_ROW_COLORS_H
