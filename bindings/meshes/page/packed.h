// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_PAGE_PACKED_H
#define SEGMENT_MESH_PAGE_PACKED_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace segment_mesh {

inline std::string base64(const std::string& bytes)
{
  const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve(bytes.size() / 3 * 4 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      result += i + k <= bytes.size() ? digits[three >> (18 - 6 * k) & 63] : '=';
  }
  return result;
}

// Integers as text, the shorter the smaller they are: 0, -1, 1, -2 ... become 0, 1, 2, 3 ..., each
// in bytes of 7 bits, the lowest first. The eighth bit states whether more bytes follow.
class Packed
{
  std::string bytes_;

public:
  void push_back(std::int64_t i)
  {
    std::uint64_t rest = static_cast<std::uint64_t>(i) << 1 ^ (i < 0 ? ~std::uint64_t(0) : 0);
    for (; rest > 127; rest >>= 7)
      bytes_ += static_cast<char>(rest | 128);
    bytes_ += static_cast<char>(rest);
  }

  std::string text() const { return base64(bytes_); }
};

// Packs the differences of each integer to the one `stride` before it.
template <class Integers>
std::string packed_differences(const Integers& integers, std::size_t stride = 1)
{
  Packed result;
  for (std::size_t i = 0; i < integers.size(); ++i)
    result.push_back(static_cast<std::int64_t>(integers[i]) -
                     (i < stride ? 0 : static_cast<std::int64_t>(integers[i - stride])));
  return result.text();
}

// Packs runs of equal integers: the integer, and how often it is repeated.
template <class Integers>
std::string packed_runs(const Integers& integers)
{
  Packed result;
  for (std::size_t begin = 0, end; begin < integers.size(); begin = end) {
    for (end = begin; end < integers.size() && integers[end] == integers[begin];)
      ++end;
    result.push_back(static_cast<std::int64_t>(integers[begin]));
    result.push_back(static_cast<std::int64_t>(end - begin));
  }
  return result.text();
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_PAGE_PACKED_H
