// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SPECTRAL_SEGMENTATION_PYTHON_PAGE_H
#define SPECTRAL_SEGMENTATION_PYTHON_PAGE_H

#include <pybind11/pybind11.h>

namespace python {

// Adds the functions that make the page of a mesh and a hierarchy.
void define_page(pybind11::module_& m);

} // namespace python

#endif // SPECTRAL_SEGMENTATION_PYTHON_PAGE_H
