// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_MESH_FILE_DECIMAL_NUMBERS_H
#define SEGMENT_MESH_MESH_FILE_DECIMAL_NUMBERS_H

#include <charconv>

// libc++ has these functions for integers only.
#ifndef __cpp_lib_to_chars
#define FMT_HEADER_ONLY
#include <fast_float/fast_float.h>
#include <fmt/format.h>
#endif

namespace mesh_file {

// Works like std::from_chars().
inline std::from_chars_result parse_decimal(const char* first, const char* last, double& number)
{
#ifdef __cpp_lib_to_chars
  return std::from_chars(first, last, number);
#else
  const fast_float::from_chars_result result = fast_float::from_chars(first, last, number);
  return {result.ptr, result.ec};
#endif
}

// Prints as few digits as distinguish the number from all others of its type, at most 32. Returns
// their end.
template <class Number>
char* print_decimal(char* digits, Number number)
{
#ifdef __cpp_lib_to_chars
  return std::to_chars(digits, digits + 32, number).ptr;
#else
  return fmt::format_to(digits, "{}", number);
#endif
}

} // namespace mesh_file

#endif // SEGMENT_MESH_MESH_FILE_DECIMAL_NUMBERS_H
