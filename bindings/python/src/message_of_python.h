// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_MESSAGE_OF_PYTHON_H
#define SPECTRAL_SEGMENTATION_PYTHON_MESSAGE_OF_PYTHON_H

#include <cctype>
#include <cstddef>
#include <exception>
#include <string>

namespace python {

// Returns the message of an exception of the library in the words of the package: without the name
// of the function or class of C++, and with the parameters of Python.
inline std::string message_of_python(const std::exception& error)
{
  std::string result = error.what();
  std::size_t end = 0;
  while (end < result.size() && (std::isalpha(static_cast<unsigned char>(result[end])) ||
                                 result[end] == '_'))
    ++end;
  if (result.find('_') < end && result.compare(end, 2, ": ") == 0)
    result.erase(0, end + 2);

  static const char* const words[][2] = {{"edge_is_constrained_map", "constrained_edges"},
                                         {"edge_is_uncuttable_map", "uncuttable_edges"},
                                         {"face_feature_map", "features"},
                                         {"true with zhang_liu_2005()",
                                          "True with the method 'paper'"},
                                         {"the faces ", "the triangles "}};
  for (const auto& word : words)
    if (const std::size_t at = result.find(word[0]); at != result.npos)
      result.replace(at, std::string(word[0]).size(), word[1]);
  return result;
}

} // namespace python

#endif // SPECTRAL_SEGMENTATION_PYTHON_MESSAGE_OF_PYTHON_H
