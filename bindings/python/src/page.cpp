// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The page of `segment_mesh --html`, by the code of the tool.

#include "page.h"

#include "python_lock.h"

#define SEGMENT_MESH_WITH_PAGE
#include <meshes/page/write_page.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

// The files that the page is made of, by their names. Python sets them once, before the first page.
std::map<std::string, std::string> page_sources;

} // namespace

const std::string& segment_mesh::page_source(const std::string& name)
{ return page_sources.at(name); }

namespace python {

using segment_mesh::Input;
using segment_mesh::Segmentation_hierarchy;

static py::bytes page(const Input& input, const Segmentation_hierarchy& h, const std::string& name,
                      std::size_t number_of_segments, bool is_salience_probability)
{
  segment_mesh::Page_options o;
  o.name = name;
  o.number_of_segments =
    std::clamp(number_of_segments, h.number_of_roots(), h.number_of_segments());
  o.is_salience_probability = is_salience_probability;
  std::ostringstream out;
  {
    const No_python_lock no_python_lock;
    segment_mesh::write_page(out, segment_mesh::page_data(input, h, o));
  }
  return out.str();
}

void define_page(py::module_& m)
{
  m.def("set_page_sources", [](const std::map<std::string, py::bytes>& sources) {
    for (const auto& [name, bytes] : sources)
      page_sources[name] = bytes;
  });
  m.def("page", page);
}

} // namespace python
