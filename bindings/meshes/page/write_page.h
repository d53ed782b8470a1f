// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_PAGE_WRITE_PAGE_H
#define SEGMENT_MESH_PAGE_WRITE_PAGE_H

#include "../Failure.h"
#include "page_data.h"

#include <cstddef>
#include <functional>
#include <ostream>
#include <sstream>
#include <string>

namespace segment_mesh {

// Returns the content of a file of this folder, or of three.js, by its name. CMake writes this
// function.
const std::string& page_source(const std::string& name);

// Returns a text in which a browser finds no tag.
inline std::string escaped(const std::string& text)
{
  std::string result;
  for (char c : text)
    result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

// Returns JSON for the element `script`, which `</script` would end. Replaces bytes that are no
// UTF-8.
inline std::string json_of_script(const nlohmann::ordered_json& data)
{
  std::string result;
  for (char c : data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
    result += c == '<' ? "\\u003c" : std::string(1, c);
  return result;
}

// Returns a module without its lines that import, for a page that has all modules in one.
inline std::string without_imports(const std::string& module)
{
  std::istringstream in(module);
  std::string result;
  for (std::string line; std::getline(in, line);)
    if (line.compare(0, 7, "import ") != 0)
      result += line + '\n';
  return result;
}

// Writes a template with each `{{name}}` replaced by a text.
inline void write_filled(std::ostream& out, const std::string& page,
                         const std::function<std::string(const std::string&)>& text)
{
  std::size_t written = 0;
  for (std::size_t begin; (begin = page.find("{{", written)) != std::string::npos;) {
    const std::size_t end = page.find("}}", begin);
    out << page.substr(written, begin - written) << text(page.substr(begin + 2, end - begin - 2));
    written = end + 2;
  }
  out << page.substr(written);
}

inline void check_page()
{
#ifndef SEGMENT_MESH_WITH_PAGE
  throw Failure(Status::USAGE, "this build writes no page: it needs three.js (Debian package "
                               "libjs-three) at build time");
#endif
}

// Writes the page as one file that needs no other.
inline void write_page([[maybe_unused]] std::ostream& out,
                       [[maybe_unused]] const nlohmann::ordered_json& data)
{
#ifdef SEGMENT_MESH_WITH_PAGE
  write_filled(out, page_source("page.html"), [&](const std::string& name) {
    if (name == "title")
      return escaped(data["name"]);
    if (name == "data")
      return json_of_script(data);
    return without_imports(page_source(name));
  });
#endif
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_PAGE_WRITE_PAGE_H
