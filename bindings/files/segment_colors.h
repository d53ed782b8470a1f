// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_SEGMENT_COLORS_H
#define SEGMENT_MESH_SEGMENT_COLORS_H

#include "Segmented_soup.h"

#include <boost/gil.hpp>
#include <boost/gil/extension/toolbox/color_spaces/hsv.hpp>
#include <boost/gil/extension/toolbox/color_spaces/lab.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <numeric>
#include <unordered_set>
#include <vector>

namespace segment_mesh {

using mesh_file::Rgb;

// The colors that people see who have all kinds of cones, or lack one, on linear RGB: Machado,
// Oliveira, Fernandes, "A Physiologically-based Model for Simulation of Color Vision Deficiency",
// 2009.
constexpr float visions[4][3][3] = {
  {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
  {{0.152286f, 1.052583f, -0.204868f}, {0.114503f, 0.786281f, 0.099216f},
   {-0.003882f, -0.048116f, 1.051998f}},
  {{0.367322f, 0.860646f, -0.227968f}, {0.280085f, 0.672501f, 0.047413f},
   {-0.011820f, 0.042940f, 0.968881f}},
  {{1.255528f, -0.076749f, -0.178779f}, {-0.078411f, 0.930809f, 0.147602f},
   {0.004733f, 0.691367f, 0.303900f}}};

// A color, and where each kind of people sees it in CIELAB, in which distance is difference for the
// eye.
struct Color
{
  Rgb rgb;
  std::array<std::array<float, 3>, 4> lab;

  explicit Color(const Rgb& given) : rgb(given)
  {
    const auto linear = [&](int i) {
      const float x = rgb[i] / 255.f;
      return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
    };
    const float r = linear(0), g = linear(1), b = linear(2);
    for (std::size_t k = 0; k < lab.size(); ++k) {
      boost::gil::rgb32f_pixel_t seen;
      for (int i = 0; i < 3; ++i) {
        const float* const row = visions[k][i];
        const float x = std::clamp(row[0] * r + row[1] * g + row[2] * b, 0.f, 1.f);
        seen[i] = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
      }
      boost::gil::lab32f_pixel_t result;
      boost::gil::color_convert(seen, result);
      lab[k] = {result[0], result[1], result[2]};
    }
  }
};

// Returns the difference of two colors for most people, or twice the least difference for people
// who lack a kind of cones, if this is less.
inline float difference(const Color& a, const Color& b)
{
  float result = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < a.lab.size(); ++k)
    result = (std::min)(result, (k == 0 ? 1 : 2) * std::hypot(a.lab[k][0] - b.lab[k][0],
                                                              a.lab[k][1] - b.lab[k][1],
                                                              a.lab[k][2] - b.lab[k][2]));
  return result;
}

// An endless sequence of colors. No two are equal, and those near each other in the sequence are
// far apart: the hue turns by the golden angle, saturation and value run through a sequence of low
// discrepancy.
class Color_sequence
{
  std::size_t next_ = 1;
  std::unordered_set<std::uint32_t> used_;

  static Color color(std::size_t i)
  {
    const auto fraction = [i](double step) { return std::fmod(static_cast<double>(i) * step, 1.); };
    const boost::gil::hsv32f_pixel_t hsv(
      static_cast<float>(fraction(0.6180339887498949)),
      static_cast<float>(0.35 + 0.55 * fraction(0.7548776662466927)),
      static_cast<float>(0.65 + 0.35 * fraction(0.5698402909980532)));
    boost::gil::rgb8_pixel_t rgb;
    boost::gil::color_convert(hsv, rgb);
    return Color({rgb[0], rgb[1], rgb[2]});
  }

public:
  Color operator()()
  {
    // Past some millions of colors there are hardly any new ones: then old ones must do.
    for (int attempt = 0; attempt < 100; ++attempt) {
      const Color c = color(next_++);
      if (used_.insert(c.rgb[0] << 16 | c.rgb[1] << 8 | c.rgb[2]).second)
        return c;
    }
    return color(next_++);
  }
};

// Gives each segment its own color, unlike those of its neighbors. `neighbors` are symmetric lists.
//
// Segments with many neighbors choose first. Each takes the first color that differs enough from
// its neighbors', among some that were passed over and some new ones, else the one that differs
// most. Colors passed over too often are dropped, so that the number of candidates is bounded.
inline std::vector<Rgb> segment_colors(const std::vector<std::vector<std::size_t> >& neighbors)
{
  const float enough = 45;
  const std::size_t number_of_candidates = 64;
  const std::size_t number_kept = 32;

  std::vector<std::size_t> order(neighbors.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b)
                   { return neighbors[a].size() > neighbors[b].size(); });

  Color_sequence sequence;
  std::deque<Color> candidates;
  std::vector<Color> colors(neighbors.size(), Color({}));
  std::vector<char> is_colored(neighbors.size(), 0);
  for (std::size_t segment : order) {
    std::size_t best = 0;
    float largest = -1;
    for (std::size_t i = 0; i < number_of_candidates && largest < enough; ++i) {
      if (i == candidates.size())
        candidates.push_back(sequence());
      float smallest = enough;
      for (std::size_t neighbor : neighbors[segment])
        if (is_colored[neighbor])
          smallest = (std::min)(smallest, difference(candidates[i], colors[neighbor]));
      if (smallest > largest) {
        largest = smallest;
        best = i;
      }
    }
    colors[segment] = candidates[best];
    is_colored[segment] = 1;
    candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(best));
    while (candidates.size() > number_kept)
      candidates.pop_front();
  }

  std::vector<Rgb> result;
  for (const Color& c : colors)
    result.push_back(c.rgb);
  return result;
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_SEGMENT_COLORS_H
